-- SPDX-License-Identifier: MIT
-- The lattice's directions. A side's name tells nothing to a robot that has no compass. `params.side` is the side on which it
-- begins, as it makes out when it first sees the structure; from then on it knows the directions by its own turns, put right by
-- a few degrees whenever it sees the structure again. When it is lost, the colours of bricks tell them, where they are as in the
-- structure in which work ends for one direction only; or else the way from the structure to the cache, once it has seen a
-- block there again.

local geometry = require 'common.geometry'

local wrap, wrap_quarter = geometry.wrap, geometry.wrap_quarter
local TURNED = 0.35            -- rad, of a turn that odometry's errors do not make

-- map: StructureMap. doubtful: the robot was lost, and its directions since are not certain. before: the heading that
-- faced the structure from params.side when it was lost.
local Directions = {}
Directions.__index = Directions
Directions.TURNED = TURNED
Directions.SIDES = { ['+x'] = 0, ['+y'] = 1, ['-x'] = 2, ['-y'] = 3 }

local SIDES = Directions.SIDES

function Directions.new(map, robot, odometry, task)
   return setmetatable({ map = map, robot = robot, odometry = odometry, task = task, doubtful = false }, Directions)
end

-- '+x' ..., of the side of this index.
function Directions.name_of(side)
   for name, index in pairs(SIDES) do
      if index == side then return name end
   end
end

-- Index of the side on which the robot began.
function Directions:first_side()
   return SIDES[self.robot.params.side or self.task.sides[1]]
end

-- Of the four headings that a lattice's yaw may mean, the one nearest to an angle.
local function nearest_to(angle, yaw)
   return angle + wrap_quarter(yaw - angle)
end

-- The heading that faces a structure, seen for the first time, from the side on which the robot
-- began: what two of three say. It began there, most likely with its back to the structure, and
-- it will not have gone far; each alone may be wrong after a search, or in a crowd.
function Directions:facing_at_first(middle, yaw)
   local here = nearest_to(geometry.angle_to(self.odometry.pose, middle), yaw)
   local there = nearest_to(geometry.angle_to({ x = 0, y = 0 }, middle), yaw)
   local behind = nearest_to(math.pi, yaw)
   return math.abs(wrap(there - behind)) < 0.1 and there or here
end

-- Of a structure as it is seen, how many of its bricks are not as in the end, at least, counted up to 2, by the number of
-- quarter turns from its frame to the world; nil where the end is not known.
function Directions:colours_off(structure)
   local known = {}
   for i, block in ipairs(structure.blocks) do
      local u, v, level = table.unpack(structure.cells[i])
      known[i] = { u = u, v = v, level = level, colour = block.colour }
   end
   return self.map.target and self.map.target:least_off(known)
end

-- The number of quarter turns for which no brick is off, if for any other `least` are; or nil.
local function only_turn(off, least)
   local only
   for quarters = 0, 3 do
      if off[quarters] < least then
         if only or off[quarters] > 0 then return nil end
         only = quarters
      end
   end
   return only
end

-- Of the headings that face a structure from params.side for which no brick that is seen is off the one nearest to a heading,
-- and by how much it differs; or nil.
function Directions:heading_by_colours(structure, off, near)
   local best, least
   for quarters = 0, 3 do
      local heading = wrap(structure.frame.yaw + math.pi + (self:first_side() - quarters) * math.pi / 2)
      local apart_from = math.abs(wrap(heading - near))
      if off[quarters] == 0 and (not best or apart_from < least) then best, least = heading, apart_from end
   end
   return best, least
end

-- The heading that faces a structure from params.side when the robot has lost its directions, or nil; and whether that is in
-- doubt, since another cache may have told it, or a brick of a wrong colour. Where the cache tells another than the colours
-- leave possible, it is that of those nearest to the one before: who was pushed has hardly been turned far.
function Directions:orientation_when_lost(structure, middle)
   local off = self:colours_off(structure)
   local by_cache = self.map.cache and self.map.bearing and
                    nearest_to(geometry.angle_to(middle, self.map.cache) - self.map.bearing, structure.frame.yaw)
   if not off then return by_cache, false end
   for least = 2, 1, -1 do
      if only_turn(off, least) then return self:heading_by_colours(structure, off, 0), least == 1 end
   end
   if not by_cache then return nil end
   local _, differs = self:heading_by_colours(structure, off, by_cache)
   if not differs or differs < TURNED or not self.before then return by_cache, true end
   return self:heading_by_colours(structure, off, self.before), true
end

-- The heading that faces the structure from params.side; nil where the robot cannot know.
function Directions:facing(structure, middle)
   local yaw = structure.frame.yaw
   if self.map.known then return nearest_to(self.map.known.yaw, yaw) end
   if self.map.lost and not self.task.turns then
      local heading, doubtful = self:orientation_when_lost(structure, middle)
      self.doubtful = heading ~= nil and doubtful
      return heading
   end
   return self:facing_at_first(middle, yaw)
end

-- Of the bricks that are known, how many are not as in the end, as above, and the number of turns that the robot takes for
-- right; nil where every turn is.
function Directions:known_off()
   if not self.map.known or not self.map.target or self.task.turns then return nil end
   return self.map.target:least_off(self.map:bricks_with {}), (self:first_side() + 2) % 4
end

-- Whether the bricks that are known are as in the end for other directions than the robot takes for theirs, and two of them
-- at least not for these, or one where they are in doubt: it has been turned.
function Directions:has_turned()
   local off, right = self:known_off()
   for quarters = 0, 3 do
      if off and off[quarters] == 0 then return off[right] >= (self.doubtful and 1 or 2) and off[right] > 0 end
   end
   return false
end

-- Ends the doubt where the bricks that are known leave no other direction possible.
function Directions:settle_doubt()
   local off, right = self:known_off()
   if off and only_turn(off, 2) == right then self.doubtful = false end
end

-- Names of the sides on which the robot may be: its own, and, while its directions are in doubt, those that the bricks that are
-- known leave possible.
function Directions:possible_sides()
   local out = { self.map:side_name() }
   if not self.doubtful then return out end
   local off, right = self:known_off()
   if not off then return out end
   for quarters = 0, 3 do
      local side = Directions.name_of((self.map.side + quarters - right) % 4)
      if quarters ~= right and off[quarters] == 0 then table.insert(out, side) end
   end
   return out
end

return Directions
