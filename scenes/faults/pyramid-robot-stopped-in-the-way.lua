-- SPDX-License-Identifier: MIT
-- Once the middle column is three high, robot 1 breaks down before the structure, with a block.

local truth = require 'truth'
local done

function on_step(world)
   if done or not truth.brick(world, 0, 0, 2) or not truth.carried(world, 1) or
      truth.apart(world.robot(1).position, vector3()) > 0.22 then return end
   world.halt('robot 1')
   done = true
   log('robot 1 stopped')
   world.measure('at', world.time())
end
