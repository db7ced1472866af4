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

-- Colour of the brick that in the end stands in a cell of a robot's, if these lie in a way {quarters, dx, dy}: turned by so
-- many, and moved; or nil.
function Target:colour(way, u, v, level)
   local x, y = TURNS[way.quarters + 1](u, v)
   return self.colours[key_of(x + way.dx, y + way.dy, level)]
end

-- All ways in which a robot's brick {u, v, level} is one of those that stand in the end, whatever their colours.
function Target:ways(brick)
   local out = {}
   for quarters = 0, 3 do
      local x, y = TURNS[quarters + 1](brick.u, brick.v)
      for _, own in ipairs(self.bricks) do
         if own[3] == brick.level then table.insert(out, { quarters = quarters, dx = own[1] - x, dy = own[2] - y }) end
      end
   end
   return out
end

-- The cells {u, v, level} of a robot's in which bricks stand in the end, if these lie in a way.
function Target:cells_in(way)
   local out = {}
   for _, own in ipairs(self.bricks) do
      local u, v = TURNS[(4 - way.quarters) % 4 + 1](own[1] - way.dx, own[2] - way.dy)
      table.insert(out, { u = u, v = v, level = own[3] })
   end
   return out
end

-- Whether in the end nothing stands before a cell on its level, seen from where `du`, `dv` lead.
function Target:is_open(way, cell, du, dv)
   for far = 1, #self.bricks do
      if self:colour(way, cell.u + far * du, cell.v + far * dv, cell.level) then return false end
   end
   return true
end

-- How many of a robot's bricks {u, v, level, colour} are not as in the end, if they lie so; counted up to `most`.
function Target:off_in(way, known, most)
   local off = 0
   for _, brick in ipairs(known) do
      if self:colour(way, brick.u, brick.v, brick.level) ~= brick.colour then off = off + 1 end
      if off == most then break end
   end
   return off
end

-- The ways in which all of them are, but for `off` at most (default: none); some more than once.
function Target:fits(known, off)
   local out, most = {}, (off or 0) + 1
   -- the first ones may be those that are off
   for i = 1, math.min(most, #known) do
      for _, way in ipairs(self:ways(known[i])) do
         if self:off_in(way, known, most) < most then table.insert(out, way) end
      end
   end
   return out
end

-- By the number of quarter turns, from 0 on, how many are not, at least, counted up to 2. One that is off may have a wrong
-- colour, or have been misread; two hardly.
function Target:least_off(known)
   local least = { [0] = 2, 2, 2, 2 }
   -- the first may be the one that is off
   for i = 1, math.min(2, #known) do
      for _, way in ipairs(self:ways(known[i])) do
         least[way.quarters] = math.min(least[way.quarters], self:off_in(way, known, 2))
      end
   end
   return least
end

return Target
