-- SPDX-License-Identifier: MIT
-- Once the robot has lifted its second block its camera is dark for 20 s.

local truth = require 'truth'
local first, since, over

function on_step(world)
   if over then return end
   local block = not since and truth.carried(world, 1)
   first = first or block and block.name
   if block and block.name ~= first then
      since = world.time()
      world.set_camera('robot 1', false)
      log('dark')
      world.measure('at', since)
   elseif since and world.time() >= since + 20 then
      over = true
      world.set_camera('robot 1', true)
      log('light again')
   end
end
