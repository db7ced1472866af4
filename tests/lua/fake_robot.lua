-- SPDX-License-Identifier: MIT
-- A robot for unit tests, without physics: rims ramp as commanded, the lift is where it was sent after
-- a step, the camera sees every tag of the blocks about it that faces it, magnets take the block below
-- them and let go of it where it is. Readings can be set by hand.
--
--     local fake = FakeRobot.new { { x = 0.3, y = 0, level = 0, colour = 3 } }
--     local odometry = Odometry.new(fake.robot, fake.robot.description)
--     fake:step()                      -- 0.2 s go by

local mock = require 'mock_argos'
local geometry = require 'common.geometry'
local led_code = require 'common.led_code'
local profile = require 'motion.profile'

-- What programs find in a state of the simulation.
vector3, quaternion = mock.vector3, mock.quaternion  -- luacheck: globals vector3 quaternion

local PERIOD = 0.2             -- s
local FULL = 250               -- of the charge
local NOTHING = 0.2            -- m, what rangefinders say when nothing is near
local TAG_TO_MIDDLE = 0.0285
local LOOKS_DOWN = quaternion(0.75 * math.pi, vector3(0, 1, 0)) * quaternion(-0.5 * math.pi, vector3(0, 0, 1))
-- Turns of a tag from lying on top to each face: its z axis points out of the block.
local FACES = { quaternion() }
for quarter = 0, 3 do
   table.insert(FACES, quaternion(quarter * math.pi / 2, vector3(0, 0, 1)) *
                       quaternion(math.pi / 2, vector3(0, 1, 0)))
end

local FakeRobot = {}
FakeRobot.__index = FakeRobot

-- A robot like the one of 2017, in round numbers.
local function description_of(finders)
   local rangefinders = {}
   for name, finder in pairs(finders) do
      rangefinders[name] = { x = finder.transform.position.x, range = 0.2, calibration = 'metres' }
   end
   rangefinders.left.x, rangefinders.right.x = 0.0585, 0.0585
   return {
      name = 'fake', drive = { track = 0.070, pivot = 0.030, speed = 0.32, acceleration = 1 },
      lift = { top = 0.137, tolerance = 0.001 }, effector = { front = 0.130, half_width = 0.030 },
      body = { front = 0.045, back = 0.075, half_width = 0.044 },
      magnets = { ahead = 0.094, neutral = 165 },
      camera = { anchor = { x = 0.056, y = 0, z = 0.080 }, focal = 900 }, rangefinders = rangefinders,
   }
end

-- Round the chassis every 30 degrees from ahead to the left, and four on the arm.
local function rangefinders()
   local out = {}
   for _, name in ipairs { 'front', 'underneath', 'left', 'right' } do out[name] = 0 end
   for number = 1, 12 do out[tostring(number)] = math.rad(30 * (number - 1)) end
   for name, angle in pairs(out) do
      out[name] = { proximity = NOTHING, transform = {
         position = vector3(0.045 * math.cos(angle), 0.045 * math.sin(angle), 0),
         orientation = quaternion(math.pi / 2, vector3(-math.sin(angle), math.cos(angle), 0)),
      } }
   end
   return out
end

function FakeRobot:tables()
   local sent, finders = self.sent, rangefinders()
   return {
      id = 'fake', params = {}, system = { time = 0 }, description = description_of(finders),
      differential_drive = {
         encoders = { left = 0, right = 0 },
         set_target_velocity = function(left, right) sent.left, sent.right = left, -right end,
      },
      lift_system = { position = 0, set_position = function(height) sent.lift = height end },
      electromagnet_system = {
         voltage = FULL, set_discharge_mode = function(mode) sent.discharge = mode end,
      },
      camera_system = {
         enable = function() sent.camera = true end, tags = {}, resolution = { x = 640, y = 360 },
         transform = { anchor = 'arm', position = vector3(0.056, 0, 0.036), orientation = LOOKS_DOWN },
         detect_led = function(at) return self:led_at(at) end,
      },
      rangefinders = finders,
      simple_radios = { nfc = { send = function(message) self:colour(message) end, recv = {} } },
   }
end

function FakeRobot.new(blocks)
   local self = setmetatable({
      blocks = blocks or {}, pose = { x = 0, y = 0, yaw = 0 },
      sent = { left = 0, right = 0, lift = 0, discharge = 'disable' },
   }, FakeRobot)
   self.robot = self:tables()
   self:look()
   return self
end

-- The rims' ramp, and the way that it makes: the pivot goes ahead, and the middle round it.
function FakeRobot:drive()
   local encoders, drive = self.robot.differential_drive.encoders, self.robot.description.drive
   local before, most = { encoders.left, -encoders.right }, drive.acceleration * PERIOD
   local after, way = {}, {}
   for i, wanted in ipairs { self.sent.left, self.sent.right } do
      after[i] = geometry.clamp(wanted, before[i] - most, before[i] + most)
      way[i] = profile.distance(before[i], after[i], PERIOD, drive.acceleration)
   end
   local turn, ahead = (way[2] - way[1]) / drive.track, (way[1] + way[2]) / 2
   local x, y = geometry.out_of(self.pose, drive.pivot, 0)
   local heading = self.pose.yaw + turn / 2
   self.pose.yaw = geometry.wrap(self.pose.yaw + turn)
   self.pose.x, self.pose.y = x + ahead * math.cos(heading), y + ahead * math.sin(heading)
   self.pose.x, self.pose.y = geometry.out_of(self.pose, -drive.pivot, 0)
   encoders.left, encoders.right = after[1], -after[2]
end

