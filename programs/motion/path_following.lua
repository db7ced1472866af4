-- SPDX-License-Identifier: MIT
-- Drives: along lines {x, y, yaw} of the odometry frame, to places, and on the spot. Lines are followed by
-- the robot's middle; a place is reached by its pivot, which stays there when the robot turns.

local geometry = require 'common.geometry'
local profile = require 'motion.profile'

local STRAIGHT = 0.04          -- m, in which a line is joined
local TURN_RIM = 0.10          -- m/s, of the rims in a turn on the spot
local BACK_SPEED = 0.1         -- m/s
local OUT = 0.1                -- m, back from another robot
local HERE = 0.01              -- m, from a place, where it is reached
local ROUNDS = 4               -- so often it waits at most, before it turns anyway
local FAR = 0.3                -- rad, of a turn that sweeps more than is beside the robot
local STOP_TIME = 0.5          -- s, two steps and some more
local SWUNG = 0.05             -- rad, before its end, at which a swing is over
local LONGEST_TURN, LONGEST_DRIVE = 20, 60  -- s
local AT_REST = 1e-3           -- m/s
local SLOWEST = 0.1            -- of the pace, that turns and ways end in the times above
local FACES, NEARLY = 1e-5, 2e-4  -- m, of the rims, from a heading; of motors that lag and so go past it

local PathFollower = {}
PathFollower.__index = PathFollower

-- The part of its speeds at which a robot drives: `params.pace`, as one does whose motors are weak, or 1.
local function pace_of(robot)
   local pace = tonumber(robot.params.pace or 1)
   if not pace or not (pace >= SLOWEST and pace <= 1) then
      error(string.format("params.pace has to be from %g to 1, and is '%s'", SLOWEST, tostring(robot.params.pace)), 0)
   end
   return pace
end

-- cruise: speed of travel, m/s, at which it can stop for what the rangefinders see. pace: the part of all speeds that it drives at.
function PathFollower.new(robot, description, odometry, process, ranges, clearance)
   return setmetatable({
      robot = robot, description = description, odometry = odometry, process = process,
      clearance = clearance, pace = pace_of(robot),
      cruise = math.min(description.drive.speed / 2, ranges:reach() / STOP_TIME),
   }, PathFollower)
end

function PathFollower:drive_rims(left, right)
   self.odometry:tell(left, right)
   -- the right motor is the mirror image of the left one
   self.robot.differential_drive.set_target_velocity(left, -right)
end

-- v in m/s, turn in rad/s.
function PathFollower:drive(v, turn)
   local aside = turn * self.description.drive.track / 2
   self:drive_rims(v - aside, v + aside)
end

function PathFollower:stop()
   self:drive(0, 0)
   self.process:wait_until(function()
      return math.abs(self.odometry.left) < 1e-4 and math.abs(self.odometry.right) < 1e-4
   end, 1)
end

-- The speed for the next step of what now moves at `now`; `gentle` as with profile.speed.
function PathFollower:speed_for(left, now, most, gentle)
   return profile.speed(left, now, most * self.pace, self.odometry.period, self.description.drive.acceleration, gentle)
end

-- How far the rims have to go to face a heading, and how fast they do; m and m/s.
function PathFollower:way_to_face(yaw)
   local odometry, radius = self.odometry, self.description.drive.track / 2
   return geometry.wrap(yaw - odometry.pose.yaw) * radius, (odometry.right - odometry.left) / 2
end

-- On the spot towards a heading, until `ends(left, now)` says so of the rims; `gentle` as with profile.speed.
function PathFollower:turn_until(ends, yaw, rim, gentle)
   local start = self.odometry.time
   while self.odometry.time - start < LONGEST_TURN do
      local left, now = self:way_to_face(yaw)
      if ends(left, now) then return end
      local speed = self:speed_for(left, now, rim, gentle)
      self:drive_rims(-speed, speed)
      coroutine.yield()
   end
end

-- On the spot, to a heading of the odometry frame; `rim` is the speed of the rims; `each` as with follow. Before it turns far
-- it goes away from bricks, and waits for who was seen in its reach. Whether it faces there.
function PathFollower:turn_to(yaw, rim, each)
   self:leave_bricks(yaw)
   self:await_company(geometry.wrap(yaw - self.odometry.pose.yaw))
   return self:turn(yaw, rim, each)
end

-- Likewise, at once.
function PathFollower:turn(yaw, rim, each)
   local first, close = self:way_to_face(yaw), FACES
   self:turn_until(function(left, now)
      if first * left < 0 then close = NEARLY end
      return (math.abs(left) < close and math.abs(now) < AT_REST) or (each and each())
   end, yaw, rim or TURN_RIM)
   self:stop()
   return math.abs(geometry.wrap(yaw - self.odometry.pose.yaw)) < 0.01
end

