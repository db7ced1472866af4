-- SPDX-License-Identifier: MIT
-- A machine on a fake robot among blocks, with these parameters of a scene. Gives the machine, the robot, and run(does, each), which
-- lets the machine do something to its end, calls `each` after every step, and returns its results.

local FakeRobot = require 'fake_robot'
local Machine = require 'machine'

return function(blocks, params)
   local fake = FakeRobot.new(blocks)
   fake.robot.params = params or fake.robot.params
   local machine = Machine.new(fake.robot)
   local function run(does, each)
      local out
      machine:start(function() out = table.pack(does()) end)
      for _ = 1, 5000 do
         if not machine:step() then return table.unpack(out) end
         fake:step()
         if each then each() end
      end
      error('it does not end')
   end
   return machine, fake, run
end
