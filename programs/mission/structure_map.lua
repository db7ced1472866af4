-- SPDX-License-Identifier: MIT
-- What a robot knows of the structure that it builds: where it is, how its lattice lies, which
-- sides it has, and what rows of columns are seen from them.
--
-- `params.side` is the side on which it begins. Where the structure is far from where it was, the robot is lost
-- (mission/directions.lua).

local geometry = require 'common.geometry'
local structures = require 'perception.structures'
local Directions = require 'mission.directions'
local Target = require 'mission.target'

local SIDE = geometry.SIDE
local apart, wrap, wrap_quarter = geometry.apart, geometry.wrap, geometry.wrap_quarter
local FAR_LINKED = 2.3 * SIDE
local STRAYED = 0.40           -- m, by which the structure is farther off than odometry errs
local OF_BRICK, OF_CACHE = 0.012, 0.07  -- m, from a brick's edge and from a cache's middle, of what is no robot
local BEHIND = { x = -0.2, y = 0 }  -- where it is most likely, as robots begin with their backs to it
local OF_FIRST = 0.08          -- m, from there, of its first brick
local GONE = 12                -- steps, more than of two looks, in which a brick would be seen, and is not: it is not there;
                               -- another robot hides it for one look, but hardly in the next
local LEAST_TO_CACHE = 0.36    -- m, from a side's foremost brick to its cache, wherever that is
local ABOUT = 2                -- cells, from a column, of bricks that matter to what is decided before it

-- bricks: by "u v", cells of its lattice from the origin on, those that were ever seen: {u, v, levels, colours}, by level
-- the steps in which one would have been seen since, and was not, and the colour that it had.
-- known: {x, y, reach, yaw, origin}: middle and radius of all these bricks, also those out of sight, the
-- heading that faces the structure from params.side, and the middle of one cell; nil when it is not known.
-- first: {u, v}, the structure's middle as first seen, in cells: what grows moves `known`, but no cache.
-- cache: {x, y}, where the last block came from; cache_way: its distance from `first`; caches: by side, where
-- blocks were found there, in the lattice's frame. side: index of the side that the robot works from.
-- expected: where the structure is before it was seen.
-- bearing: of the cache from `first`, against known.yaw; kept when lost. lost: it was known once. target: the structure in which
-- work ends, or nil.
local StructureMap = {}
StructureMap.__index = StructureMap
StructureMap.SIDES, StructureMap.name_of = Directions.SIDES, Directions.name_of

local SIDES = StructureMap.SIDES

-- Knows nothing yet; of the task, `transport`, `sides` and `turns` count here.
function StructureMap.new(robot, odometry, tracker, task)
   local self = setmetatable({
      robot = robot, odometry = odometry, tracker = tracker, task = task, lost = false, bricks = {}, caches = {},
      target = Target.of(task), expected = BEHIND,
   }, StructureMap)
   self.directions = Directions.new(self, robot, odometry, task)
   return self
end

function StructureMap:is_brick(block)
   return block.colour > 0 and block.colour ~= self.task.transport
end

-- Whether blocks linked with each other may be no structure but one brick that somebody lost: of a colour that none begins
-- with. Of a large structure a look may show a single brick, too.
function StructureMap:may_be_lost(blocks)
   if #blocks ~= 1 or not self.task.starts then return false end
   for _, colour in ipairs(self.task.starts) do
      if colour == blocks[1].colour then return false end
   end
   return true
end

-- Whether a block is a brick, and none that somebody may have lost.
function StructureMap:is_of_structure(block)
   if not self:is_brick(block) then return false end
   if not self:may_be_lost { block } then return true end
   return self.tracker:recall(function(other)
      return other.id ~= block.id and self:is_brick(other) and geometry.near(other, block, FAR_LINKED)
   end) ~= nil
end

