-- SPDX-License-Identifier: MIT
-- Which side of the structure a robot works from, and how it goes to another.
--
-- `params.sides`, '+x +y', binds a robot to some of the task's sides, which it then has for itself.
-- One that is alone has all of them. Any other robot shares them: it goes to the next side only where it
-- finds that nobody works there.

local geometry = require 'common.geometry'
local Navigation = require 'motion.navigation'
local UnexplainedReturns = require 'perception.unexplained_returns'
local StructureMap = require 'mission.structure_map'

local EDGE = 0.40              -- m, from a side's middle, where one is in nobody's way
local INNER_EDGE = 0.30        -- m, likewise, from where one sees robots up to the middle
local BEFORE_EDGE = 0.26       -- m, likewise from there, where one sees whoever looks across already and has its back to one
local ON_THE_WAY = 0.15        -- m, farther off than that, where whoever is in the way is on another side
local EDGE_LOOK = 0.3          -- rad, between looks from there
local CARRIED = 0.30           -- m, from half way, of a block in the hand of who works there
local AT_ROW = 12              -- s, that others are out of sight at the far rows
local COMES_IN = 8             -- s more, from the right edge: in which one that has looked from the left edge has come in
local WITHDRAWN = 0.28         -- m, from the structure, where a robot waits that has nothing to do

-- way_round: to the next side, 1 to the left, -1 to the right. wanted: index of the side to which it is to go next, if that
-- is another. worked: of the one where it found somebody at work, if that was the last that it went to.
local SideAllocation = {}
SideAllocation.__index = SideAllocation

function SideAllocation.new(machine, map, navigation, task)
   return setmetatable({
      robot = machine.robot, odometry = machine.odometry, process = machine.process,
      ranges = machine.ranges, returns = machine.returns, clearance = machine.clearance,
      path = machine.path, lift = machine.lift, map = map, navigation = navigation, task = task, way_round = 1, taken = {},
   }, SideAllocation)
end

-- Those of a task's sides that a robot with these parameters is bound to, or all.
function SideAllocation.own(params, task)
   local SIDES = StructureMap.SIDES
   local out, first = {}, task.turns and SIDES[params.side or task.sides[1]] or 0
   for name in string.gmatch(params.sides or '', '%S+') do
      -- where the rules hold in every turn, a robot's first side is its +x
      for other, index in pairs(SIDES) do
         if index == ((SIDES[name] or 0) - first) % 4 then table.insert(out, other) end
      end
   end
   return #out > 0 and out or task.sides
end

-- Whether others may work on the robot's sides.
function SideAllocation:are_shared()
   return self.task.delay > 0 and not self.robot.params.sides
end

-- Whether others may work on its sides, and there is a robot for each: `params.crew` says how many there are.
function SideAllocation:are_manned()
   return self:are_shared() and (tonumber(self.robot.params.crew) or math.huge) >= #self.task.sides
end

-- Whether each of the task's sides has a robot: where all could do but the same, they take turns.
function SideAllocation:take_turns()
   local crew = tonumber(self.robot.params.crew)
   return self.task.delay > 0 and crew ~= nil and crew >= #self.task.all_sides
end

-- Whether others may work on its sides, and robots are fewer than sides, so that each goes from one side to another.
function SideAllocation:are_fewer()
   return self:are_shared() and not self:are_manned()
end

-- As far from the face of the side of this index as its cache leaves room.
function SideAllocation:room_before_cache(index)
   return self.map:room_to_cache(index) - Navigation.BEFORE_CACHE
end

-- How far from that face a robot is out of the others' way, as far as the cache leaves room.
function SideAllocation:withdrawn(index)
   return math.min(WITHDRAWN, self:room_before_cache(index))
end

-- Out of the others' way; back to its side, if it has gone beside the outermost rows.
function SideAllocation:withdraw()
   local map, pose = self.map, self.odometry.pose
   if not map.side then return end
   if not map:is_on_side(map.side, pose) then return self:stand_back() end
   local more = self:withdrawn(map.side) + geometry.into(map:face_of(map.side), pose.x, pose.y)
   if more > 0 then self.path:back_off(more) end
end

-- Likewise, before the middle of the robot's side, which it faces.
function SideAllocation:stand_back()
   local map = self.map
   if not map.side or not map.known then return end
   self.navigation:to(self:place_before(map.side, self:withdrawn(map.side)))
   -- on the way it may have been seen to lie otherwise, or lost
   if map.side and map.known then self.path:turn_to(map:heading_of(map.side)) end
end

-- A place so far before the face of the side of this index.
function SideAllocation:place_before(index, away)
   return geometry.out_of(self.map:face_of(index), -away, 0)
end

-- Whether someone works on the side of this index, seen from its left edge (1) or the right one (-1), or is in the way to it.
function SideAllocation:is_worked(index, edge)
   local face, cache = self.map:face_of(index), self.map:cache_of(index)
   local along, left = geometry.into(face, cache.x, cache.y)
   local x, y = geometry.out_of(face, along / 2, left)
   local across = { x = x, y = y, yaw = geometry.wrap(face.yaw - edge * math.pi / 2) }
   return self:is_worked_across(across, edge < 0 and self:are_fewer() and AT_ROW + COMES_IN or AT_ROW)
