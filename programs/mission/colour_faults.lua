-- SPDX-License-Identifier: MIT
-- Which brick shows a colour that it should not. Every order of work ends in one structure, which the task has: where
-- the bricks that a robot knows fit into it in one way only but for one brick's colour, that brick is wrong, and its
-- colour is known. Sound if all bricks are in cells of the structure and at most one of them is wrong: then the true way
-- to fit them is among those that count, so that what all of these agree on is true.

local ColourFaults = {}

-- x, y of a cell after so many quarter turns.
local TURNS = {
   function(u, v) return u, v end,
   function(u, v) return -v, u end,
   function(u, v) return -u, -v end,
   function(u, v) return v, -u end,
}

local function key_of(x, y, z) return x .. ' ' .. y .. ' ' .. z end

-- By cell, what stands there in the end; `structure`: a list of {x, y, level, colour}.
local function colours_of(structure)
   local out = {}
   for _, brick in ipairs(structure) do
      local x, y, level, colour = table.unpack(brick)
      out[key_of(x, y, level)] = colour
   end
   return out
end

-- The one brick, of those known, whose colour is another than its cell's, and that cell's colour; nil where one is in no
-- cell of the structure, or several are wrong, and nil and true where none is.
local function fault_of(known, colours, turn, dx, dy)
   local wrong, right
   for _, brick in ipairs(known) do
      local x, y = turn(brick.u, brick.v)
      local colour = colours[key_of(x + dx, y + dy, brick.level)]
      if not colour then return nil end
      if colour ~= brick.colour then
         if wrong then return nil end
         wrong, right = brick, colour
      end
   end
   return wrong, right or true
end

-- Of bricks {u, v, level, colour}, in cells of a robot's own, the one that is wrong, and the colour that it should have; nil
-- where they fit without a fault, or more than one may be it.
function ColourFaults.find(known, structure)
   local first, wrong, right = known[1], nil, nil
   if not first then return nil end
   local colours = colours_of(structure)
   for _, turn in ipairs(TURNS) do
      local x, y = turn(first.u, first.v)
      for _, brick in ipairs(structure) do
         if brick[3] == first.level then
            local fault, colour = fault_of(known, colours, turn, brick[1] - x, brick[2] - y)
            if fault and wrong and (fault ~= wrong or colour ~= right) or colour == true then return nil end
            if fault then wrong, right = fault, colour end
         end
      end
   end
   return wrong, right
end

return ColourFaults
