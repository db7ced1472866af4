-- SPDX-License-Identifier: MIT
-- Whether there is room to move: what the rangefinders say of the next few centimetres. Most likely
-- it is another robot that stands in the way.
--
-- The later robot's rangefinders see less far than another robot's arm reaches: of what is behind, beside
-- or between it and a column they say nothing.

local geometry = require 'common.geometry'

local SIDE = geometry.SIDE
local STOP = 0.045             -- m, before the chassis
local AT_EFFECTOR = 0.05       -- m, before the effector
local BEHIND = 0.07            -- m, behind the chassis, which the body sticks out by 0.03, to stop from 0.1 m/s
local BEHIND_BODY = 0.025      -- m, behind the body, likewise from a brick that is remembered
local SPARE = 0.03             -- m, about what a turn sweeps: an arm over what a ray sees
local MEETING = 0.2            -- m, before chassis and effector, as far as they see: two that come towards each other
                               -- have two effectors of 0.085 between them, and need 0.05 each to stop
local EFFECTOR = 0.095         -- m, the effector before the chassis, and some more
local STOPS = 0.08             -- m, in which a robot stops from its speed of travel, a step late
local PATIENCE = 8             -- s, the longest random wait for a robot to go its way
local FREE = 1                 -- m, more than any rangefinder sees
local SEES_FAR = 0.1           -- m, of rangefinders that see another robot before its arm touches
local SEEN_LATELY = 2          -- s, that a place counts where another robot's chassis was seen, in a turn
local STAYS = 6                -- s, likewise, of who may wait for the same
local STANDS = 10              -- s, likewise ahead: who stands there is passed by, and out of the rangefinders' lines
local OF_BRICK = 0.005         -- m, about a brick, that a turn does not sweep
local OF_HELD = 0.05           -- m, from the middle of a block that another robot holds
local STEEP = 0.8              -- of a direction, along the robot's: it looks ahead or back

-- room: set by who knows a structure: how far a place of the odometry frame is from its nearest brick, m. bricks: likewise:
-- all of them, {x, y, z, yaw}. explained: likewise: whether what stands at a place is no robot; nil where nothing tells robots
-- from walls. alone: set by who knows that there is no other robot. transport: the colour of a block in a robot's hand.
-- ahead, behind: names of the chassis' rangefinders that look there; beside: those that look elsewhere than
-- ahead, with how far each has to see so that a turn is free; front: where the foremost of them are, m ahead.
local Clearance = {}
Clearance.__index = Clearance

-- `magnets` tells whether a block is carried, which hides what is before the chassis.
function Clearance.new(robot, description, process, ranges, magnets, sweep, returns)
   local self = setmetatable({
      robot = robot, process = process, ranges = ranges, magnets = magnets, body = description.body,
      effector = description.effector,
      sweep = sweep, returns = returns,
      odometry = process.odometry, room = function() return math.huge end,
      bricks = function() return {} end, alone = false,
      transport = 4,
      short_sighted = ranges:reach() < SEES_FAR, front = 0, ahead = {}, behind = {}, beside = {},
   }, Clearance)
   for _, ray in ipairs(ranges:chassis_rays()) do
      if ray.to.x > STEEP then
         table.insert(self.ahead, ray.name)
         self.front = math.max(self.front, description.rangefinders[ray.name].x)
      else
         self.beside[ray.name] = sweep:room_along(ray.from, ray.to) + SPARE
      end
      if ray.to.x < -STEEP then table.insert(self.behind, ray.name) end
   end
   returns.hidden = function(name) return not self.beside[name] and self:is_hidden_ahead() end
   return self
end

-- Whether a carried block hides what is before the chassis.
function Clearance:is_hidden_ahead()
   return self.magnets.carrying and self.robot.lift_system.position < SIDE
end

-- How far away something stands before the chassis, as far as a carried block does not hide it.
function Clearance:before_chassis()
   if self:is_hidden_ahead() then return FREE end
   return self.ranges:nearest(self.ahead)
