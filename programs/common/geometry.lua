-- SPDX-License-Identifier: MIT
-- Angles, frames and the block's measures. Poses and frames are {x, y, yaw} in m and rad.

local geometry = {}

geometry.SIDE = 0.055          -- of a block
geometry.HALF = 0.0275

local QUARTER = math.pi / 2

function geometry.wrap(angle)
   return (angle + math.pi) % (2 * math.pi) - math.pi
end

-- The smallest turn that leaves a cube as it is.
function geometry.wrap_quarter(angle)
   return (angle + QUARTER / 2) % QUARTER - QUARTER / 2
end

function geometry.clamp(value, low, high)
   return math.max(low, math.min(high, value))
end

function geometry.round(value)
   return math.floor(value + 0.5)
end

-- From a frame's coordinates to those that the frame is given in, and back.
function geometry.out_of(frame, x, y)
   local c, s = math.cos(frame.yaw), math.sin(frame.yaw)
   return frame.x + c * x - s * y, frame.y + s * x + c * y
end

function geometry.into(frame, x, y)
   local c, s = math.cos(frame.yaw), math.sin(frame.yaw)
   local dx, dy = x - frame.x, y - frame.y
   return c * dx + s * dy, -s * dx + c * dy
end

-- How far apart two places are as seen from above.
function geometry.apart(a, b)
   return math.sqrt((a.x - b.x) ^ 2 + (a.y - b.y) ^ 2)
end

-- Of the way from a place to another.
function geometry.angle_to(from, to)
   return math.atan(to.y - from.y, to.x - from.x)
end

-- The square of the distance of two points, or nil where it is not below `most`.
function geometry.near(a, b, most)
   local dx, dy, dz = a.x - b.x, a.y - b.y, a.z - b.z
   local square = dx * dx + dy * dy + dz * dz
   return square < most * most and square or nil
end

-- The level of a block whose middle is so high.
function geometry.level_of(z)
   return geometry.round((z - geometry.HALF) / geometry.SIDE)
end

return geometry
