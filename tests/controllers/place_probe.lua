-- SPDX-License-Identifier: MIT
-- Picks up the dark block ahead, and puts it on or in front of the lit one. Parameters: where
-- ('raise' or 'extend'), level (optional).

local robotics = require 'robotics'
local handling = require 'handling'

local function dark(block) return block.level == 0 and block.colour == 0 end
-- Of a column the highest block that is seen.
local function lit(block)
   if block.colour ~= 3 then return false end
   for _, other in ipairs(robotics.blocks()) do
      local dx, dy = other.x - block.x, other.y - block.y
      if dx * dx + dy * dy < 0.02 ^ 2 and other.z > block.z + 0.01 then return false end
   end
   return true
end

local function main()
   local block = handling.search(dark)
   local good, problem = block and handling.pick_up(block)
   if good then
      handling.go_by(-0.15)
      local base = handling.search(lit)
      if base then
         good, problem = handling.place(base, robot.params.where,
                                        { colour = 1, level = robot.params.level })
      end
   end
   log(good and 'done' or 'failed: ' .. tostring(problem))
end

function init() handling.start(main) end
function step() handling.step() end
