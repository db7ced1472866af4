-- SPDX-License-Identifier: MIT
-- The lift: where it is sent, and how high the camera on it has to be to see something.
--
-- It rests within its tolerance of where it is sent, on the side that it came from; so it is sent that
-- much further. What it carries would come off in the jolt of starting or stopping: the magnets hold
-- harder meanwhile.

local geometry = require 'common.geometry'

local SLACK = 0.8              -- part of the tolerance that it is sent further
local LONGEST = 20             -- s
local STILL = 3                -- steps without motion: something holds it up
local LOWEST_CARRYING = 0.070  -- height at which a carried block passes over another
local NEAR_TOP = 0.0015        -- m, below the top, for a height that it surely reaches

-- highest: where it is sent at most.
local Lift = {}
Lift.__index = Lift
Lift.OVER_BLOCK = 0.015        -- over a block's top: clear of it, and its magnets are not drawn
Lift.WORTH = 0.003             -- m: less is not worth a motion

function Lift.new(robot, description, odometry, process, magnets)
   return setmetatable({
      robot = robot, odometry = odometry, process = process, magnets = magnets,
      tolerance = description.lift.tolerance,
      highest = description.lift.top - description.lift.tolerance,
   }, Lift)
end

function Lift:height()
   return self.robot.lift_system.position
end

-- Whether it does not have to go down to be at a height.
function Lift:is_below(height)
   return self:height() < height + Lift.WORTH
end

function Lift:top()
   return self.highest - NEAR_TOP
end

-- Until it is at `sent`, or held up by something.
function Lift:await(sent)
   local before, still = self:height(), 0
   return function()
      local now = self:height()
      still = math.abs(now - before) < 1e-4 and still + 1 or 0
      before = now
      return still >= STILL or math.abs(now - sent) <= 1.05 * self.tolerance
   end
end

-- Sets out for a height, if it is farther than `near` (default: its slack) from there, m, and returns a function that waits
-- until it has arrived, and says whether it has.
function Lift:set_out(height, near)
   local slack = SLACK * self.tolerance
   local position = self:height()
   if math.abs(height - position) < (near or slack) then return function() return true end end
   local sent = height + (height > position and slack or -slack)
   sent = geometry.clamp(sent, 0, self.highest)
   if self.magnets.carrying then
      self.magnets:hold_fast(true)
      coroutine.yield()
   end
   self.robot.lift_system.set_position(sent)
   return function() return self:arrive(sent) end
end

function Lift:arrive(sent)
   coroutine.yield()
   local reached = self.process:wait_until(self:await(sent), LONGEST)
   if self.magnets.carrying then
      coroutine.yield()
      self.magnets:hold_fast(false)
   end
   return reached
end

function Lift:to(height)
   return self:set_out(height)()
end

-- So that a block on the floor, so far ahead, is in the picture's middle, as near as it can; what is
-- carried passes over blocks. As set_out.
function Lift:look_to(camera, ahead)
   local lowest = self.magnets.carrying and LOWEST_CARRYING or Lift.OVER_BLOCK
   return self:set_out(geometry.clamp(camera:lift_for(ahead, geometry.SIDE), lowest, self:top()))
end

-- Likewise for a block whose mark is at a height, `before` its middle, in the midst of a drive:
-- the motion is begun, and not waited for.
function Lift:keep_in_sight(camera, block, mark, before, lowest)
   local ahead = geometry.into(self.odometry.pose, block.x, block.y)
   local height = geometry.clamp(camera:lift_for(ahead - before, mark), lowest, self.highest)
   if math.abs(height - self:height()) > Lift.WORTH then
      self.robot.lift_system.set_position(height)
   end
end

return Lift
