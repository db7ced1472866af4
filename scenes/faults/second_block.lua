-- SPDX-License-Identifier: MIT
-- What happens once to the second block that a cache drops: `fault` is called with the world and
-- the block's name.
return function(fault)
   local seen, done = {}, false
   return function(world)
      if done then return end
      for i = 1, world.blocks() do
         local name = world.block(i).name
         if name:find('^cache block') and not seen[name] then
            seen[name] = true
            seen[#seen + 1] = name
         end
      end
      if #seen < 2 then return end
      done = true
      fault(world, seen[2])
      log(seen[2], ' is broken')
      world.measure('at', world.time())
   end
end