end

-- Whether something stands within `distance` of the wheels' front, or right before the effector.
function Clearance:blocked(distance)
   return self:before_chassis() < (distance or STOP) or self.ranges:nearest { 'front' } < AT_EFFECTOR
end

-- Places {x, y} of blocks that other robots were seen to hold lately.
function Clearance:held_by_others()
   local out = {}
   for _, known in ipairs(self.returns.tracker:blocks()) do
      if known.colour == self.transport and known.z > SIDE and self.odometry.time - known.time < STANDS then
         table.insert(out, known)
      end
   end
   return out
end

-- Whether another robot's arm may be in the place from `first` to `last` m before the middle, as wide as the body: a
-- block that it holds was seen there, or its chassis so near that the arm may reach there. Lifts at different heights
-- leave each robot's arm out of the lines of all of the other's rangefinders. `counts(point)`, if given, says which of
-- the returns count.
function Clearance:meets_arm(first, last, counts)
   if self.alone or self.short_sighted then return false end
   local arm, half = self.effector.front - self.body.front, (last - first) / 2
   local function within(point, reach)
      local ahead, beside = geometry.into(self.odometry.pose, point.x, point.y)
      local dx = math.max(math.abs(ahead - (first + last) / 2) - half, 0)
      local dy = math.max(math.abs(beside) - self.body.half_width, 0)
      -- what stands beside the body is passed already; on the way back what stands beside its front
      local passed = ahead < self.body.front and ahead > (last < 0 and 0 or -self.body.back)
      return not passed and dx * dx + dy * dy < reach * reach
   end
   for _, block in ipairs(self:held_by_others()) do
      if within(block, OF_HELD) then return true end
   end
   if not self.explained then return false end
   local x, y = geometry.out_of(self.odometry.pose, (first + last) / 2, 0)
   local near = half + self.body.half_width + arm
   for _, point in ipairs(self.returns:near(x, y, near, self.odometry.time - STANDS)) do
      if within(point, arm) and not self.explained(point.x, point.y) and (not counts or counts(point)) then return true end
   end
   return false
end

-- Likewise ahead of the chassis, as far as `way` m before the effector.
function Clearance:meets_arm_ahead(way, counts)
   return self:meets_arm(self.body.front, self.effector.front + way, counts)
end

-- Whether something stands behind, which would be pushed: what the rangefinders see, bricks that are
-- remembered, higher ones too, or another robot's arm.
function Clearance:backed()
   for side = -1, 1 do
      local x, y = geometry.out_of(self.odometry.pose, -self.body.back, side * self.body.half_width)
      if self.room(x, y) < BEHIND_BODY then return true end
   end
   return not self.short_sighted and self.ranges:nearest(self.behind) < BEHIND or
          self:meets_arm(-self.body.back - BEHIND_BODY, -self.body.back)
end

-- Whether something stands between the robot and a column, `away` from its middle, that it faces;
-- one beside it may jut out by a block.
function Clearance:between(away)
   if self.short_sighted then return false end
   local nearest = away - SIDE / 2 - SIDE - 0.02
   return self:before_chassis() < nearest - self.front or
          self.ranges:nearest { 'front' } < math.min(AT_EFFECTOR, nearest - self.effector.front)
end

-- What stands ahead within the effector's reach, at the speed of travel. With `left` m to go what is
-- beyond does not count.
function Clearance:meets(left)
   return self:blocked(math.min(MEETING, (left or 1) + EFFECTOR)) or
          self.ranges:nearest { 'front' } < math.min(MEETING, left or 0) or
          self:meets_arm_ahead(math.min(STOPS, left or STOPS))
end

-- For a random while, until nothing stands where the effector would come down on it. Whether nothing does.
function Clearance:await_room_below()
   if self.alone then return true end
   return self.process:wait_until(function() return not self:blocked(EFFECTOR) end, PATIENCE * math.random())
