-- SPDX-License-Identifier: MIT
-- Drives `params.ahead` m straight on from where it begins, round what is in the way, for as long as
-- it takes.

local Machine = require 'machine'
local Navigation = require 'motion.navigation'

local machine

function init()
   machine = Machine.new(robot)
   local navigation, process = Navigation.new(machine, {}), machine.process
   machine:start(function()
      process:enter('drive')
      while not navigation:straight_to(robot.params.ahead, 0) do process:enter('drive again') end
      process:enter('there')
   end)
end

function step() machine:step() end
