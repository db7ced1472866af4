-- SPDX-License-Identifier: MIT
-- Structures: blocks that stand next to each other, with the frame of the lattice that fits them.

local geometry = require 'common.geometry'

local SIDE, near, round = geometry.SIDE, geometry.near, geometry.round
local LINK = 1.25 * SIDE       -- nearer blocks are of one structure
local ASKEW = 0.2              -- rad, by which no two blocks of a lattice are off

local structures = {}

-- The yaw of blocks that stand squarely to each other, modulo a quarter turn.
function structures.mean_yaw(blocks)
   local c, s = 0, 0
   for _, block in ipairs(blocks) do
      c, s = c + math.cos(4 * block.yaw) / block.turned, s + math.sin(4 * block.yaw) / block.turned
   end
   return math.atan(s, c) / 4
end

local function fit(blocks)
   local first = blocks[1]
   local frame = { x = first.x, y = first.y, yaw = structures.mean_yaw(blocks) }
   local x, y, cells = 0, 0, {}
   for i, block in ipairs(blocks) do
      local u, v = geometry.into(frame, block.x, block.y)
      local cell = { round(u / SIDE), round(v / SIDE), block.level or geometry.level_of(block.z) }
      cells[i] = cell
      x, y = x + u - cell[1] * SIDE, y + v - cell[2] * SIDE
   end
   local n = #blocks
   frame.x, frame.y = geometry.out_of(frame, x / n, y / n)
   return { blocks = blocks, cells = cells, frame = frame }
end

-- Those of a list that the block at `first` is linked with; their places in it get true in `group`.
local function linked_with(first, blocks, group, link)
   local out, open = {}, { first }
   group[first] = true
   while #open > 0 do
      local at = table.remove(open)
      table.insert(out, blocks[at])
      for j, other in ipairs(blocks) do
         if not group[j] and near(blocks[at], other, link) then
            group[j] = true
            table.insert(open, j)
         end
      end
   end
   return out
end

-- Groups of linked blocks, each with a lattice's frame fitted to it: blocks[i] is in cells[i],
-- {along, across, level}, whose middle is out_of(frame, 55 mm * along, 55 mm * across). Of those
-- blocks alone that are `wanted`, if that is given; `link` in m.
function structures.of(blocks, wanted, link)
   local chosen, group, out = {}, {}, {}
   for _, known in ipairs(blocks) do
      if not wanted or wanted(known) then table.insert(chosen, known) end
   end
   for i in ipairs(chosen) do
      if not group[i] then table.insert(out, fit(linked_with(i, chosen, group, link or LINK))) end
   end
   return out
end

-- A block's yaw, as all that it is linked to and that stands squarely to it says.
function structures.square_of(block, blocks)
   for _, structure in ipairs(structures.of(blocks)) do
      local own, square = false, {}
      for _, known in ipairs(structure.blocks) do
         own = own or known.id == block.id
         if math.abs(geometry.wrap_quarter(known.yaw - block.yaw)) < ASKEW then table.insert(square, known) end
      end
      if own then return structures.mean_yaw(square) end
   end
   return block.yaw
end

return structures
