-- SPDX-License-Identifier: MIT
-- What a robot expects of the rows of each side, by what it remembers: where it goes when there is nothing to do here.

local DueRows = require 'mission.due_rows'
local StructureMap = require 'mission.structure_map'

-- in_vain: by side and v, rows that were looked at in vain since the last brick; left: by side, whether it has left it since.
local Prospects = {}
Prospects.__index = Prospects

function Prospects.new(map, sides, task)
   return setmetatable({ map = map, sides = sides, task = task, in_vain = {}, left = {} }, Prospects)
end

-- A row of a side was looked at in vain.
function Prospects:note_in_vain(side, v)
   self.in_vain[side] = self.in_vain[side] or {}
   self.in_vain[side][v] = true
end

-- It leaves a side, since there is nothing to do.
function Prospects:note_left(side)
   self.left[side] = true
end

-- With every brick rows may ask for something new.
function Prospects:forget()
   self.in_vain, self.left = {}, {}
end

-- Rows by v that the rules ask for from a side, as far as the robot remembers, and that were not looked at in vain.
function Prospects:due_from(side)
   local due, vain = DueRows.of(self.map, self.task, side), self.in_vain[side] or {}
   for v in pairs(vain) do due[v] = nil end
   return due
end

-- Rows by v of a side at which a brick is missing, as far as the robot remembers; nil where it can't know.
function Prospects:unfinished_from(side)
   return self.map.target and DueRows.unfinished(self.map, self.task, self.map.target, side)
end

-- Whether a brick that stands in a cell in the end, if known bricks lie so in the final structure, is in sight from one of the
-- robot's sides then.
function Prospects:shows(way, cell)
   for _, name in ipairs(self.task.sides) do
      if self.map.target:is_open(way, cell, self.map:step_to(StructureMap.SIDES[name])) then return true end
   end
   return false
end

-- Whether the robot has seen all bricks that are in sight from its sides in the end: nothing is left to do, as far as it can
-- know.
function Prospects:has_seen_all()
   local map = self.map
   local fits = map.target and map.known and map.target:fits(map:bricks_with({})) or {}
   for _, way in ipairs(fits) do
      for _, cell in ipairs(map.target:cells_in(way)) do
         if not map:had_brick_in(cell.u, cell.v, cell.level) and self:shows(way, cell) then return false end
      end
   end
   return #fits > 0
end

-- Whether a row is due from a side.
function Prospects:is_due(side)
   return next(self:due_from(side)) ~= nil
end

-- Whether a brick is missing at one of a side's rows; false where the robot can't know.
function Prospects:is_unfinished(side)
   return next(self:unfinished_from(side) or {}) ~= nil
end

-- Whether no brick is missing at any; false where the robot can't know.
function Prospects:is_finished(side)
   local unfinished = self:unfinished_from(side)
   return unfinished and next(unfinished) == nil or false
end

-- That of the robot's other sides that is nearest where there may be work, or nil. Where there is a robot for each side, that is
-- where a row is due, but for one where it has just found somebody at work: all that have done their work would come to the
-- side where a brick is missing.
function Prospects:likely_side()
   if self.sides:are_fewer() then return self:next_in_turn() end
   return self:due_side()
end

-- Where robots are fewer than sides: where a row is due, or else a brick missing, and it did not find somebody at work when it
-- was last there, since whatever is due there by its memory is built by then; or else where it found somebody before the last
-- change of sides. Since memory may be wrong, it comes to no side for the second time before it was at all of them.
function Prospects:next_in_turn()
   local sides = self.sides
   local function nearest(counts, has_work)
      return sides:nearest_other(function(side) return not self.left[side] and counts(side) and has_work(side) end)
   end
   local function due(side) return self:is_due(side) end
   local function unfinished(side) return self:is_unfinished(side) end
   local function unmanned(side) return sides.taken[side] ~= false end
   local function before(side) return side ~= sides.worked end
   local best = nearest(unmanned, due) or nearest(unmanned, unfinished) or nearest(before, due) or nearest(before, unfinished)
   if not sides:nearest_other(function(side) return not self.left[side] end) then self.left = {} end
   return best
end

-- That of its other sides that is nearest where a row is due, but for one where it has just found somebody at work, or nil; with
-- `free`, of those that it found free.
function Prospects:due_side(free)
   local sides = self.sides
   return sides:nearest_other(function(side)
      return side ~= sides.worked and (not free or sides.taken[side]) and self:is_due(side)
   end)
end

-- Likewise to go there at once, since there is nothing to do here: where robots are fewer than sides, none that it has left since
-- the last brick, or where somebody was at work when it was last there.
function Prospects:due_at_once(keeps)
   local sides = self.sides
   if not sides:are_fewer() then return self:due_side(keeps) end
   return sides:nearest_other(function(side)
      return not self.left[side] and sides.taken[side] ~= false and self:is_due(side)
   end)
end

return Prospects
