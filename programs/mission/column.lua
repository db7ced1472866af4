-- SPDX-License-Identifier: MIT
-- What a robot sees of the column that it stands before. Cells are named by du towards the robot and dv
-- to its left of the column, and their level, as rules are compiled.

local geometry = require 'common.geometry'

local SIDE = geometry.SIDE
local OFTEN = 3                -- sightings that count
local SURELY = 10              -- likewise of a colour that should not be there

-- Cells that are empty where a brick would be seen: those that decisions ask for, and the column's own,
-- since its top is the brick below the first empty one. The top's own tag need not be in any picture. Behind a
-- site on top there is a brick, or what comes before the effector is another robot.
local function watched_cells(task)
   local out, known = {}, {}
   local function add(du, dv, level)
      local key = du .. ' ' .. dv .. ' ' .. level
      if not known[key] then table.insert(out, { du = du, dv = dv, level = level }) end
      known[key] = true
   end
   for _, ask in ipairs(task.asks) do add(table.unpack(ask)) end
   for level = 1, task.levels - 1 do
      add(0, 0, level)
      add(-1, 0, level)
   end
   return out
end

-- bricks and empty by "u v level", cells as rows are counted, since the row's front may be found to be another
-- in the midst of a look: the block there; how often it would have been seen. watched: {du, dv, level} of cells
-- that are counted as empty where no brick is seen. looked: when, s, last. told: what the last decision was told, in words.
local Column = {}
Column.__index = Column

function Column.new(odometry, tracker, sight, map, task, row)
   return setmetatable({
      odometry = odometry, tracker = tracker, sight = sight, map = map, task = task, row = row,
      bricks = {}, empty = {}, watched = watched_cells(task), looked = odometry.time,
   }, Column)
end

function Column:key(du, dv, level)
   return self.row.front + du .. ' ' .. self.row.v + dv .. ' ' .. level
end

function Column:count_empty(key)
   self.empty[key] = (self.empty[key] or 0) + 1
end

-- The cell of a block: du, dv.
function Column:cell_of(known)
   local row = self.row
   local along, left = geometry.into(row.frame, known.x, known.y)
   return -geometry.round(along / SIDE) - row.front, geometry.round(left / SIDE) - row.v
end

-- A block that is in the picture just now.
function Column:note(known)
   local du, dv = self:cell_of(known)
   local level = geometry.level_of(known.z)
   self.bricks[self:key(du, dv, level)] = known
   if known.top_time == self.odometry.time then self:count_empty(self:key(du, dv, level + 1)) end
end

-- Once in each step, for as long as the robot stands: bricks by colour, cells that are empty since a
-- brick there would be seen.
function Column:watch()
   self.looked = self.odometry.time
   local rows = self.map:rows()
   self.row = rows and rows[self.row.v] or self.row
   for _, known in ipairs(self.tracker.tracks) do
      if known.time == self.odometry.time and known.seen >= OFTEN then self:note(known) end
   end
   local about = self.sight:blocks_about()
   self.map:forget_gone(self.row, self.sight, about)
   for _, cell in ipairs(self.watched) do
      local x, y = self.map.place_of(self.row, cell.du, cell.dv)
      local key = self:key(cell.du, cell.dv, cell.level)
      if not self.bricks[key] and self.sight:would_see(x, y, cell.level, self.row.frame.yaw, about) then
         self:count_empty(key)
      end
   end
end

-- A colour, 'empty', or nil where it is not known, or was seen both empty and filled.
function Column:cell(du, dv, level)
   local key = self:key(du, dv, level)
   local known, empty = self.bricks[key], (self.empty[key] or 0) >= OFTEN
   if not known then return empty and 'empty' or nil end
   return not empty and self.map:is_brick(known) and known.colour or nil
end

-- The block that was seen in a cell.
function Column:brick(du, dv, level)
   return self.bricks[self:key(du, dv, level)]
end

-- The highest brick of the column in front.
function Column:top()
   local top
   for level = 0, self.task.levels do
      local is = self:cell(0, 0, level)
      if is == 'empty' or (not is and level == self.task.levels) then return top end
      if not is then return nil end
      top = { level = level, colour = is, known = self:brick(0, 0, level) }
   end
   return top
end

-- A brick in a cell as it was seen on the way here.
function Column:recalled(du, dv, level)
   local place = { z = SIDE * (level + 0.5) }
   place.x, place.y = self.map.place_of(self.row, du, dv)
   return self.tracker:recall(function(known)
      return self.map:is_brick(known) and geometry.near(known, place, geometry.HALF) ~= nil
   end)
end

local function highest_of(levels, brick_on)
   for level = levels, 0, -1 do
      local known = brick_on(level)
      if known then return known end
   end
end

-- The highest of its bricks, whatever is below: of those that were in the picture from here, or else on the way.
function Column:highest()
   return highest_of(self.task.levels, function(level) return self:brick(0, 0, level) end) or
          highest_of(self.task.levels, function(level) return self:recalled(0, 0, level) end)
end