local function middle_of(structure)
   local x, y, n = 0, 0, #structure.blocks
   for _, known in ipairs(structure.blocks) do x, y = x + known.x / n, y + known.y / n end
   return { x = x, y = y }
end

-- How far a place is from the structure as it is known, m: all bricks that it had may be forgotten.
function StructureMap:off_known(place)
   return math.min(self:room_about(place.x, place.y), apart(self.known, place) - self.known.reach)
end

-- The largest structure of bricks, of what is in memory; of two alike the one nearer to where the
-- structure is known, or the robot began; a brick that may be lost where nothing else is. Some of its bricks may be out of sight, and those in memory
-- not be linked. Where the structure is known, a brick far from there is one that somebody lost,
-- unless `anywhere` is true.
function StructureMap:in_memory(anywhere)
   local home = self.known or { x = 0, y = 0 }
   local best, most, least
   -- one that stands on no level is in a robot's hand, or was seen badly
   local function is_brick(block) return block.level ~= nil and self:is_brick(block) end
   for _, structure in ipairs(structures.of(self.tracker:blocks(), is_brick, FAR_LINKED)) do
      local middle = middle_of(structure)
      local away = apart(home, middle)
      local far = self.known and not anywhere and self:off_known(middle) > STRAYED
      local size = self:may_be_lost(structure.blocks) and 0 or #structure.blocks
      if not far and (not best or size > most or size == most and away < least) then
         best, most, least = structure, size, away
      end
   end
   return best
end

function StructureMap:lose()
   self.directions.before = self.known and self.known.yaw or self.directions.before
   self.known, self.side, self.lost, self.cache, self.bricks = nil, nil, true, nil, {}
   self.first, self.caches = nil, {}
end

-- Whether it is too far from where it was, or turned too much, for odometry's errors.
function StructureMap:has_strayed(structure, middle)
   local before = self.known
   if not before then return false end
   return self:off_known(middle) > STRAYED or math.abs(wrap_quarter(structure.frame.yaw - before.yaw)) > Directions.TURNED
end

-- Middle and reach of all bricks that were ever seen. Of those in sight alone the robot would keep a way off
-- that leads over the others.
function StructureMap:measure_bricks()
   local low, high = { u = math.huge, v = math.huge }, { u = -math.huge, v = -math.huge }
   for _, brick in pairs(self.bricks) do
      for axis in pairs(low) do
         low[axis], high[axis] = math.min(low[axis], brick[axis]), math.max(high[axis], brick[axis])
      end
   end
   local middle = { u = (low.u + high.u) / 2, v = (low.v + high.v) / 2 }
   local reach = 0
   for _, brick in pairs(self.bricks) do
      reach = math.max(reach, math.sqrt((brick.u - middle.u) ^ 2 + (brick.v - middle.v) ^ 2))
   end
   self.first = self.first or middle
   self.known.x, self.known.y = geometry.out_of(self:lattice(), SIDE * middle.u, SIDE * middle.v)
   self.known.reach = SIDE * (reach + 0.5)
end

-- The middle of one cell, which stays the same for as long as the robot is less than half a cell
-- wrong.
function StructureMap:origin_in(frame)
   local origin = self.known and self.known.origin or frame
   local u, v = geometry.into(frame, origin.x, origin.y)
   local x, y = geometry.out_of(frame, SIDE * geometry.round(u / SIDE), SIDE * geometry.round(v / SIDE))
   return { x = x, y = y }
end

-- Whether a brick may stand in a cell, as far as its neighbours are known: on the floor, on one, or held by one beside.
-- A block in the air is in a robot's hand, though it may have its colour already.
function StructureMap:is_held_in(u, v, level)
   return level == 0 or self:had_brick_in(u, v, level - 1) or
          self:had_brick_in(u - 1, v, level) or self:had_brick_in(u + 1, v, level) or
          self:had_brick_in(u, v - 1, level) or self:had_brick_in(u, v + 1, level)
end

