-- SPDX-License-Identifier: MIT
-- For the cart with the gripper (robots/gripper_cart.yaml): drives up to what is ahead, grips it,
-- lifts it, swings it to the left and lets it go. A program for a robot that is like no other
-- needs nothing but the names of its devices.

local TURNED_DOWN, RAISED = math.rad(28), math.rad(10)
local PRESS = 3      -- N, of each finger
local steps, at, since

local function drive(v) robot.differential_drive.set_target_velocity(v, -v) end
local function arm(yaw, pitch)
   robot.joints.yaw.set_target(yaw)
   robot.joints.pitch.set_target(pitch)
end
-- Positive closes.
local function press(force)
   robot.joints['left finger'].set_target(-force)
   robot.joints['right finger'].set_target(force)
end

-- Each step sets its targets anew and says when it is done; `time` since it began.
steps = {
   { 'reach', function()
      arm(0, TURNED_DOWN)
      press(-PRESS)
      local ahead = robot.rangefinders.ahead.proximity
      drive(math.min(0.1, 0.02 + 0.5 * ahead))
      return ahead < 0.006
   end },
   { 'grip', function(time)
      drive(0)
      press(PRESS)
      return time > 1
   end },
   { 'lift', function(time)
      arm(0, -RAISED)
      return time > 3
   end },
   { 'swing', function(time)
      arm(math.rad(80), -RAISED)
      return time > 3
   end },
   { 'lower', function(time)
      arm(math.rad(80), TURNED_DOWN)
      return time > 3
   end },
   { 'open', function(time)
      press(-PRESS)
      return time > 1
   end },
   { 'raise', function(time)
      arm(math.rad(80), 0)
      return time > 2
   end },
   { 'done', function() return false end },
}

local function enter(number)
   at, since = number, robot.system.time
   log(steps[at][1])
end

function init() reset() end

function reset()
   enter(1)
end

function step()
   if steps[at][2](robot.system.time - since) then enter(at + 1) end
   robot.show.text('state', steps[at][1])
end
