-- SPDX-License-Identifier: MIT
-- Once, when the robot is within 0.22 m of a loose block, somebody takes it away.

local nearest = require 'nearest_loose'

local done

function on_step(world)
   if done then return end
   local block, away = nearest(world)
   if not block or away > 0.22 then return end
   done = world.place(block.name, vector3(1.2, 1.2, 0.0275))
   if done then
      log('took ', block.name, ' away')
      world.measure('at', world.time())
   end
end
