-- SPDX-License-Identifier: MIT
-- Once, when the robot is within 0.20 m of a loose block, it gets a push of 1 N to the side.

local nearest = require 'nearest_loose'

local done

function on_step(world)
   if done then return end
   local block, away = nearest(world)
   if not block or away > 0.20 then return end
   world.push(block.name, vector3(0.2, 1, 0), 0.3)
   done = true
   log('pushed ', block.name)
   world.measure('at', world.time())
end