end

-- Whether a block was seen in another's hand on the way from a side's cache to the structure, half way or farther on.
function SideAllocation:is_carried_near(across)
   for _, block in ipairs(self.clearance:held_by_others()) do
      if geometry.apart(block, across) < CARRIED then return true end
   end
   return false
end

-- Whether someone works on a side: who does so is somewhere between the structure and the cache, and is seen or met by one
-- that comes in across; `across` is a place half way between them, and the direction to come from there. Two that look from
-- both edges at the same time are too far apart to see each other, and so go in one after the other: `time`, s, is how long
-- each looks. The second result: whether it did not get there, since somebody was in its way.
function SideAllocation:is_worked_across(across, time)
   local path = self.path
   local start, met = self.odometry.time, false
   local function meets()
      met = met or self.ranges:range('front') or self.clearance:meets(1) or self:is_carried_near(across)
      return met
   end
   local x, y = geometry.out_of(across, -INNER_EDGE, 0)
   if not self.navigation:to_before(x, y, BEFORE_EDGE) then
      return true, geometry.apart(self.odometry:pivot(), { x = x, y = y }) > BEFORE_EDGE + ON_THE_WAY
   end
   -- by readings since that turn
   coroutine.yield()
   if self.clearance:meets(BEFORE_EDGE) then return true end
   if not self.navigation:to(geometry.out_of(across, -EDGE, 0)) then return true end
   path:turn_to(across.yaw)
   self.lift:to(self.lift:top())
   path:follow(across, -INNER_EDGE, 0.06, meets)
   for step = -2, 2 do
      if not meets() then path:turn_to(across.yaw + step * EDGE_LOOK, UnexplainedReturns.LOOK_RIM) end
   end
   if not meets() then path:turn_to(across.yaw) end
   return self.process:wait_until(meets, time or AT_ROW) or
          #self.returns:near(across.x, across.y, INNER_EDGE, start) > 0
end

-- The next of the robot's sides on the way round.
function SideAllocation:next_side()
   local all, here = {}, 1
   for _, name in ipairs(self.task.sides) do table.insert(all, StructureMap.SIDES[name]) end
   table.sort(all)
   for i, side in ipairs(all) do
      if side == self.map.side then here = i end
   end
   return all[(here - 1 + self.way_round) % #all + 1]
end

-- Index of that of the robot's other sides that is nearest and `is_wanted(index)`; nil for none. Of two as near, where robots
-- are fewer than sides, the one on its way round: those that begin on opposite sides do not come to the same one.
function SideAllocation:nearest_other(is_wanted)
   local best, least
   local aside = self:are_fewer() and 0.5 or 0
   for _, name in ipairs(self.task.sides) do
      local index = StructureMap.SIDES[name]
      local quarters = (index - self.map.side) % 4
      local way = math.min(quarters, 4 - quarters) + (quarters == self.way_round % 4 and 0 or aside)
      if quarters > 0 and (not best or way < least) and is_wanted(index) then best, least = index, way end
   end
   return best
end

-- The side is the robot's from now on, and so is its cache.
function SideAllocation:take(side)
   local map = self.map
   map.side, map.cache = side, map:cache_of(side) or map.cache
end

-- To a side so many quarters on, the way round: to the left (1) or right (-1); to the opposite one, where robots are fewer than
-- sides, past that side of the two between on which it did not find somebody at work.
function SideAllocation:way_to(quarters)
   if quarters ~= 2 then return quarters == 1 and 1 or -1 end
   local side, way = self.map.side, self.way_round
   if not self:are_fewer() then return way end
   local function free(to) return self.taken[(side + to) % 4] ~= false end
   return (free(way) or not free(-way)) and way or -way
end

-- To the next side. Where somebody works there, back to where it was, and the other way round the next time; where robots are
-- fewer than sides, not if it is the opposite one, and nobody was on the way there. Says whether the side has changed.
function SideAllocation:change()
   local map, side = self.map, self.wanted or self:next_side()
   local quarters = (side - map.side) % 4
   if self:are_shared() then self.way_round = self:way_to(quarters) end
   self.wanted = nil
   local worked, on_the_way
   if self:are_shared() and map.cache_way then worked, on_the_way = self:is_worked(side, self.way_round) end
   local free = not worked
   self.worked = not free and side or nil
   on_the_way = on_the_way and self:are_fewer()
   if not on_the_way then self.taken[side] = free end
   if free then
      self:take(side)
   else
      if quarters ~= 2 or on_the_way or not self:are_fewer() then self.way_round = -self.way_round end
      self.path:back_off(EDGE - INNER_EDGE)
   end
   local away = math.min(Navigation.CLEAR_OF, self:room_before_cache(map.side))
   self.navigation:to(self:place_before(map.side, away))
   return free
end

return SideAllocation
