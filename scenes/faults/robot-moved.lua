-- SPDX-License-Identifier: MIT
-- Once, 45 s after the beginning.

local done

function on_step(world)
   if done or world.time() < 45 then return end
   local q = quaternion(math.rad(12), vector3(0, 0, 1)) * world.robot(1).orientation
   local p = world.robot(1).position
   done = world.place('robot 1', vector3(p.x + 0.05, p.y - 0.15, 0), q)
   if done then
      log('put elsewhere')
      world.measure('at', world.time())
   end
end
