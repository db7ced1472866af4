-- SPDX-License-Identifier: MIT
-- Robot 1 breaks down after its first block, and somebody carries it off before it has come near the structure again.

local truth = require 'truth'
local first, done

function on_step(world)
   if done then return end
   local block = truth.carried(world, 1)
   first = first or block and block.name
   if not first or block or truth.apart(world.robot(1).position, vector3()) < 0.35 then return end
   done = world.place('robot 1', vector3(1.2, 1.2, 0))
   if not done then return end
   world.halt('robot 1')
   log('robot 1 carried off')
   world.measure('at', world.time())
end
