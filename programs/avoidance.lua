-- SPDX-License-Identifier: MIT
-- What stands about a robot, as its chassis rangefinders have seen it lately.
--
-- The rangefinders see along straight lines from the chassis' sides. What they saw is kept for
-- a while as points on a grid, in the odometry frame, until one looks through it again. A point
-- on a known block is the block's; any other is most likely of a robot.

local robotics = require 'robotics'
local avoidance = {}

local GRID = 0.02              -- m, between two points that are kept apart
local KEPT = 10                -- s
avoidance.LOOK_RIM = 0.03      -- m/s, in a turn to look: a rangefinder measures every 10 degrees
local SEES = 0.15              -- m, as far as a rangefinder surely sees through
local TURNING = 0.145          -- m, from the robot's middle to its effector's corners, and some more
local HALF_EFFECTOR = 0.25     -- rad, of the effector about the robot's middle
local OF_BLOCK = 0.050         -- m, from a block's middle to points on it

local points                   -- by place on the grid: {x, y, time}
local rays                     -- of the chassis' rangefinders, in the robot's frame: {name, from, to}

local function key_of(x, y)
   return math.floor(x / GRID + 0.5) * 65536 + math.floor(y / GRID + 0.5)
end

function avoidance.start()
   points, rays = {}, {}
   for number = 1, 12 do
      local name = tostring(number)
      local finder = robot.rangefinders and robot.rangefinders[name]
      if finder then
         local way = vector3(0, 0, 1):rotate(finder.transform.orientation)
         table.insert(rays, { name = name, from = finder.transform.position, to = way })
      end
   end
end

-- Call it in every step, after robotics.sense(): what is seen, and what is seen through.
function avoidance.sense()
   local now = robotics.time
   for key, point in pairs(points) do
      if now - point.time > KEPT then points[key] = nil end
   end
   for _, ray in ipairs(rays) do
      local distance = robotics.range(ray.name)
      local function at(way)
         return robotics.out_of(robotics.pose, ray.from.x + way * ray.to.x, ray.from.y + way * ray.to.y)
      end
      for way = 0, (distance or SEES) - 1.5 * GRID, GRID / 2 do points[key_of(at(way))] = nil end
      if distance then
         local x, y = at(distance)
         points[key_of(x, y)] = { x = x, y = y, time = now }
      end
   end
end

local function of_block(point)
   for _, known in ipairs(robotics.tracks) do
      if (known.x - point.x) ^ 2 + (known.y - point.y) ^ 2 < OF_BLOCK ^ 2 and known.z < robotics.SIDE
      then return true end
   end
   return false
end

-- Points {x, y, time} on what is no known block, within so far of a place, seen since a time.
function avoidance.strangers(x, y, within, since)
   local out = {}
   for _, point in pairs(points) do
      if point.time >= since and (point.x - x) ^ 2 + (point.y - y) ^ 2 < within ^ 2 and
         not of_block(point) then table.insert(out, point) end
   end
   return out
end

-- Whether a turn on the spot by `angle` (left when positive) would hit something.
function avoidance.sweeps(angle)
   local sign = angle < 0 and -1 or 1
   for _, point in pairs(points) do
      local x, y = robotics.into(robotics.pose, point.x, point.y)
      local ahead = sign * math.atan(y, x)
      if x * x + y * y < TURNING ^ 2 and ahead > HALF_EFFECTOR and
         ahead < math.abs(angle) + HALF_EFFECTOR then return true end
   end
   return false
end

return avoidance