-- Remembers the bricks of a structure in those cells that `counts(u, v, level)`.
function StructureMap:note_structure(structure, counts)
   for _, block in ipairs(structure.blocks) do
      local u, v = self:cell_of(block.x, block.y)
      local level = geometry.level_of(block.z)
      if counts(u, v, level) then self:note_brick_in(u, v, level, block.colour) end
   end
end

-- Where the structure is elsewhere, of rules that hold in every turn: which of its sides is which matters to nobody, but
-- bricks and caches are not where they were.
function StructureMap:begin_anew()
   self.bricks, self.caches, self.first, self.known.origin = {}, {}, nil, nil
end

-- Learns where the structure is, and how the lattice lies. False where the latter is not known.
function StructureMap:remember(structure)
   local middle = middle_of(structure)
   local strayed = self:has_strayed(structure, middle)
   if strayed and self.task.turns then
      self:begin_anew()
   elseif strayed then
      self:lose()
      -- what was seen before does not fit what is seen from now on
      self.tracker:forget_all()
      return false
   end
   local yaw = self.directions:facing(structure, middle)
   if not yaw then return false end
   local frame = { x = structure.frame.x, y = structure.frame.y, yaw = yaw }
   self.known = { yaw = wrap(yaw), origin = self:origin_in(frame) }
   self:note_structure(structure, function(...) return self:is_held_in(...) end)
   -- of one that is seen for the first time, what holds its bricks may be out of sight
   if not next(self.bricks) then self:note_structure(structure, function() return true end) end
   self:measure_bricks()
   if strayed and self.side then self.cache = self:cache_of(self.side) end
   return true
end

-- The cell of a place on the lattice.
function StructureMap:cell_of(x, y)
   local along, left = geometry.into(self:lattice(), x, y)
   return geometry.round(along / SIDE), geometry.round(left / SIDE)
end

-- Under which a cell's bricks are kept.
local function key_of(u, v) return u .. ' ' .. v end

-- Remembers a brick of a colour that stands in a cell.
function StructureMap:note_brick_in(u, v, level, colour)
   local key = key_of(u, v)
   local brick = self.bricks[key] or { u = u, v = v, levels = {}, colours = {} }
   self.bricks[key], brick.levels[level], brick.colours[level] = brick, 0, colour
end

-- Remembers a brick of a colour that stands there.
function StructureMap:note_brick(x, y, level, colour)
   local u, v = self:cell_of(x, y)
   self:note_brick_in(u, v, level, colour)
end

-- The cell of a place, as rows of a side are counted: u towards the robot, v to the left.
local function cell_in(frame, x, y)
   local along, left = geometry.into(frame, x, y)
   return -geometry.round(along / SIDE), geometry.round(left / SIDE)
end

-- Where a brick should stand that was seen before.
function StructureMap:place_of_brick(brick)
   return geometry.out_of(self:lattice(), SIDE * brick.u, SIDE * brick.v)
end

-- Forgets a row's bricks: they were not seen again.
function StructureMap:forget_row(row)
   for key, brick in pairs(self.bricks) do
      local _, v = cell_in(row.frame, self:place_of_brick(brick))
      if v == row.v then self.bricks[key] = nil end
   end
end

-- Whether a block is in the picture just now whose middle is near a place.
local function is_seen(tracker, place, now)
   for _, known in ipairs(tracker.tracks) do
      if known.time == now and geometry.near(known, place, geometry.HALF) then return true end
   end
   return false
end

-- Forgets what is not there of a cell's bricks.
function StructureMap:review(brick, heading, sight, about)
   local x, y = self:place_of_brick(brick)
   for level, unseen in pairs(brick.levels) do
      local place = { x = x, y = y, z = SIDE * (level + 0.5) }
      if not is_seen(self.tracker, place, self.odometry.time) and sight:would_see(x, y, level, heading, about) then
         brick.levels[level] = unseen + 1 < GONE and unseen + 1 or nil
      end
   end
