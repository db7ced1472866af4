-- SPDX-License-Identifier: MIT
-- The structure in which every order of work ends, and the ways in which what a robot knows of it may lie in it.

local Target = {}
Target.__index = Target

-- x, y of a cell after so many quarter turns.
local TURNS = {
   function(u, v) return u, v end,
   function(u, v) return -v, u end,
   function(u, v) return -u, -v end,
   function(u, v) return v, -u end,
}

local function key_of(x, y, level) return x .. ' ' .. y .. ' ' .. level end

-- bricks: a list of {x, y, level, colour}; colours: by cell.
function Target.new(bricks)
   local colours = {}
   for _, brick in ipairs(bricks) do
      local x, y, level, colour = table.unpack(brick)
      colours[key_of(x, y, level)] = colour
   end
   return setmetatable({ bricks = bricks, colours = colours }, Target)
end

-- A task's, or nil where it has none.
function Target.of(task)
   local structure = task.structure
   return structure and #structure > 0 and Target.new(structure) or nil
end

-- Colour of the brick that in the end stands in a cell of a robot's, if these lie in a way {turn, dx, dy}; or nil.
function Target:colour(way, u, v, level)
   local x, y = way.turn(u, v)
   return self.colours[key_of(x + way.dx, y + way.dy, level)]
end

-- All ways in which a robot's brick {u, v, level} is one of those that stand in the end, whatever their colours.
function Target:ways(brick)
   local out = {}
   for _, turn in ipairs(TURNS) do
      local x, y = turn(brick.u, brick.v)
      for _, own in ipairs(self.bricks) do
         if own[3] == brick.level then table.insert(out, { turn = turn, dx = own[1] - x, dy = own[2] - y }) end
      end
   end
   return out
end

-- Those ways in which each of a robot's bricks {u, v, level, colour} has the colour that it has in the end.
function Target:fits(known)
   local out = {}
   for _, way in ipairs(known[1] and self:ways(known[1]) or {}) do
      local fits = true
      for _, brick in ipairs(known) do
         fits = fits and self:colour(way, brick.u, brick.v, brick.level) == brick.colour
      end
      if fits then table.insert(out, way) end
   end
   return out
end

return Target