-- Likewise to about that heading, to look about: it brakes as hard as it can, and need not have come to
-- rest when another turn follows.
function PathFollower:swing_to(yaw, rim, each)
   local close = SWUNG * self.description.drive.track / 2
   self:turn_until(function(left) return math.abs(left) < close or (each and each()) end, yaw, rim, 1)
end

function PathFollower:turn_by(angle, rim)
   return self:turn_to(self.odometry.pose.yaw + angle, rim)
end

-- One step along a line, towards its point `to`: critically damped over the way,
-- e'' = -2 e'/L - e/L², where L is `straight` and e the distance of the pivot from the line, which changes
-- by the heading alone.
function PathFollower:steer(along, aside, angle, to, speed, straight)
   local left, now = to - along, (self.odometry.left + self.odometry.right) / 2
   local v = self:speed_for(left, now, speed)
   local back = left < 0 and -1 or 1
   local off = aside + self.odometry.ahead * math.sin(angle)
   local bend = -back * off / straight ^ 2 - 2 * angle / straight
   self:drive(v, math.abs(v) * geometry.clamp(bend, -15, 15))
end

-- Along a line to its point `to` (0: where the line begins), forward or backward, as the way there
-- asks; joins it within some 4 `straight` (default: STRAIGHT). `line` may be a function that says it
-- anew in each step; nil ends the drive. `each` is called in every step and may end it by returning
-- true.
function PathFollower:follow(line, to, speed, each, straight)
   local odometry = self.odometry
   local start = odometry.time
   while odometry.time - start < LONGEST_DRIVE do
      local now_line = line
      if type(line) == 'function' then now_line = line() end
      if not now_line then
         self:stop()
         return false, 'target lost'
      end
      local along, aside, angle = odometry:on_line(now_line)
      local now = (odometry.left + odometry.right) / 2
      if (math.abs(to - along) < 1e-4 and math.abs(now) < AT_REST) or (each and each()) then break end
      self:steer(along, aside, angle, to, speed, straight or STRAIGHT)
      coroutine.yield()
   end
   self:stop()
   return true
end

-- Straight on by so much; back when negative; `each` as with follow.
function PathFollower:go_by(way, speed, each)
   return self:follow(self.odometry:line_ahead(), way, speed or self.cruise, each)
end

-- With the pivot to a place of the odometry frame: turns to it, and drives; `each` as with follow.
function PathFollower:go_to(x, y, speed, each)
   local odometry, place = self.odometry, { x = x, y = y }
   if geometry.apart(odometry:pivot(), place) < HERE then return true end
   self:leave_bricks(geometry.angle_to(odometry:pivot(), place))
   local yaw = geometry.angle_to(odometry:pivot(), place)
   local angle = geometry.wrap(yaw - odometry.pose.yaw)
   if math.abs(angle) > FAR then self:clear_round(angle) end
   self:turn(yaw)
   return self:follow({ x = x, y = y, yaw = yaw }, -odometry.ahead, speed or self.cruise, each)
end

-- As with follow, but ends where something stands behind.
function PathFollower:follow_back(line, to, speed)
   return self:follow(line, to, speed, function() return self.clearance:backed() end)
end

-- Back by so much, or as far as there is room.
function PathFollower:back_off(way)
   return self:follow_back(self.odometry:line_ahead(), -way, BACK_SPEED)
end

-- Away from bricks, ahead or back, until a turn on the spot to a heading sweeps none, as far as there is room.
function PathFollower:leave_bricks(yaw)
   local clearance, angle = self.clearance, geometry.wrap(yaw - self.odometry.pose.yaw)
   if math.abs(angle) < FAR or not clearance:turns_into_bricks(angle) then return end
   local way = clearance:way_from_bricks()
   self:go_by(way * OUT, BACK_SPEED, function()
      return not clearance:turns_into_bricks(angle) or (way > 0 and clearance:meets(0)) or (way < 0 and clearance:backed())
   end)
end

-- Waits for who stands where a turn on the spot sweeps, and then backs out, unless that may be a wall; then for others, in a
-- turn by `angle`, or once round.
function PathFollower:clear_round(angle)
   if self.clearance:await_room() or not self.clearance.explained then return end
   self:back_off(OUT)
   self:await_company(angle)
end

-- Waits for others to leave whom a turn on the spot by `angle` may touch, or one once round; those that wait likewise turn one
-- after the other.
function PathFollower:await_company(angle)
   if angle and math.abs(angle) < FAR then return end
   for _ = 1, ROUNDS do
      if self.clearance:await_leave(angle or 2 * math.pi) then return end
   end
end

-- Waits for who stands below the effector, and then backs out from above. Whether the lift may go down.
function PathFollower:clear_below()
   if self.clearance:await_room_below() then return true end
   self:back_off(OUT)
   return self.clearance:await_room_below()
end

return PathFollower