end

-- Once in each step in which the robot stands before a row: forgets bricks about its column that would be seen, and are
-- not. One that another robot held over its place, in its colour already, was taken for a brick that stands there.
-- `sight`: LineOfSight; `about`: its blocks_about().
function StructureMap:forget_gone(row, sight, about)
   if not self.known then return end
   local u, v = self:cell_of(StructureMap.place_of(row, 0, 0))
   for du = -ABOUT, ABOUT do
      for dv = -ABOUT, ABOUT do
         local key = key_of(u + du, v + dv)
         local brick = self.bricks[key]
         if brick then self:review(brick, row.frame.yaw, sight, about) end
         if brick and not next(brick.levels) then self.bricks[key] = nil end
      end
   end
end

-- How many bricks were ever seen.
function StructureMap:count_bricks()
   local count = 0
   for _, brick in pairs(self.bricks) do
      for _ in pairs(brick.levels) do count = count + 1 end
   end
   return count
end

-- A function that says whether more bricks are known than so many, or at first, asked in each step.
function StructureMap:sees_new_brick(known)
   local before = known or self:count_bricks()
   return function() return self:rows() ~= nil and self:count_bricks() > before end
end

-- All bricks that were ever seen, where they should stand: {x, y, z, yaw}.
function StructureMap:all_bricks()
   local out = {}
   if not self.known then return out end
   for _, brick in pairs(self.bricks) do
      local x, y = self:place_of_brick(brick)
      for level in pairs(brick.levels) do
         table.insert(out, { x = x, y = y, z = SIDE * (level + 0.5), yaw = self.known.yaw })
      end
   end
   return out
end

