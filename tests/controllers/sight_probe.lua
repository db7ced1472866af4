-- SPDX-License-Identifier: MIT
-- Stands before a column of `levels` blocks, their middle `ahead` of it, and moves the lift up:
-- how often a block was seen, and how often it was in no place where one is.

local Machine = require 'machine'
local machine
local seen, astray = 0, 0

function init()
   machine = Machine.new(robot)
end

function step()
   machine:sense()
   local time = machine.odometry.time
   robot.lift_system.set_position(0.05 + 0.085 * math.min(1, time / 40))
   for _, known in ipairs(machine.tracker.tracks) do
      if known.time == time then
         local off = math.sqrt((known.x - robot.params.ahead) ^ 2 + known.y ^ 2)
         local there = known.level and known.level < robot.params.levels and off < 0.012
         seen, astray = seen + 1, astray + (there and 0 or 1)
      end
   end
   if time > 45 then log(string.format('seen %d, astray %d', seen, astray)) end
end
