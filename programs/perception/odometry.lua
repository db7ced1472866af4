-- SPDX-License-Identifier: MIT
-- The robot's pose, estimated from its wheel encoders, in the frame in which it stood at first.

local geometry = require 'common.geometry'
local profile = require 'motion.profile'

-- pose: {x, y, yaw}; time and period: of this step, s; left, right: speeds of the rims, m/s;
-- travelled: m, forwards and back.
local Odometry = {}
Odometry.__index = Odometry

function Odometry.new(robot, description)
   return setmetatable({
      robot = robot, description = description,
      pose = { x = 0, y = 0, yaw = 0 },
      time = robot.system.time or 0, period = 0.2,
      left = 0, right = 0, travelled = 0,
   }, Odometry)
end

-- Once in each step. Returns by how much the robot has moved: m ahead and rad to the left.
function Odometry:sense()
   local encoders = self.robot.differential_drive.encoders
   -- the right motor is the mirror image of the left one
   local left, right = encoders.left, -encoders.right
   local time = self.robot.system.time - self.time
   self.time = self.robot.system.time
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
   local pose, middle = self.pose, self.pose.yaw + turn / 2
   pose.x = pose.x + ahead * math.cos(middle)
   pose.y = pose.y + ahead * math.sin(middle)
   pose.yaw = geometry.wrap(pose.yaw + turn)
   self.travelled = self.travelled + math.abs(ahead)
   return ahead, turn
end

-- Place along and beside a line {x, y, yaw}, and the angle to it: the cross-track error and the
-- heading error.
function Odometry:on_line(line)
   local along, aside = geometry.into(line, self.pose.x, self.pose.y)
   return along, aside, geometry.wrap(self.pose.yaw - line.yaw)
end

function Odometry:distance_to(place)
   return geometry.apart(place, self.pose)
end

-- The pose as it is now, as a line straight ahead.
function Odometry:line_ahead()
   return { x = self.pose.x, y = self.pose.y, yaw = self.pose.yaw }
end

return Odometry