end

-- How far ahead the effector has room, m.
function Clearance:room_ahead()
   local room = math.min(self:before_chassis() - EFFECTOR, self.ranges:nearest { 'front' } - AT_EFFECTOR)
   return math.max(0, room)
end

-- Places {x, y} of others' chassis, seen in the last `age` s, so near that the arm of one, wherever that points, and what a turn
-- on the spot sweeps may touch; of walls, too, where nothing tells them apart.
function Clearance:others_in_reach(age)
   local pivot, out = self.odometry:pivot(), {}
   for _, point in ipairs(self.returns:near(pivot.x, pivot.y, self.sweep.reach + EFFECTOR, self.odometry.time - age)) do
      if not self.explained or not self.explained(point.x, point.y) then table.insert(out, point) end
   end
   return out
end

-- Whether there are any, or a block that another holds is as near.
function Clearance:has_company()
   if self.alone then return false end
   local pivot = self.odometry:pivot()
   for _, block in ipairs(self:held_by_others()) do
      if geometry.apart(pivot, block) < self.sweep.reach + OF_HELD then return true end
   end
   return #self:others_in_reach(SEEN_LATELY) > 0
end

-- Waits a while for those to go whom the effector would sweep in a turn on the spot. Whether there is nobody.
function Clearance:await_room()
   if self.short_sighted then return true end
   local function room()
      for name, needed in pairs(self.beside) do
         local range = self.ranges:range(name)
         if range and range < needed then return false end
      end
      return not self:has_company()
   end
   return room() or self.process:wait_until(room, PATIENCE * math.random())
end

-- Whether a turn on the spot by `angle` comes so near one of them that its arm may be touched.
function Clearance:turns_into_company(angle)
   for _, point in ipairs(self:others_in_reach(STAYS)) do
      local x, y = geometry.into(self.odometry.pose, point.x, point.y)
      if self.sweep:touches(x, y, angle, EFFECTOR) then return true end
   end
   return false
end

-- Places {x, y} all along the edge of a brick, as seen from above.
local function edge_of(brick)
   local out = {}
   for along = -1, 1 do
      for left = -1, 1 do
         if along ~= 0 or left ~= 0 then
            local x, y = geometry.out_of(brick, geometry.HALF * along, geometry.HALF * left)
            table.insert(out, { x = x, y = y })
         end
      end
   end
   return out
end

-- Whether a turn on the spot by `angle` sweeps a brick that is remembered. The effector passes over lower ones.
function Clearance:turns_into_bricks(angle)
   local pivot, over = self.odometry:pivot(), self.robot.lift_system.position
   for _, brick in ipairs(self.bricks()) do
      if geometry.apart(pivot, brick) < self.sweep.from_block then
         local parts = brick.z + geometry.HALF < over and self.sweep.chassis or nil
         for _, point in ipairs(edge_of(brick)) do
            local x, y = geometry.into(self.odometry.pose, point.x, point.y)
            if self.sweep:touches(x, y, angle, OF_BRICK, parts) then return true end
         end
      end
   end
   return false
end

-- 1 where a robot that goes ahead comes away from bricks, -1 where one does that goes back.
function Clearance:way_from_bricks()
   local pose = self.odometry.pose
   return self.room(geometry.out_of(pose, SIDE, 0)) < self.room(geometry.out_of(pose, -SIDE, 0)) and -1 or 1
end

-- For a random while, until it does not. Whether it does not.
function Clearance:await_leave(angle)
   if self.alone or self.short_sighted or not self.explained then return true end
   local function left() return not self:turns_into_company(angle) end
   return left() or self.process:wait_until(left, PATIENCE * math.random())
end

-- For a random while, until nothing is met with `left()` m to go. Whether it has gone.
function Clearance:await_way(left)
   return self.process:wait_until(function() return not self:meets(left()) end, PATIENCE * math.random())
end

return Clearance
