-- SPDX-License-Identifier: MIT
-- What a robot sweeps when it turns on the spot, as seen from above. Its middle goes round the pivot: the
-- effector reaches out before that, the body behind it.

local Sweep = {}
Sweep.__index = Sweep

local ROUND = 2 * math.pi
local SPARE = 0.015            -- m, about what a turn sweeps
local HALF_DIAGONAL = 0.039    -- m, of a block

-- The rectangle from the pivot to an end `ahead` of it, or behind: {direction, length, half_width}, rad, m, m.
local function part(ahead, half_width)
   return { direction = ahead < 0 and math.pi or 0, length = math.abs(ahead), half_width = half_width }
end

-- parts: as above; chassis: those that stand on the floor; reach: of the farthest corner, m from the pivot; room: about the
-- pivot, that a turn all round takes, m; from_block: likewise to a block's middle.
function Sweep.new(description)
   local effector, body, pivot = description.effector, description.body, description.drive.pivot
   local self = setmetatable({
      pivot = pivot, reach = 0,
      parts = {
         part(effector.front - pivot, effector.half_width), part(body.front - pivot, body.half_width),
         part(-body.back - pivot, body.half_width),
      },
   }, Sweep)
   self.chassis = { self.parts[2], self.parts[3] }
   for _, one in ipairs(self.parts) do
      self.reach = math.max(self.reach, math.sqrt(one.length ^ 2 + one.half_width ^ 2))
   end
   self.room = self.reach + SPARE
   self.from_block = self.room + HALF_DIAGONAL
   return self
end

-- Between which angles from its middle line, to each side, a part wider and longer by `spare` lies at some
-- distance from the pivot; nil where it does not reach.
local function angles_at(one, away, spare)
   local length, half_width = one.length + spare, one.half_width + spare
   if away > math.sqrt(length ^ 2 + half_width ^ 2) then return nil end
   return math.acos(math.min(1, length / away)), math.asin(math.min(1, half_width / away))
end

-- Whether what has a bearing from a part comes between two angles of its in a turn to the left.
local function comes_between(bearing, turn, low, high)
   return (bearing - low) % ROUND <= turn + high - low
end

-- Whether a turn by `angle` (left when positive) comes within `spare` m of a place of the robot's frame that
-- is not under the robot from the first. Of these parts of it, or all.
function Sweep:touches(x, y, angle, spare, parts)
   local sign, touched = angle < 0 and -1 or 1, false
   local dx = x - self.pivot
   local away, bearing = math.max(math.sqrt(dx * dx + y * y), 1e-6), sign * math.atan(y, dx)
   for _, one in ipairs(parts or self.parts) do
      local from = bearing - one.direction
      local low, high = angles_at(one, away, 0)
      if low and (comes_between(from, 0, low, high) or comes_between(from, 0, -high, -low)) then
         return false
      end
      low, high = angles_at(one, away, spare)
      touched = touched or low and (comes_between(from, math.abs(angle), low, high) or
                                    comes_between(from, math.abs(angle), -high, -low)) or false
   end
   return touched
end

-- How far a ray of the robot's frame runs from where it begins until no turn sweeps it, m.
function Sweep:room_along(from, to)
   local x, y = from.x - self.pivot, from.y
   local length = math.sqrt(to.x ^ 2 + to.y ^ 2)
   local along = (x * to.x + y * to.y) / length
   local root = along ^ 2 - (x ^ 2 + y ^ 2 - self.reach ^ 2)
   return root > 0 and math.max(0, math.sqrt(root) - along) / length or 0
end

return Sweep