-- Bricks as they show themselves from here, {u, v, level, colour, block}, in cells of the map: those that stand, whatever
-- they show.
function Column:shown()
   local out = {}
   for _, known in pairs(self.bricks) do
      local u, v = self.map:cell_of(known.x, known.y)
      if known.level and known.seen >= SURELY and self.map:is_held_in(u, v, known.level) then
         table.insert(out, { u = u, v = v, level = known.level, colour = known.colour, block = known })
      end
   end
   return out
end

-- Whether a brick stands in a cell, as was seen from here, or ever before: looks show what decisions ask for,
-- and need not show all that is in the way.
function Column:stands(du, dv, level)
   local seen = self:brick(du, dv, level)
   if seen then return self.map:is_brick(seen) or du == 0 and dv == 0 end
   local x, y = self.map.place_of(self.row, du, dv)
   return self.map:had_brick(x, y, level) or self:recalled(du, dv, level) ~= nil
end

-- Where a neighbour stands beside the site that is wished for: 1 when to its right, -1 when to its left,
-- so that the block goes in a little off and does not catch on it; and whether none does on either side. What seems to be one
-- where none stands in the end is in another robot's hand.
function Column:room_beside(wish)
   local du, dv = wish.what == 'extend' and 1 or 0, wish.left or 0
   -- on an overhang there is no brick from the floor up
   local level = wish.level or geometry.level_of(wish.top.z) + 1
   local function beside(left)
      local u, v = self.map:cell_of(self.map.place_of(self.row, du, dv + left))
      return self:stands(du, dv + left, level) and self.map:may_stand(u, v, level)
   end
   local right, left = beside(-1), beside(1)
   return (right and 1 or 0) - (left and 1 or 0), not right and not left
end

-- Its bricks from a level down, as far as they are known.
function Column:down_from(highest)
   local out = {}
   for level = highest, 0, -1 do table.insert(out, self:brick(0, 0, level)) end
   return out
end

-- Bricks beside the site before the column, from a level down, as far as they are known: {brick, left}, in cells.
function Column:beside_site(highest)
   local out = {}
   for level = highest, 0, -1 do
      for left = -1, 1, 2 do
         local brick = self:brick(1, left, level)
         if brick then table.insert(out, { brick = brick, left = left }) end
      end
   end
   return out
end

-- A cell, as a decision asks for it, noted once for those who watch.
function Column:answer(du, dv, level)
   local is = self:cell(du, dv, level)
   local text = string.format('%d, %d, %d: %s', du, dv, level, is or 'not seen')
   for _, known in ipairs(self.told) do
      if known == text then return is end
   end
   table.insert(self.told, text)
   return is
end

-- Whether two decisions want the same.
local function is_same(one, other)
   if not one or not other then return one == other end
   return one.what == other.what and one.colour == other.colour and one.level == other.level and one.left == other.left
end

-- What the rules want here, for the task's decision: {what, colour, level, left, rule} with top, feet
-- (what the place is next to), next_to and aside, or nil, also where no brick of the column was seen yet, by which a robot
-- would find the place, or while the robot is not certain of its directions and they want something else for others. The second
-- result says whether the column's top was seen.
function Column:decide()
   self.told = {}
   -- the structure may have been lost meanwhile
   if not self.map.side then return nil, false end
   local top = self:top()
   self.told = { top and string.format('top Q%d, level %d', top.colour, top.level) or 'top not seen' }
   local wish
   for i, side in ipairs(self.map.directions:possible_sides()) do
      local found = self.task.decide {
         top_colour = top and top.colour, top_level = top and top.level, side = side,
         cell = function(du, dv, level) return self:answer(du, dv, level) end,
      }
      if i == 1 then wish = found end
      if not is_same(wish, found) then return nil, top ~= nil end
   end
   if not wish then return nil, top ~= nil end
   wish.top = self:highest()
   if not wish.top then return nil, false end
   wish.feet = self:down_from(wish.level or 0)
   wish.next_to = wish.what == 'extend' and self:beside_site(wish.level or 0) or {}
   wish.aside, wish.open = self:room_beside(wish)
   wish.clear = wish.what == 'raise' and self:cell(-1, 0, geometry.level_of(wish.top.z) + 1) == 'empty'
   return wish, top ~= nil
end

-- The brick that is in sight in a cell which was empty at the look, as far as it was seen since; or nil.
function Column:come_since(cell)
   if self:cell(cell.du, cell.dv, cell.level) ~= 'empty' then return nil end
   local x, y = self.map.place_of(self.row, cell.du, cell.dv)
   for _, known in ipairs(self.tracker.tracks) do
      if known.level == cell.level and known.seen >= OFTEN and known.time > self.looked and
         self.map:is_brick(known) and geometry.near(known, { x = x, y = y, z = SIDE * (cell.level + 0.5) }, geometry.HALF) then
         return known
      end
   end
end

-- Whether the rules want something else by now, since another's brick has come into a cell that was empty at the look.
function Column:is_outdated(wish)
   local changed = false
   for _, cell in ipairs(self.watched) do
      local brick = self:come_since(cell)
      if brick then
         local key = self:key(cell.du, cell.dv, cell.level)
         self.bricks[key], self.empty[key], changed = brick, nil, true
      end
   end
   return changed and not is_same(self:decide(), wish)
end

return Column
