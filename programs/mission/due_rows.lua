-- SPDX-License-Identifier: MIT
-- Rows of a side that the rules ask for, if the structure is as the robot remembers it, and those at which a brick is still
-- missing: where it goes first, to look whether that is so.

local BESIDE = { { 0, 0 }, { 1, 0 }, { 0, 1 }, { 0, -1 } }  -- du, dv: on a row's column, before it and beside it

local DueRows = {}

-- The colour in a cell, nil where it is not known, or 'empty' where no brick was ever seen.
local function colour_in(cells, u, v, level)
   local brick = cells[v] and cells[v][u]
   if not brick or not brick.levels[level] then return 'empty' end
   return brick.colours[level]
end

-- Colour and level of a column's highest brick, from the floor up, as task.decide takes them; nil for an overhang.
local function top_of(cells, front, v, levels)
   local colour, top
   for level = 0, levels do
      local is = colour_in(cells, front, v, level)
      if is == 'empty' or not is then break end
      colour, top = is, level
   end
   return colour, top
end

-- Level of a column's highest brick, whatever is below: what is raised on an overhang goes on that.
local function highest_of(cells, front, v, levels)
   for level = levels, 0, -1 do
      if colour_in(cells, front, v, level) ~= 'empty' then return level end
   end
   return -1
end

-- Whether two cells {u, v, level} are the same.
function DueRows.is_same(cell, other)
   return cell.u == other.u and cell.v == other.v and cell.level == other.level
end

-- The cell of the lattice into which a wish before a row's column, whose highest brick is on a level, puts its brick.
local function site_of(map, of, wish, highest)
   local u, v = map:cell_of(map.place_for(of, wish))
   return { u = u, v = v, level = wish.level or highest + 1 }
end

-- By v, rows as the map has them, {v, front, frame, site}, seen from the side of this index; site: the cell {u, v, level} of the
-- lattice in which the brick is due.
function DueRows.of(map, task, index)
   local cells, frame, rows, due = map:cells_from(index), map:frame_of(index), {}, {}
   for v, front in pairs(map.fronts_of(cells)) do rows[v] = { v = v, front = front, frame = frame } end
   for v, of in pairs(rows) do
      local colour, level = top_of(cells, of.front, v, task.levels)
      local function cell(du, dv, at) return colour_in(cells, of.front + du, v + dv, at) end
      local wish = map.room_before(rows, of) and
                   task.decide { top_colour = colour, top_level = level, side = map.name_of(index), cell = cell }
      if wish then
         of.site = site_of(map, of, wish, highest_of(cells, of.front, v, task.levels))
         due[v] = of
      end
   end
   return due
end

-- Whether the structure, if it lies in a way in the robot's cells, has a brick at a row that the robot does not know.
local function lacks_brick(map, target, way, of, levels)
   for _, cell in ipairs(BESIDE) do
      local u, v = map:cell_of(map.place_of(of, cell[1], cell[2]))
      for level = 0, levels - 1 do
         if target:colour(way, u, v, level) and not map:had_brick_in(u, v, level) then return true end
      end
   end
   return false
end

-- By v, rows of this side at which a brick of the structure in which work ends is not known to stand, in any of the ways in
-- which the known bricks lie in it; nil where they lie in it in no way.
function DueRows.unfinished(map, task, target, index)
   local fits, frame, out = target:fits(map:bricks_with({})), map:frame_of(index), {}
   if #fits == 0 then return nil end
   for v, front in pairs(map.fronts_of(map:cells_from(index))) do
      local of = { v = v, front = front, frame = frame }
      for _, way in ipairs(fits) do
         if not out[v] and lacks_brick(map, target, way, of, task.levels) then out[v] = of end
      end
   end
   return out
end

return DueRows
