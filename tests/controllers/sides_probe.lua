-- SPDX-License-Identifier: MIT
-- Goes from side +x of a structure, 0.3 m ahead, to its next side, and says what came of it.
-- Parameters: side ('+x'), sides.

local Machine = require 'machine'
local Navigation = require 'motion.navigation'
local SideAllocation = require 'mission.side_allocation'
local StructureMap = require 'mission.structure_map'
local machine

local function main()
   local task = { delay = 30, transport = 4, sides = { '+x', '+y', '-x', '-y' } }
   task.sides = SideAllocation.own(robot.params, task)
   local map = StructureMap.new(robot, machine.odometry, machine.tracker, task)
   local sides = SideAllocation.new(machine, map, Navigation.new(machine, map), task)
   machine.process:wait(0.4)
   map.known = { x = 0.3, y = 0, reach = 0.03, yaw = 0, origin = { x = 0.3, y = 0 } }
   map.first = { u = 0, v = 0 }
   map.side, map.cache, map.cache_way = StructureMap.SIDES['+x'], { x = -0.2, y = 0 }, 0.5
   local changed = sides:change()
   machine.process:wait(1)
   log(string.format('changed %s, side %s, cache at %.2f %.2f', changed, map:side_name(),
                     map.cache.x, map.cache.y))
end

function init()
   machine = Machine.new(robot)
   machine:start(main)
end
function step() machine:step() end