-- Current drains the charge. The block right below the magnets comes along with a constructive one;
-- it is let go where the charge has fallen to what takes the field away.
function FakeRobot:magnetise()
   local magnets, mode = self.robot.electromagnet_system, self.sent.discharge
   local change = mode == 'disable' and 10 or -5
   magnets.voltage = geometry.clamp(magnets.voltage + change, 0, FULL)
   if mode == 'constructive' and not self.held and self.robot.lift_system.position < 0.01 then
      self.held = self:block_below()
   end
   if mode == 'destructive' and magnets.voltage < 1.1 * self.robot.description.magnets.neutral then
      if self.held then
         self.held.level = geometry.round(self.robot.lift_system.position / geometry.SIDE)
      end
      self.held = nil
   end
   if not self.held then return end
   self.held.x, self.held.y = geometry.out_of(self.pose, self.robot.description.magnets.ahead, 0)
   self.held.yaw = self.pose.yaw
end

function FakeRobot:block_below()
   local x, y = geometry.out_of(self.pose, self.robot.description.magnets.ahead, 0)
   for _, block in ipairs(self.blocks) do
      if geometry.apart(block, { x = x, y = y }) < 0.004 and (block.level or 0) == 0 then return block end
   end
end

-- What the radio says to the block that is held, which answers unless it is mute.
function FakeRobot:colour(message)
   if not self.held or self.held.mute then return end
   self.answers = { { string.byte('a'), table.unpack(message) } }
   local colour = message[1] - 48
   if message[1] == string.byte('w') then
      local word = {}
      for i = 1, 4 do word[i] = message[i + 1] - 48 end
      colour = led_code.kind_of(word, 62)
   end
   self.held.colour = colour
end

-- Of the arm, as its block or one on the floor right before it gives them.
function FakeRobot:feel()
   local finders, description = self.robot.rangefinders, self.robot.description
   local back = description.magnets.ahead - geometry.HALF - description.rangefinders.left.x
   local gap = self.held and back or NOTHING
   for _, block in ipairs(self.blocks) do
      local x, y = geometry.into(self.pose, block.x, block.y)
      if not self.held and x > 0 and math.abs(y) < geometry.HALF and self.robot.lift_system.position < 0.02 then
         gap = math.min(gap, math.max(0, x - geometry.HALF - description.rangefinders.left.x))
      end
   end
   finders.left.proximity, finders.right.proximity = gap, gap
   finders.underneath.proximity = (self.held or self:block_below()) and
      (self.held and 0 or self.robot.lift_system.position) or NOTHING
end

function FakeRobot:step()
   self:drive()
   self.robot.lift_system.position = self.sent.lift
   self.robot.system.time = self.robot.system.time + PERIOD
   self.robot.simple_radios.nfc.recv, self.answers = self.answers or {}, nil
   self:magnetise()
   self:feel()
   self:look()
end

-- Eye and turn of the camera.
function FakeRobot:eye()
   local anchor, transform = self.robot.description.camera.anchor, self.robot.camera_system.transform
   return transform.position + vector3(anchor.x, anchor.y, anchor.z + self.robot.lift_system.position),
          transform.orientation
end

-- Whether a place of the camera's frame is in the picture.
function FakeRobot:frames(p)
   local size, focal = self.robot.camera_system.resolution, self.robot.description.camera.focal
   return p.z > 0.05 and math.abs(focal * p.x / p.z) < size.x / 2 and
          math.abs(focal * p.y / p.z) < size.y / 2
end

-- The tag of one face, in the camera's frame; nil when it faces away or is out of the picture.
function FakeRobot:tag_of(block, face)
   local eye, turn = self:eye()
   local x, y = geometry.into(self.pose, block.x, block.y)
   local stands = quaternion((block.yaw or 0) - self.pose.yaw, vector3(0, 0, 1)) * face
   local normal = vector3(0, 0, 1):rotate(stands)
   local place = vector3(x, y, geometry.SIDE * ((block.level or 0) + 0.5)) + normal * TAG_TO_MIDDLE
   local way = eye - place
   if way:dot(normal) < 0.35 * way:length() then return nil end
   local seen = (way * -1):rotate(turn:inverse())
   if not self:frames(seen) then return nil end
   return { position = seen, orientation = turn:inverse() * stands, colour = block.colour or 0 }
end

-- Whether another block stands on top.
function FakeRobot:is_covered(block)
   for _, other in ipairs(self.blocks) do
      if geometry.apart(other, block) < geometry.HALF and (other.level or 0) == (block.level or 0) + 1 then
         return true
      end
   end
   return false
end

function FakeRobot:look()
   local tags = {}
   for _, block in ipairs(self.blocks) do
      for i, face in ipairs(FACES) do
         if block ~= self.held and not (i == 1 and self:is_covered(block)) then
            table.insert(tags, self:tag_of(block, face))
         end
      end
   end
   self.robot.camera_system.tags = tags
end

-- The colour of the block whose tag is nearest.
function FakeRobot:led_at(at)
   local tag, least = { colour = 0 }, math.huge
   for _, one in ipairs(self.robot.camera_system.tags) do
      local away = (one.position - at):length()
      if away < least then tag, least = one, away end
   end
   if tag.colour <= led_code.PLAIN then return tag.colour end
   -- of a code word, by where it is about the tag: right, up, left, down
   local way = (at - tag.position):rotate(tag.orientation:inverse())
   local across = math.abs(way.x) > math.abs(way.y)
   local i = across and (way.x > 0 and 1 or 3) or (way.y > 0 and 2 or 4)
   return i ~= self.dark_led and led_code.word_of(tag.colour)[i] or 0
end

return FakeRobot
