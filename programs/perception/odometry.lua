-- SPDX-License-Identifier: MIT
-- The robot's pose, estimated from its wheel encoders, in the frame in which it stood at first. Encoders tell whole
-- counts, more coarsely than motors obey: a rim goes as it was told, unless its encoder contradicts.
--
-- Its wheels move the pivot, the point about which it turns on the spot, straight ahead (robot.description
-- says where that is); the robot's middle, whose pose this is, goes round it.

local geometry = require 'common.geometry'
local profile = require 'motion.profile'

local DOUBT = 0.0015           -- m/s, by which an encoder may be off: more than a count
local TRUST = 0.1              -- in what it says, of what is less than that

-- pose: {x, y, yaw}; ahead: of the pivot, before the middle, m; time and period: of this step, s; left, right: speeds of the rims, m/s;
-- travelled: m, forwards and back.
local Odometry = {}
Odometry.__index = Odometry

function Odometry.new(robot, description)
   return setmetatable({
      robot = robot, description = description, ahead = description.drive.pivot,
      pose = { x = 0, y = 0, yaw = 0 },
      time = robot.system.time or 0, period = 0.2,
      left = 0, right = 0, told_left = 0, told_right = 0, travelled = 0,
   }, Odometry)
end

-- What rims were told last, m/s.
function Odometry:tell(left, right)
   self.told_left, self.told_right = left, right
end

-- The speed of a rim that ran at `before` and was told another, as its encoder bears it out.
function Odometry:speed(before, told, encoder, time)
   local most = self.description.drive.acceleration * time
   local expected = before + geometry.clamp(told - before, -most, most)
   local off = encoder - expected
   return math.abs(off) < DOUBT and expected + TRUST * off or encoder
end

-- Once in each step. Returns by how much the robot has moved: m ahead and rad to the left.
function Odometry:sense()
   local encoders = self.robot.differential_drive.encoders
   local time = self.robot.system.time - self.time
   self.time = self.robot.system.time
   local left = self:speed(self.left, self.told_left, encoders.left, time)
   -- the right motor is the mirror image of the left one
   local right = self:speed(self.right, self.told_right, -encoders.right, time)
   local ahead, turn = 0, 0
   if time > 0 then
      self.period = time
      ahead, turn = self:integrate(left, right, time)
   end
   self.left, self.right = left, right
   return ahead, turn
end

function Odometry:integrate(left, right, time)
   local acceleration = self.description.drive.acceleration
   local a = profile.distance(self.left, left, time, acceleration)
   local b = profile.distance(self.right, right, time, acceleration)
   local ahead, turn = (a + b) / 2, (b - a) / self.description.drive.track
   local pose, pivot, way = self.pose, self:pivot(), self.pose.yaw + turn / 2
   pose.yaw = geometry.wrap(pose.yaw + turn)
   pose.x = pivot.x + ahead * math.cos(way) - self.ahead * math.cos(pose.yaw)
   pose.y = pivot.y + ahead * math.sin(way) - self.ahead * math.sin(pose.yaw)
   self.travelled = self.travelled + math.abs(ahead)
   return ahead, turn
end

-- The point that stays where it is when the robot turns on the spot.
function Odometry:pivot()
   local x, y = geometry.out_of(self.pose, self.ahead, 0)
   return { x = x, y = y }
end

-- Place along and beside a line {x, y, yaw}, and the angle to it: the cross-track error and the
-- heading error.
function Odometry:on_line(line)
   local along, aside = geometry.into(line, self.pose.x, self.pose.y)
   return along, aside, geometry.wrap(self.pose.yaw - line.yaw)
end

-- Likewise where it will be once it has turned to face along the line.
function Odometry:turned_onto(line)
   local pivot = self:pivot()
   local along, aside = geometry.into(line, pivot.x, pivot.y)
   return along - self.ahead, aside
end

-- Where the pivot is when the robot's middle is so far along a line that it faces.
function Odometry:pivot_on(line, along)
   return geometry.out_of(line, along + self.ahead, 0)
end

function Odometry:distance_to(place)
   return geometry.apart(place, self.pose)
end

-- The pose as it is now, as a line straight ahead.
function Odometry:line_ahead()
   return { x = self.pose.x, y = self.pose.y, yaw = self.pose.yaw }
end

return Odometry
