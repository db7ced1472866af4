-- SPDX-License-Identifier: MIT
-- Picks up the dark block ahead, and puts it on or in front of the lit one. Parameters: where
-- ('raise' or 'extend'), level (optional).

local Machine = require 'machine'
local machine

local function dark(block) return block.level == 0 and block.colour == 0 end
-- Of a column the highest block that is seen.
local function lit(block)
   if block.colour ~= 3 then return false end
   for _, other in ipairs(machine.tracker:blocks()) do
      local dx, dy = other.x - block.x, other.y - block.y
      if dx * dx + dy * dy < 0.02 ^ 2 and other.z > block.z + 0.01 then return false end
   end
   return true
end

local function main()
   local block = machine.search:find(dark)
   local good, problem = block and machine.pickup:pick_up(block)
   if good then
      machine.path:go_by(-0.15)
      local base = machine.search:find(lit)
      if base then
         good, problem = machine.placement:place(base, robot.params.where,
                                                 { colour = 1, level = robot.params.level })
      end
   end
   log(good and 'done' or 'failed: ' .. tostring(problem))
end

function init()
   machine = Machine.new(robot)
   machine:start(main)
end
function step() machine:step() end
