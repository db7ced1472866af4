-- SPDX-License-Identifier: MIT
-- Five seconds after the first wing is finished its last brick is knocked off: out, and to the left, where it keeps no
-- cache from dropping blocks.

local truth = require 'truth'
local since, done

-- The last brick of a wing that is whole, and the way out.
local function finished(world)
   for _, out in ipairs { vector3(1, 0, 0), vector3(0, 1, 0), vector3(-1, 0, 0), vector3(0, -1, 0) } do
      local last = truth.brick(world, 2 * out.x, 2 * out.y, 0)
      if last and truth.brick(world, out.x, out.y, 1) then return last, out end
   end
end

function on_step(world)
   if done then return end
   local last, out = finished(world)
   since = last and (since or world.time())
   if not last or world.time() - since < 5 then return end
   done = world.place(last.name, vector3(0.38 * out.x - 0.38 * out.y, 0.38 * out.y + 0.38 * out.x, 0.0275))
   if done then
      log(last.name, ' is off')
      world.measure('at', world.time())
   end
end
