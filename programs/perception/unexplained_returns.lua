-- SPDX-License-Identifier: MIT
-- What stands about a robot and is no known block: most likely another robot.
--
-- The chassis' rangefinders see along straight lines. What they saw is kept for a while as points on
-- a grid, in the odometry frame, until one looks through it again. A point on a known block is the
-- block's; any other is unexplained. Those that see but a block in the robot's own hand tell nothing.

local geometry = require 'common.geometry'

local GRID = 0.02              -- m, between two points that are kept apart
local KEPT = 10                -- s
local SEES = 0.15              -- m, as far as a rangefinder surely sees through
local CELL = 0.030             -- m, more than the grid has between two places that are the same point
local SPARE = 0.012            -- m, about what a turn sweeps
local OF_BLOCK = 0.050         -- m, from a block's middle to points on it

local UnexplainedReturns = {}
UnexplainedReturns.__index = UnexplainedReturns
UnexplainedReturns.LOOK_RIM = 0.03  -- m/s, in a turn to look: a rangefinder measures every 10 degrees

function UnexplainedReturns.new(odometry, ranges, tracker, sweep)
   local rays = {}
   for _, ray in ipairs(ranges:chassis_rays()) do
      local from, to = ray.from, ray.to
      table.insert(rays, { name = ray.name, x = from.x, y = from.y, way_x = to.x, way_y = to.y })
   end
   return setmetatable({
      odometry = odometry, ranges = ranges, tracker = tracker, sweep = sweep,
      points = {},                   -- by place on the grid: {x, y, time}
      rays = rays,                   -- {name, x, y, way_x, way_y}: place and direction in the robot's frame
      hidden = function() return false end,  -- set by who knows: whether a rangefinder sees but the block in hand
   }, UnexplainedReturns)
end

local function key_of(x, y)
   return math.floor(x / GRID + 0.5) * 65536 + math.floor(y / GRID + 0.5)
end

-- Whether a ray may pass through one of some points {x, y} of the robot's frame before it has gone so far.
local function may_pass(ray, far, places)
   local ray_x, ray_y, way_x, way_y, beyond = ray.x, ray.y, ray.way_x, ray.way_y, far + CELL
   for i = 1, #places do
      local place = places[i]
      local x, y = place.x - ray_x, place.y - ray_y
      local aside, along = x * way_y - y * way_x, x * way_x + y * way_y
      if aside < CELL and aside > -CELL and along > -CELL and along < beyond then return true end
   end
   return false
end

-- `places`: where the points are in the robot's frame. They are few, and most rays pass none of them.
function UnexplainedReturns:trace(ray, places)
   local pose, distance = self.odometry.pose, self.ranges:range(ray.name)
   local function at(way)
      return geometry.out_of(pose, ray.x + way * ray.way_x, ray.y + way * ray.way_y)
   end
   local far = (distance or SEES) - 1.5 * GRID
   if may_pass(ray, far, places) then
      for way = 0, far, GRID / 2 do self.points[key_of(at(way))] = nil end
   end
   if distance then
      local x, y = at(distance)
      self.points[key_of(x, y)] = { x = x, y = y, time = self.odometry.time }
      table.insert(places, { x = ray.x + distance * ray.way_x, y = ray.y + distance * ray.way_y })
   end
end

-- Once in each step, after the tracker: what is seen, and what is seen through.
function UnexplainedReturns:sense()
   local pose, places = self.odometry.pose, {}
   for key, point in pairs(self.points) do
      if self.odometry.time - point.time > KEPT then
         self.points[key] = nil
      else
         local x, y = geometry.into(pose, point.x, point.y)
         table.insert(places, { x = x, y = y })
      end
   end
   for _, ray in ipairs(self.rays) do
      if not self.hidden(ray.name) then self:trace(ray, places) end
   end
end

function UnexplainedReturns:is_of_block(point)
   for _, known in ipairs(self.tracker.tracks) do
      if (known.x - point.x) ^ 2 + (known.y - point.y) ^ 2 < OF_BLOCK ^ 2 and known.z < geometry.SIDE
      then return true end
   end
   return false
end

-- Points {x, y, time} within so far of a place, seen since a time.
function UnexplainedReturns:near(x, y, within, since)
   local out = {}
   for _, point in pairs(self.points) do
      if point.time >= since and (point.x - x) ^ 2 + (point.y - y) ^ 2 < within ^ 2 and
         not self:is_of_block(point) then table.insert(out, point) end
   end
   return out
end

-- Whether a point is on a known column that ends below a height.
function UnexplainedReturns:is_below(point, height)
   local top
   for _, known in ipairs(self.tracker.tracks) do
      if (known.x - point.x) ^ 2 + (known.y - point.y) ^ 2 < OF_BLOCK ^ 2 then
         top = math.max(top or 0, known.z + geometry.HALF)
      end
   end
   return top ~= nil and top < height
end

-- Whether a turn on the spot by `angle` (left when positive) would hit something; `over`: the height of what the
-- effector carries, which passes over lower columns.
function UnexplainedReturns:sweeps(angle, over)
   for _, point in pairs(self.points) do
      local x, y = geometry.into(self.odometry.pose, point.x, point.y)
      local parts = over and self:is_below(point, over) and self.sweep.chassis or nil
      if self.sweep:touches(x, y, angle, SPARE, parts) then return true end
   end
   return false
end

return UnexplainedReturns
