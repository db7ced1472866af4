-- SPDX-License-Identifier: MIT
-- Blocks in the picture, from the tags on their faces and the LEDs about these. Blocks stand upright
-- on the floor or on each other: that tells the height of a tag, and more than its size does.
--
-- A detection is {x, y, z, yaw, level, colour, top, variance, turned, tags}: yaw modulo a quarter
-- turn; level nil where it stands on none; colour 0 (dark) to `kinds`, nil where its LEDs do not say;
-- top: its upper tag was seen; variance (m²) of its place and `turned` (rad²), of its yaw.

local geometry = require 'common.geometry'
local led_code = require 'common.led_code'

local SIDE, HALF = geometry.SIDE, geometry.HALF
local TAG = 0.024              -- m, a tag's side
local TAG_TO_MIDDLE = 0.0285   -- from a tag to its block's middle
local TAG_HEIGHT = 0.001       -- of a tag over its face
local LED_OFFSET = 0.020
local LEDS = { { 1, 0 }, { 0, 1 }, { -1, 0 }, { 0, -1 } }
local MERGE = HALF             -- detections nearer than this are one block
local PLAIN, SURE = 4, 16      -- px, of depth that a tag shows, to tell which way it tilts, and to be sure though corners are
                               -- off by 2 px
local OFF_LEVEL = 0.015        -- m, by which a tag may be off the height that a level gives
local OVER = 0.02              -- m, of the eye over a tag, for its height to tell how far away it is
local PLACE_ERROR = 0.0004     -- m, of a block 0.1 m away; grows with the distance's square

local BlockDetector = {}
BlockDetector.__index = BlockDetector

function BlockDetector.new(robot, camera)
   return setmetatable({ robot = robot, camera = camera, kinds = led_code.PLAIN }, BlockDetector)
end

-- What the four LEDs show about a tag that is at a place of the robot's frame, of a block that stands so.
function BlockDetector:colour_about(place, standing, eye, turn)
   local word, back, normal, right = {}, turn:inverse(), standing.normal, standing.right
   local up = vector3(normal):cross(right)
   for i, led in ipairs(LEDS) do
      local way = right * (LED_OFFSET * led[1]) + up * (LED_OFFSET * led[2]) - normal * TAG_HEIGHT
      word[i] = self.robot.camera_system.detect_led((place + way - eye):rotate(back))
   end
   return led_code.kind_of(word, self.kinds)
end

local function unit(v)
   local length = v:length()
   return vector3(v.x / length, v.y / length, v.z / length)  -- ARGoS has no /
end

-- How a block stands of which a tag at `place` has this normal, and this direction to its right; nil when it would not
-- stand upright. Both are put right to what they are in an upright block. The second result says whether it stands on a
-- level.
local function standing_with(place, eye, normal, right)
   local top = normal.z > 0.7
   if not top and math.abs(normal.z) > 0.5 then return nil end
   local level = geometry.level_of(place.z - (top and TAG_TO_MIDDLE or 0))
   local height = SIDE * level + (top and SIDE + TAG_HEIGHT or HALF)
   local stands = level >= 0 and math.abs(height - place.z) < OFF_LEVEL
   normal = top and vector3(0, 0, 1) or unit(vector3(normal.x, normal.y, 0))
   right = unit(right - normal * right:dot(normal))
   return { axis = top and right or normal, normal = normal, right = right, top = top, height = height,
            level = stands and eye.z - height > OVER and level or nil }, stands
end

-- What a tag says of how its block stands, and what else it may be, or nil. A tag that tilts away from the camera looks
-- nearly as one that tilts towards it: when few pixels tell the two apart, the height does, where either may stand on a
-- level.
function BlockDetector:standings_of(tag, place, eye, turn)
   local orientation = turn * tag.orientation
   local normal, right = vector3(0, 0, 1):rotate(orientation), vector3(1, 0, 0):rotate(orientation)
   local distance, ray = (place - eye):length(), unit(place - eye)
   local depth = self.camera:focal() * vector3(normal):cross(ray):length() * (TAG / distance) ^ 2
   local first, stands = standing_with(place, eye, normal, right)
   if depth >= SURE then return first end
   normal, right = ray * (2 * normal:dot(ray)) - normal, right - ray * (2 * right:dot(ray))
   local mirrored, stands_so = standing_with(place, eye, normal, right)
   if depth < PLAIN and not stands and (stands_so or not first) then return mirrored, first end
   return first, mirrored
end

-- A block with a tag at a place, that stands so, both in the robot's frame: where the height of the tag is known, the
-- line through its middle says the rest far better than the tag's size. It is given in the frame of the robot's pose; the
-- second result is where in the robot's frame its tag is then.
function BlockDetector:block_as(standing, place, eye, pose)
   local level, axis = standing.level, standing.axis
   local free = place.z - standing.normal.z * TAG_TO_MIDDLE
   if level then place = eye + (place - eye) * ((standing.height - eye.z) / (place.z - eye.z)) end
   local back = standing.top and 0 or TAG_TO_MIDDLE
   local distance = (place - eye):length()
   local x, y = geometry.out_of(pose, place.x - axis.x * back, place.y - axis.y * back)
   return {
      x = x, y = y, z = level and SIDE * level + HALF or free, level = level, yaw = math.atan(axis.y, axis.x) + pose.yaw,
      top = standing.top, variance = (PLACE_ERROR * (distance / 0.1) ^ 2) ^ 2, tags = 1,
      -- of the yaw: a tag on top shows it plainly, one in front by how it tilts
      turned = (distance / (self.camera:focal() * TAG) * (standing.top and 1 or distance / TAG)) ^ 2,
   }, place
end

-- A block from one of its tags, or nil: of two that it may be, one that `is_known(block)`.
function BlockDetector:block_of(tag, eye, turn, pose, is_known)
   local place = vector3(tag.position):rotate(turn) + eye
   local standing, other = self:standings_of(tag, place, eye, turn)
   local block, at
   if standing then block, at = self:block_as(standing, place, eye, pose) end
   if other and not (block and is_known(block)) then
      local second, second_at = self:block_as(other, place, eye, pose)
      if is_known(second) then block, at, standing = second, second_at, other end
   end
   if block then block.colour = self:colour_about(at, standing, eye, turn) end
   return block
end

-- Two tags of one block.
local function merge(into, other)
   local gain = into.variance / (into.variance + other.variance)
   into.x = into.x + gain * (other.x - into.x)
   into.y = into.y + gain * (other.y - into.y)
   local turn = into.turned / (into.turned + other.turned)
   into.yaw = into.yaw + turn * geometry.wrap_quarter(other.yaw - into.yaw)
   into.turned = into.turned * (1 - turn)
   if (into.colour or 0) == 0 then into.colour = other.colour end
   into.top = into.top or other.top
   into.variance = into.variance * (1 - gain)
   into.tags = into.tags + 1
end

local function add(found, block)
   for _, other in ipairs(found) do
      if geometry.near(block, other, MERGE) then return merge(other, block) end
   end
   table.insert(found, block)
end

-- Blocks in the picture, in the frame that the robot's pose is given in; once in each step. `is_known(block)`: whether one
-- stands there as far as the robot remembers.
function BlockDetector:detect(now, is_known)
   local pose, lift = self.camera:taken_from(now)
   local eye, turn = self.camera:pose(lift)
   local found = {}
   for _, tag in ipairs(self.robot.camera_system.tags) do
      local block = self:block_of(tag, eye, turn, pose, is_known)
      if block then add(found, block) end
   end
   return found
end

return BlockDetector
