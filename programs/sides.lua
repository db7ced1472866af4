-- SPDX-License-Identifier: MIT
-- Which side of the structure a robot works from, and how it goes to another.
--
-- `params.sides`, '+x +y', binds a robot to some of the task's sides, which it then has for itself.
-- One that is alone has all of them. Any other robot shares them: it goes to the next side only where it
-- finds that nobody works there.

local robotics = require 'robotics'
local avoidance = require 'avoidance'
local handling = require 'handling'
local lattice = require 'lattice'
local travel = require 'travel'
local sides = {}

local EDGE = 0.40              -- m, from a side's middle, where one is in nobody's way
local INNER_EDGE = 0.30        -- m, likewise, from where one sees robots up to the middle
local EDGE_LOOK = 0.3          -- rad, between looks from there
local AT_ROW = 12              -- s, that others are out of sight at the far rows
local WITHDRAWN = 0.28         -- m, from the structure, where a robot waits that has nothing to do

local task
local way_round    -- to the next side: 1 to the left, -1 to the right

-- Those of a task's sides that the robot is bound to, or all.
function sides.own(of)
   local out, first = {}, of.turns and lattice.SIDES[robot.params.side or of.sides[1]] or 0
   for name in string.gmatch(robot.params.sides or '', '%S+') do
      -- where the rules hold in every turn, a robot's first side is its +x
      for other, index in pairs(lattice.SIDES) do
         if index == ((lattice.SIDES[name] or 0) - first) % 4 then table.insert(out, other) end
      end
   end
   return #out > 0 and out or of.sides
end

function sides.start(with)
   task, way_round = with, 1
end

-- Whether others may work on the robot's sides.
function sides.are_shared()
   return task.delay > 0 and not robot.params.sides
end

-- As far from the structure's middle as the cache leaves room.
local function room_before_cache()
   return (lattice.cache_way or math.huge) - travel.BEFORE_CACHE
end

-- Out of the others' way, as far as the cache leaves room.
function sides.withdraw()
   local known = lattice.known
   local away = math.min(known.reach + WITHDRAWN, room_before_cache())
   local more = away - lattice.apart(known, robotics.pose)
   if more > 0 then handling.back_off(more) end
end

-- A place so far from the structure's middle, on the side that robots face with `heading`.
local function place_on(heading, away)
   return robotics.out_of({ x = lattice.known.x, y = lattice.known.y, yaw = heading }, -away, 0)
end

-- Whether someone works on the side that robots face with `heading`: who does so is somewhere
-- between the structure and the cache, and is seen or met by one that comes in across, from the
-- left edge (1) or the right one (-1).
local function is_worked(heading, edge)
   local across = { yaw = robotics.wrap(heading - edge * math.pi / 2) }
   across.x, across.y = place_on(heading, (lattice.known.reach + lattice.cache_way) / 2)
   local start, met = robotics.time, false
   local function meets()
      met = met or robotics.range('front') or handling.meets(1)
      return met
   end
   if not travel.to(robotics.out_of(across, -EDGE, 0)) then return true end
   handling.turn_to(across.yaw)
   handling.follow(across, -INNER_EDGE, 0.06, meets)
   for step = -2, 2 do
      if not meets() then handling.turn_to(across.yaw + step * EDGE_LOOK, avoidance.LOOK_RIM) end
   end
   if not meets() then handling.turn_to(across.yaw) end
   return handling.wait_until(meets, AT_ROW) or
          #avoidance.strangers(across.x, across.y, INNER_EDGE, start) > 0
end

-- The next of the robot's sides on the way round.
local function next_side()
   local all, here = {}, 1
   for _, name in ipairs(task.sides) do table.insert(all, lattice.SIDES[name]) end
   table.sort(all)
   for i, side in ipairs(all) do
      if side == lattice.side then here = i end
   end
   return all[(here - 1 + way_round) % #all + 1]
end

-- To the next side, whose cache is expected to be as far away as the last one. Where somebody works
-- there, back to where it was, and the other way round the next time. Says whether it has changed.
function sides.change()
   local side, cache_way = next_side(), lattice.cache_way
   local free = not (sides.are_shared() and cache_way and is_worked(lattice.heading_of(side), way_round))
   if free then
      lattice.side = side
      if cache_way then
         local x, y = place_on(lattice.heading_of(side), cache_way)
         lattice.cache = { x = x, y = y }
      end
   else
      way_round = -way_round
      handling.back_off(EDGE - INNER_EDGE)
   end
   local away = math.min(lattice.known.reach + travel.CLEAR_OF, room_before_cache())
   travel.to(place_on(lattice.heading_of(lattice.side), away))
   return free
end

return sides
