-- SPDX-License-Identifier: MIT
-- A script in which the brick that is built in a cell shows another colour from ten seconds after it came there on: its
-- program has begun anew, or somebody has told it so.
local truth = require 'truth'

-- `from`: m, the world's x of the lattice's cell (0, 0, 0). `under`: whether the ten seconds begin only when a brick stands on it.
return function(x, y, z, colour, from, under)
   local since, done
   local u = x + (from or 0) / 0.055
   return function(world)
      local brick = not done and truth.brick(world, u, y, z)
      if under and not truth.brick(world, u, y, z + 1) then brick = nil end
      since = brick and (since or world.time())
      if not brick or world.time() - since < 10 then return end
      world.set_color(brick.name, colour)
      done = true
      log(brick.name, ' shows ', colour == 0 and 'nothing' or 'Q' .. colour)
      world.measure('at', world.time())
   end
end
