-- SPDX-License-Identifier: MIT
-- At the beginning the first block of the cache at +x is made to show Q1, as a brick does: robots
-- take none that does, and the cache drops no other while it lies there.

local done

function on_step(world)
   for i = 1, done and 0 or world.blocks() do
      local block = world.block(i)
      if block.position.x > 0.4 and block.color == 0 then
         world.set_color(block.name, 1)
         done = true
         log(block.name, ' shows Q1')
         world.measure('at', world.time())
         return
      end
   end
end
