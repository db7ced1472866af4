-- SPDX-License-Identifier: MIT
-- Once, when the robot is within 0.22 m of a loose block, somebody takes it away.

-- The dark block on the floor that is nearest to the robot's middle, and how far it is.
local function nearest(world)
   local robot, best, least = world.robot(1), nil, 1e9
   for i = 1, world.blocks() do
      local block = world.block(i)
      local away = (block.position - robot.position)
      away.z = 0
      local loose = block.color == 0 and not block.left and block.position.z < 0.03
      if loose and away:length() < least then best, least = block, away:length() end
   end
   return best, least
end

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
