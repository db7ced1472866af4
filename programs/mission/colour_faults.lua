-- SPDX-License-Identifier: MIT
-- Which brick shows a colour that it should not. Every order of work ends in one structure (mission/target.lua): where
-- the bricks that a robot knows fit into it in one way only but for one brick's colour, that brick is wrong, and its
-- colour is known. Sound if all bricks are in cells of the structure and at most one of them is wrong: then the true way
-- to fit them is among those that count, so that what all of these agree on is true.

local ColourFaults = {}

-- The one brick, of those known, whose colour is another than its cell's, and that cell's colour; nil where one is in no
-- cell of the structure, or several are wrong, and nil and true where none is.
local function fault_of(known, target, way)
   local wrong, right
   for _, brick in ipairs(known) do
      local colour = target:colour(way, brick.u, brick.v, brick.level)
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
function ColourFaults.find(known, target)
   if not known[1] then return nil end
   local wrong, right
   for _, way in ipairs(target:ways(known[1])) do
      local fault, colour = fault_of(known, target, way)
      if fault and wrong and (fault ~= wrong or colour ~= right) or colour == true then return nil end
      if fault then wrong, right = fault, colour end
   end
   return wrong, right
end

return ColourFaults