-- Bricks that are known, {u, v, level, colour}, with what some of them show just now.
function StructureMap:bricks_with(shown)
   local out, now = {}, {}
   for _, brick in ipairs(shown) do now[key_of(brick.u, brick.v) .. ' ' .. brick.level] = brick end
   for key, brick in pairs(self.bricks) do
      for level, colour in pairs(brick.colours) do
         if brick.levels[level] and not now[key .. ' ' .. level] then
            table.insert(out, { u = brick.u, v = brick.v, level = level, colour = colour })
         end
      end
   end
   return table.move(shown, 1, #shown, #out + 1, out)
end

-- Whether a brick stands in a cell in the end, if the others that are known lie in one of the ways in which they fit into the
-- final structure, all but one, which may have been misread in another robot's hand; true where the robot can't know.
function StructureMap:may_stand(u, v, level)
   if not self.target then return true end
   local others = {}
   for _, brick in ipairs(self:bricks_with({})) do
      if brick.u ~= u or brick.v ~= v or brick.level ~= level then table.insert(others, brick) end
   end
   local fits = self.target:fits(others, 1)
   for _, way in ipairs(fits) do
      if self.target:colour(way, u, v, level) then return true end
   end
   return #fits == 0
end

-- Whether a brick was ever seen in a cell.
function StructureMap:had_brick_in(u, v, level)
   local brick = self.bricks[key_of(u, v)]
   return brick ~= nil and brick.levels[level] ~= nil
end

-- Whether a brick was ever seen there.
function StructureMap:had_brick(x, y, level)
   if not self.known then return false end
   local u, v = self:cell_of(x, y)
   return self:had_brick_in(u, v, level)
end

-- Whether a block over the floor is in a robot's hand, though no colour was seen on it: it is none of the bricks that were
-- ever seen, nor on one.
function StructureMap:floats(block)
   if not self.known or block.z < SIDE then return false end
   local level = geometry.level_of(block.z)
   return not self:had_brick(block.x, block.y, level) and not self:had_brick(block.x, block.y, level - 1)
end

-- Whether a block that comes down there is drawn aside: to where a brick stands a level lower, if neither one on the
-- other side draws it back nor one on its own level stops it.
function StructureMap:draws_aside(x, y, level)
   if not self.known then return false end
   local u, v = self:cell_of(x, y)
   for _, way in ipairs { { 1, 0 }, { -1, 0 }, { 0, 1 }, { 0, -1 } } do
      local du, dv = way[1], way[2]
      if self:had_brick_in(u + du, v + dv, level - 1) and not self:had_brick_in(u - du, v - dv, level - 1) and
         not self:had_brick_in(u + du, v + dv, level) then return true end
   end
   return false
end

-- The frame of its cells, which robots keep as they go round it.
function StructureMap:lattice()
   return { x = self.known.origin.x, y = self.known.origin.y, yaw = self.known.yaw }
end

-- How far a place is from the nearest brick's edge, of all that were ever seen, m.
function StructureMap:room_about(x, y)
   local least = math.huge
   if not self.known then return least end
   local along, left = geometry.into(self:lattice(), x, y)
   for _, brick in pairs(self.bricks) do
      local du = math.max(0, math.abs(along - SIDE * brick.u) - geometry.HALF)
      local dv = math.max(0, math.abs(left - SIDE * brick.v) - geometry.HALF)
      least = math.min(least, math.sqrt(du * du + dv * dv))
   end
   return least
end

-- Where the brick is that is nearest to a place, of all that were ever seen, or the structure's middle. Of two as near the
-- first by its cell, as the order of `pairs` is nobody's.
function StructureMap:nearest_brick(place)
   local best, least, first
   for key, brick in pairs(self.bricks) do
      local x, y = self:place_of_brick(brick)
      local off = apart({ x = x, y = y }, place)
      if not best or off < least or off == least and key < first then best, least, first = { x = x, y = y }, off, key end
   end
   return best or self.known
end

-- Whether what stands at a place is a brick, or the cache; before the structure was seen, what it begins with.
function StructureMap:explains(x, y)
   if self:room_about(x, y) < OF_BRICK then return true end
   if self.cache and apart(self.cache, { x = x, y = y }) < OF_CACHE then return true end
   if not self.known then return not self.lost and apart(self.expected, { x = x, y = y }) < OF_FIRST end
   local along, left = geometry.into(self:lattice(), x, y)
   for _, cache in pairs(self.caches) do
      if (cache.along - along) ^ 2 + (cache.left - left) ^ 2 < OF_CACHE ^ 2 then return true end
   end
   return false
end

-- The middle of the structure as it was first seen.
function StructureMap:beginning()
   local x, y = geometry.out_of(self:lattice(), SIDE * self.first.u, SIDE * self.first.v)
   return { x = x, y = y }
end

-- How near, m, to the structure's middle as it was first seen a cache was found.
function StructureMap:nearest_cache()
   local least = self.cache_way
   for _, cache in pairs(self.caches) do
      local along, left = cache.along - SIDE * self.first.u, cache.left - SIDE * self.first.v
      least = math.min(least, math.sqrt(along * along + left * left))
   end
   return least
end

-- The frame of the face of the side of this index: on the edge of its foremost brick, or as far out as the structure reached
-- where all bricks are forgotten, before the structure's middle, with the heading of who faces it.
function StructureMap:face_of(index)
   local frame, known = self:frame_of(index), self.known
   local along, left = geometry.into(frame, known.x, known.y)
   local front = next(self.bricks) and -math.huge or geometry.round((known.reach - along) / SIDE - 0.5)
   for _, u in pairs(StructureMap.fronts_of(self:cells_from(index))) do front = math.max(front, u) end
   local x, y = geometry.out_of(frame, -SIDE * (front + 0.5), left)
   return { x = x, y = y, yaw = frame.yaw }
end

-- How far, m, the cache of that side is from the face; math.huge where none is known.
function StructureMap:room_to_cache(index)
   local cache = self:cache_of(index)
   return cache and -geometry.into(self:face_of(index), cache.x, cache.y) or math.huge
end

-- Where blocks come from on the side of this index: where they were found, or as far off as at that of the other sides
-- where it is nearest, but not nearer to what stands there than caches are; nil where none is known.
function StructureMap:cache_of(index)
   local own = self.caches[index]
   if not own and not self.cache_way then return nil end
   local x, y
   if own then
      x, y = geometry.out_of(self:lattice(), own.along, own.left)
   else
      local from = self:beginning()
      from.yaw = self:heading_of(index)
      local face = self:face_of(index)
      local out = -geometry.into(from, face.x, face.y)
      x, y = geometry.out_of(from, -math.max(self:nearest_cache(), out + LEAST_TO_CACHE), 0)
   end
   return { x = x, y = y }
end

-- The heading of a robot on the side of this index.
function StructureMap:heading_of(index)
   local first = self.task.turns and 0 or self.directions:first_side()
   return wrap(self.known.yaw + (index - first) * math.pi / 2)
end

-- '+x' ..., of the side that the robot works from.
function StructureMap:side_name()
   return StructureMap.name_of(self.side)
end

-- The side of this index in the order of sides, from 0 on, which is the same for all robots.
function StructureMap:order_of_side(index)
   return (index + (self.task.turns and self.directions:first_side() or 0)) % 4
end

-- Where a side, by its number in the order of sides, is in the order of turns at a level, from 0 on: that of sides, from one
-- further on at each level.
local function rank_of(number, level) return (number - level) % 4 end

-- Likewise for the side of this index.
function StructureMap:rank_of_side(index, level)
   return rank_of(self:order_of_side(index), level)
end

-- The robot's side in the order of sides, and the side on which a place is.
function StructureMap:order_of(place)
   local own = self:order_of_side(self.side)
   local turn = wrap(geometry.angle_to(place, self.known) - self:heading_of(self.side))
   return own, (own + geometry.round(turn / (math.pi / 2))) % 4
end

-- Whether a robot on this side goes before one that is at a place on another: the order of turns at a level says. On the same
-- side chance does.
function StructureMap:goes_before(place, level)
   local own, other = self:order_of(place)
   if own == other then return math.random() < 0.5 end
   return rank_of(own, level) < rank_of(other, level)
end

-- Whether a place is on a side that adjoins the robot's.
function StructureMap:is_on_adjoining_side(place)
   local own, other = self:order_of(place)
   return (own - other) % 2 == 1
end

-- Whether its side is that of this number in the order of sides, or the opposite one.
function StructureMap:is_along(number)
   return (self:order_of_side(self.side) - number) % 2 == 0
end

-- Whether it waits at a corner for one that is at a place on an adjoining side: who works along y does, so that two at most
-- wait, and those for whom they wait are on opposite sides.
function StructureMap:waits_at_corner(place)
   local _, other = self:order_of(place)
   return self:is_along(1) and other % 2 == 0
end

-- The side among those allowed that a place is nearest to.
function StructureMap:nearest_side(place)
   local there = geometry.angle_to(place, self.known)
   local best, least
   for _, name in ipairs(self.task.sides) do
      local off = math.abs(wrap(self:heading_of(SIDES[name]) - there))
      if not least or off < least - 1e-6 then best, least = SIDES[name], off end
   end
   return best
end

-- Whether a place is on the side of this index rather than on another.
function StructureMap:is_on_side(index, place)
   return math.abs(wrap(self:heading_of(index) - geometry.angle_to(place, self.known))) <= math.pi / 4
end

-- Whether a place is on one of the sides allowed rather than on another.
function StructureMap:is_on_own_side(place)
   return self:is_on_side(self:nearest_side(place), place)
end

-- By how much, m, columns beside a row stand before it where the effector would sweep them.
function StructureMap.juts_beside(rows, of)
   local most = of.front
   for dv = -2, 2 do most = math.max(most, rows[of.v + dv] and rows[of.v + dv].front or most) end
   return SIDE * (most - of.front)
end

-- The frame in which the rows of the side of this index are counted.
function StructureMap:frame_of(index)
   local origin = self.known.origin
   return { x = origin.x, y = origin.y, yaw = self:heading_of(index) }
end

-- The step in cells that leads from the structure to who stands on the side of this index: du, dv.
function StructureMap:step_to(index)
   local of = { v = 0, front = 0, frame = self:frame_of(index) }
   local u, v = self:cell_of(self.place_of(of, 1, 0))
   local u0, v0 = self:cell_of(self.place_of(of, 0, 0))
   return u - u0, v - v0
end

-- The cells with bricks that were ever seen, as rows of the side of this index are counted: by v and u.
function StructureMap:cells_from(index)
   local frame, cells = self:frame_of(index), {}
   for _, brick in pairs(self.bricks) do
      local u, v = cell_in(frame, self:place_of_brick(brick))
      cells[v] = cells[v] or {}
      cells[v][u] = brick
   end
   return cells
end

-- By v, the foremost u of such cells.
function StructureMap.fronts_of(cells)
   local fronts = {}
   for v, row in pairs(cells) do
      for u in pairs(row) do fronts[v] = math.max(fronts[v] or u, u) end
   end
   return fronts
end

-- Rows of the structure as seen from this side: by v, the foremost u; `by_heart` where that was not seen lately: of a row
-- of which nothing was seen, or only what stands farther back: the foremost may be below the picture.
function StructureMap:rows()
   local structure = self:in_memory()
   if not structure or not self:remember(structure) or not self.side then return nil end
   local frame = self:frame_of(self.side)
   local rows = {}
   for _, known in ipairs(structure.blocks) do
      local u, v = cell_in(frame, known.x, known.y)
      if not rows[v] or rows[v].front < u then rows[v] = { v = v, front = u, frame = frame, by_heart = false } end
   end
   for v, u in pairs(StructureMap.fronts_of(self:cells_from(self.side))) do
      if not rows[v] or rows[v].front < u then rows[v] = { v = v, front = u, frame = frame, by_heart = true } end
   end
   for _, of in pairs(rows) do of.juts = StructureMap.juts_beside(rows, of) end
   return rows
end

-- Place of a cell, du and dv from the foremost of a row.
function StructureMap.place_of(of, du, dv)
   return geometry.out_of(of.frame, -SIDE * (of.front + du), SIDE * (of.v + dv))
end

-- Place of the brick that a decision before a row's column wants.
function StructureMap.place_for(of, wish)
   return StructureMap.place_of(of, wish.what == 'extend' and 1 or 0, wish.left or 0)
end

-- The line on which the robot faces a row; its end is the middle of the foremost column.
function StructureMap.line_before(of)
   local x, y = StructureMap.place_of(of, 0, 0)
   return { x = x, y = y, yaw = of.frame.yaw }
end

-- Whether the body has room before a row: what juts out beside it by two cells is in the way.
function StructureMap.room_before(rows, of)
   for _, v in ipairs { of.v - 1, of.v + 1 } do
      if rows[v] and rows[v].front >= of.front + 2 then return false end
   end
   return true
end

-- Found and known: which side is the nearest, and where the cache is from here. Whether the side is a
-- new one.
function StructureMap:settle()
   self.lost = false
   if self.cache then
      local from = self:beginning()
      self.bearing = wrap(geometry.angle_to(from, self.cache) - self.known.yaw)
      self.cache_way = apart(from, self.cache)
      local along, left = geometry.into(self:lattice(), self.cache.x, self.cache.y)
      self.caches[self:nearest_side(self.cache)] = { along = along, left = left }
   end
   if self.side then return false end
   self.side = self:nearest_side(self.odometry.pose)
   return true
end

return StructureMap
