-- SPDX-License-Identifier: MIT
-- Rows of a side that the rules ask for, if the structure is as the robot remembers it: where it goes first, to look
-- whether that is so.

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

-- By v, rows as the map has them, {v, front}, seen from the side of this index.
function DueRows.of(map, task, index)
   local cells, rows, due = map:cells_from(index), {}, {}
   for v, front in pairs(map.fronts_of(cells)) do rows[v] = { v = v, front = front } end
   for v, of in pairs(rows) do
      local colour, level = top_of(cells, of.front, v, task.levels)
      local function cell(du, dv, at) return colour_in(cells, of.front + du, v + dv, at) end
      local wish = map.room_before(rows, of) and
                   task.decide { top_colour = colour, top_level = level, side = map.name_of(index), cell = cell }
      if wish then due[v] = of end
   end
   return due
end

return DueRows
