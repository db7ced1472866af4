-- SPDX-License-Identifier: MIT
-- Turns of robots that could all do but one and the same, as where a tower begins that is to be raised: each side has its robot,
-- each knows the structure and the rules, and so each knows whose turn it is, without a word.

local geometry = require 'common.geometry'
local DueRows = require 'mission.due_rows'
local StructureMap = require 'mission.structure_map'

local SIDE = geometry.SIDE
local LASTS = 28               -- s, of a turn
local LEAVES = 1.5             -- s, after its brick was seen, in which another is about to be out of the way

-- site: the only cell {u, v, level, since, first} in which a brick is due, as this robot knew when it last looked; since when, s;
-- and the side of whoever goes first, by its number in the order of sides.
-- known: how many bricks it knew right after it had put one in its turn, until it looks at a row again.
local Turns = {}
Turns.__index = Turns

function Turns.new(machine, map, sides, task)
   return setmetatable({
      odometry = machine.odometry, process = machine.process, lift = machine.lift, camera = machine.camera,
      map = map, sides = sides, task = task,
   }, Turns)
end

-- The only cell {u, v, level} in which a brick is due, as far as the robot remembers, and indices of the sides from which it is;
-- nil where rules ask for several bricks, or for none.
function Turns:only_due()
   local map, only, sides = self.map, nil, {}
   for _, name in ipairs(self.task.all_sides) do
      local side = StructureMap.SIDES[name]
      for _, due in pairs(DueRows.of(map, self.task, side)) do
         only = only or due.site
         if not DueRows.is_same(due.site, only) then return nil end
         if sides[#sides] ~= side then table.insert(sides, side) end
      end
   end
   return only, sides
end

-- How many robots go before this one, and the only cell in which a brick is due: those from whose sides it is go by the order of
-- sides, one further on at each level, and before those who cannot do it. 0 where it is not the only one, or not every side has
-- its robot.
function Turns:order()
   local map = self.map
   if not map.side or not map.known or not self.sides:take_turns() then return 0 end
   local only, sides = self:only_due()
   if not only then return 0 end
   local before, own, least = 0, math.huge, math.huge
   for _, side in ipairs(sides) do
      if side == map.side then own = map:rank_of_side(side, only.level) end
   end
   for _, side in ipairs(sides) do
      local rank = map:rank_of_side(side, only.level)
      if rank < own then before = before + 1 end
      if rank < least then only.first, least = map:order_of_side(side), rank end
   end
   only.since = self.site and DueRows.is_same(only, self.site) and self.site.since or self.odometry.time
   self.site = only
   return before, only
end

-- Whether all could do but one and the same, and it is this robot's turn.
function Turns:is_own()
   local before, site = self:order()
   return before == 0 and site ~= nil
end

-- Whether a brick in a cell would be in sight from where the robot stands before it.
function Turns:would_see(site)
   local place = { z = SIDE * (site.level + 0.5) }
   place.x, place.y = geometry.out_of(self.map:lattice(), SIDE * site.u, SIDE * site.v)
   return self.camera:farthest_in_sight(self.lift.highest, place) > self.odometry:distance_to(place)
end

-- Until those have built who go first, as far as that is in sight from here, or else the next of them should have. The side of
-- the last for whom it has waited, by its number in the order of sides, or nil.
function Turns:await_others()
   local before, site = self:order()
   local last
   while before > 0 do
      local now, over = before, site.since + LASTS * (self:would_see(site) and before or 1)
      if over <= self.odometry.time then break end
      last = site.first
      local changed = self.process:wait_until(function()
         self.map:rows()
         now, site = self:order()
         last = site and site.first or last
         return now ~= before
      end, over - self.odometry.time)
      before = changed and now or 0
   end
   return last
end

-- Until it is this robot's turn, with the lift at a height from which it sees the structure. After the last turn all would set
-- out at once: whoever had it, and who is on that side or opposite, waits until a brick of the others is seen, or might be
-- there, so that two do not come to a corner together. Whether it has waited.
function Turns:await(height)
   local known = self.known
   self.known = nil
   if not known and self:order() == 0 then return false end
   self.process:enter('await turn')
   self.lift:to(height)
   local last = self:await_others()
   -- the structure may have been lost meanwhile
   if not self.map.side then return true end
   -- what it has put itself counts where others have built nothing since
   if last then known = nil end
   if not self:is_own() and (known or last and self.map:is_along(last)) then self:await_brick(LASTS, known) end
   return true
end

-- Until a brick of another's is seen that was not among so many, or is not known now, or might be there after so long, s, and
-- that one is about to be out of the way.
function Turns:await_brick(time, known)
   if self.process:wait_until(self.map:sees_new_brick(known), time) then self.process:wait(LEAVES) end
end

-- The robot puts a brick: `note()` remembers it.
function Turns:place(note)
   local own = self:is_own()
   note()
   self.known = own and self.map:count_bricks() or nil
   -- the next turn begins
   self:order()
end

return Turns
