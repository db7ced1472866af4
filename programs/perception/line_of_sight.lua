-- SPDX-License-Identifier: MIT
-- Whether a block would be seen: one of its tags wholly in the picture and no known block before it.
-- What would be seen, and is not, is not there.

local geometry = require 'common.geometry'

local SIDE, HALF = geometry.SIDE, geometry.HALF
local TAG_TO_MIDDLE = 0.0285
local HALF_TAG = 0.012
local WIDEST = math.rad(75)              -- between a tag's normal and the line to the camera, if none is said
local SPARE = math.rad(2)                -- of that, since the robot is not quite where it believes
local NEAREST, FARTHEST = 0.05, 0.48     -- m, between which a tag is detected
local MARGIN = 4                         -- px
local BETWEEN = 2 * SIDE                 -- m, from the line to a block, more than of any that hides one of its tags
local ABOUT = 0.75                       -- m, from the eye, likewise of what is seen at all
local FACES = { { -1, 0, 0 }, { 0, 0, 1 }, { 0, 1, 0 }, { 0, -1, 0 } }
local CORNERS = { { 1, 1 }, { 1, -1 }, { -1, 1 }, { -1, -1 } }

-- remembered(): set by who knows a structure: its bricks that were ever seen, {x, y, z, yaw} of the odometry frame.
local LineOfSight = {}
LineOfSight.__index = LineOfSight

function LineOfSight.new(odometry, camera, tracker)
   local self = setmetatable({
      odometry = odometry, camera = camera, tracker = tracker, remembered = function() return {} end,
   }, LineOfSight)
   self:reads_up_to(WIDEST)
   return self
end

-- Of these blocks' tags no camera reads one that it sees more obliquely; rad, from its normal.
function LineOfSight:reads_up_to(widest)
   self.steepest = math.cos(widest - SPARE)
end

-- Whether the line from `eye` to `p` goes through a block; all in the robot's frame.
local function crosses(eye, p, block)
   local enter, leave = 0, 1
   local c, s = math.cos(block.yaw), math.sin(block.yaw)
   local function turned(x, y) return c * x + s * y, -s * x + c * y end
   local fx, fy = turned(eye.x - block.x, eye.y - block.y)
   local wx, wy = turned(p.x - eye.x, p.y - eye.y)
   for _, axis in ipairs { { fx, wx }, { fy, wy }, { eye.z - block.z, p.z - eye.z } } do
      local from, way = axis[1], axis[2]
      if math.abs(way) < 1e-9 then
         if math.abs(from) >= HALF then return false end
      else
         local a, b = (-HALF - from) / way, (HALF - from) / way
         enter, leave = math.max(enter, math.min(a, b)), math.min(leave, math.max(a, b))
      end
   end
   return leave - enter > 1e-9
end

-- A place of the odometry frame in the robot's.
function LineOfSight:in_robot_frame(place, yaw, z)
   local pose = self.odometry.pose
   local out = { yaw = yaw - pose.yaw, z = z }
   out.x, out.y = geometry.into(pose, place.x, place.y)
   return out
end

-- Known blocks in the robot's frame, also those that were out of the picture for long: all that may hide what is seen.
function LineOfSight:blocks_about()
   local eye, out = self.camera:pose(), {}
   for _, blocks in ipairs { self.tracker.tracks, self.remembered() } do
      for _, known in ipairs(blocks) do
         local other = self:in_robot_frame(known, known.yaw, known.z)
         if geometry.apart(eye, other) < ABOUT then table.insert(out, other) end
      end
   end
   return out
end

-- Those of them that may stand between the eye and a block, and are not that block itself.
function LineOfSight:before(own, about)
   local eye, out = self.camera:pose(), {}
   local x, y, length = eye.x, eye.y, geometry.apart(eye, own)
   local c, s = (own.x - x) / length, (own.y - y) / length
   for _, other in ipairs(about) do
      local fx, fy = other.x - x, other.y - y
      local aside, along = c * fy - s * fx, c * fx + s * fy
      if aside < BETWEEN and aside > -BETWEEN and along > -BETWEEN and along < length + BETWEEN and
         not geometry.near(other, own, HALF) then table.insert(out, other) end
   end
   return out
end

-- Middle and axes of a face's tag, in the robot's frame: normal, right, up.
local function tag_of(block, face)
   local c, s = math.cos(block.yaw), math.sin(block.yaw)
   local function turned(a, b, d) return vector3(c * a - s * b, s * a + c * b, d) end
   local normal = turned(face[1], face[2], face[3])
   local right = face[3] == 1 and turned(0, 1, 0) or turned(-face[2], face[1], 0)
   local up = vector3(normal):cross(right)  -- ARGoS changes the first
   return vector3(block.x, block.y, block.z) + normal * TAG_TO_MIDDLE, normal, right, up
end

-- Whether a block in the robot's frame shows one of its tags.
function LineOfSight:shows_tag(own, others)
   local eye, turn = self.camera:pose()
   local back = turn:inverse()
   local function visible(p)
      local q = (p - eye):rotate(back)
      if q.z < NEAREST or q.z > FARTHEST or not self.camera:frames(q, MARGIN) then return false end
      for _, other in ipairs(others) do
         if crosses(eye, p, other) then return false end
      end
      return true
   end
   for _, face in ipairs(FACES) do
      local centre, normal, right, up = tag_of(own, face)
      local way = eye - centre
      local all = way:dot(normal) >= way:length() * self.steepest
      for _, corner in ipairs(CORNERS) do
         all = all and visible(centre + right * (HALF_TAG * corner[1]) + up * (HALF_TAG * corner[2]))
      end
      if all then return true end
   end
   return false
end

-- Whether a block with its middle at x, y of the odometry frame, on this level and squarely to
-- `heading`, would be seen now. `about`: blocks_about(), from who asks of several blocks in one step.
function LineOfSight:would_see(x, y, level, heading, about)
   local own = self:in_robot_frame({ x = x, y = y }, heading, SIDE * level + HALF)
   return self:shows_tag(own, self:before(own, about or self:blocks_about()))
end

return LineOfSight
