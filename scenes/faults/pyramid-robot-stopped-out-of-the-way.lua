-- SPDX-License-Identifier: MIT
-- Robot 1 breaks down with its second block in hand, before it has come near the structure.

local truth = require 'truth'
local first, done

function on_step(world)
   if done then return end
   local block = truth.carried(world, 1)
   first = first or block and block.name
   if not block or block.name == first or truth.apart(world.robot(1).position, vector3()) < 0.50 then
      return
   end
   world.halt('robot 1')
   done = true
   log('robot 1 stopped')
   world.measure('at', world.time())
end
