-- SPDX-License-Identifier: MIT
-- The velocity profile of a rim: it ramps at a known rate, and then runs evenly.

local profile = {}

local FAR = 0.010              -- m, from the end, where it brakes gently
local GENTLE = 0.4             -- part of the ramp's rate, there

-- How far a rim goes in a step that begins with the speed `before` and is commanded `after`, m/s.
function profile.distance(before, after, time, acceleration)
   local change = after - before
   return after * time - change * math.abs(change) / (2 * acceleration)
end

-- The speed, at most `most`, for the next step of `period` seconds so that a rim that now runs at
-- `now` can still stop `left` m ahead; left, now and the result have the same sign when all is well.
-- `gentle`: the part of the ramp's rate at which it brakes far from the end, if another is to be.
function profile.speed(left, now, most, period, acceleration, gentle)
   local sign = left < 0 and -1 or 1
   left, now = left * sign, now * sign
   -- far from the end brake gently; on the last millimetres exactly as the ramp does
   local brake = acceleration * (left > FAR and (gentle or GENTLE) or 1)
   local low, high = 0, most
   for _ = 1, 24 do
      local middle = (low + high) / 2
      local needed = profile.distance(now, middle, period, acceleration) + middle * middle / (2 * brake)
      if needed > left then high = middle else low = middle end
   end
   return sign * low
end

return profile
