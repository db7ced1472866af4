-- SPDX-License-Identifier: MIT
-- Follows a wall on the left at a set distance, turning away from what is ahead. Written for the
-- BuilderBot's interface: rangefinders in metres, 1 ahead and on round the robot counter-clockwise,
-- wheels in metres per second. Parameters: distance, speed, range (all optional).

local distance, speed, range

-- Readings are small when something is near; counts (which grow) are taken for metres only if the
-- parameter `counts` says what they are at the set distance.
local function nearest(names)
   local least = range
   for _, name in ipairs(names) do
      local finder = robot.rangefinders[name]
      if finder and finder.proximity > 0 and finder.proximity < least then
         least = finder.proximity
      end
   end
   return least
end

local function drive(left, right)
   -- the right motor is the mirror image of the left one
   robot.differential_drive.set_target_velocity(left, -right)
end

function reset()
   distance = robot.params.distance or 0.03
   speed = robot.params.speed or 0.05
   range = robot.params.range or 0.05
end

function init()
   reset()
end

function step()
   local ahead = nearest { '1', '2', '12' }
   local side = nearest { '3', '4', '5' }
   local state = 'search'
   if ahead < distance then
      state = 'turn'
      drive(speed, -speed)
   elseif side < range then
      state = 'follow'
      -- too far: turn left, towards the wall; too near: right
      local turn = math.max(-0.5, math.min(0.5, (side - distance) / distance)) * speed
      drive(speed - turn, speed + turn)
   else
      drive(0.6 * speed, speed)   -- a wide circle to the left until there is a wall
   end
   robot.show.text('state', state)
   robot.show.number('side', side)
end

function destroy()
   drive(0, 0)
end
