-- SPDX-License-Identifier: MIT
-- The robot's camera: where it is, what of the surroundings is in its picture, and from where a
-- block is seen.

local geometry = require 'common.geometry'

local LOWEST_OF_VIEW = 0.92    -- of the half height of the picture
local WHOLLY_IN_VIEW = 0.92    -- likewise of its upper half
local TAG_EDGE = 0.016         -- m, from the middle of the tag on top to its nearer edge, and some more
local TAG_FOOT = 0.014         -- m, of the tag in front, likewise down to its lower edge

local IN_TIME = 0.01           -- s, less than a step
local KEPT = 1.5               -- s, that a picture may be late

-- past: where the robot and its lift were of late: {time, pose, lift}, the latest last.
local Camera = {}
Camera.__index = Camera

function Camera.new(robot, description)
   return setmetatable({ robot = robot, description = description, past = {} }, Camera)
end

-- The eye's place and the turn from the camera's frame to the robot's, now or with the lift at a height.
function Camera:pose(height)
   local transform, anchor = self.robot.camera_system.transform, self.description.camera.anchor
   local lift = height or self.robot.lift_system.position
   return transform.position + vector3(anchor.x, anchor.y, anchor.z + lift),
          transform.orientation
end

-- Once in each step: the robot's pose and the lift's height when the picture was taken, which comes late by what
-- its time says; as they are now where that is by another clock.
function Camera:taken_from(pose)
   local now, past = self.robot.system.time or 0, self.past
   table.insert(past, { time = now, pose = { x = pose.x, y = pose.y, yaw = pose.yaw },
                        lift = self.robot.lift_system.position })
   while now - past[1].time > KEPT do table.remove(past, 1) end
   local taken = self.robot.camera_system.timestamp or now
   for i = #past, 1, -1 do
      if past[i].time < taken + IN_TIME then return past[i].pose, past[i].lift end
   end
   return past[#past].pose, past[#past].lift
end

-- px.
function Camera:focal()
   return self.description.camera.focal
end

-- Whether a point of the camera's frame is in the picture, `margin` px from its edge at least.
function Camera:frames(p, margin)
   local size, focal = self.robot.camera_system.resolution, self.description.camera.focal
   return math.abs(focal * p.x / p.z) < size.x / 2 - margin and
          math.abs(focal * p.y / p.z) < size.y / 2 - margin
end

-- Where the eye is with the lift down: m ahead of the robot, and over the floor.
function Camera:place_when_down()
   local anchor, at = self.description.camera.anchor, self.robot.camera_system.transform.position
   return at.x + anchor.x, at.z + anchor.z
end

-- The lift's height at which a mark, `ahead` of the robot at a height, is in the picture's middle:
-- the camera looks ahead and down by 45 degrees.
function Camera:lift_for(ahead, height)
   local x, z = self:place_when_down()
   return ahead - x + height - z
end

-- The least distance ahead of a block at which the tag that it shows is wholly in the picture, at a
-- height of the lift. `mark`, `before`: as BlockTracker:mark_of has them.
function Camera:nearest_in_sight(lift, mark, before)
   local x, z = self:place_when_down()
   local half = LOWEST_OF_VIEW * self.robot.camera_system.resolution.y / 2 / self.description.camera.focal
   local in_front = before > 0
   local above = z + lift - mark + (in_front and TAG_FOOT or 0)
   return x + above * (1 - half) / (1 + half) + (in_front and 0 or TAG_EDGE) + before
end

-- How far to a side the tags of a block that is so far ahead may be, to be wholly in the picture; m. The tag in its
-- front is nearer than the one on top by as much as it is lower, and the camera looks down by 45 degrees: along its
-- line of sight both are as far.
function Camera:farthest_aside(lift, block, ahead)
   local x, z = self:place_when_down()
   local half = WHOLLY_IN_VIEW * self.robot.camera_system.resolution.x / 2 / self.description.camera.focal
   local away = (ahead - x + z + lift - block.z - geometry.HALF) / math.sqrt(2)
   return half * away - TAG_EDGE
end

-- The greatest at which the tag in its front is wholly in the picture.
function Camera:farthest_in_sight(lift, block)
   local x, z = self:place_when_down()
   local half = WHOLLY_IN_VIEW * self.robot.camera_system.resolution.y / 2 / self.description.camera.focal
   return x + (z + lift - block.z - TAG_FOOT) * (1 + half) / (1 - half) + geometry.SIDE / 2
end

-- How far ahead a block is whose mark is in the picture's middle, at a height of the lift.
function Camera:centred_at(lift, mark, before)
   local anchor, at = self.description.camera.anchor, self.robot.camera_system.transform.position
   return at.x + anchor.x + at.z + anchor.z + lift - mark + before
end

return Camera
