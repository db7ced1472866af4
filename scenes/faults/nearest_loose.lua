-- SPDX-License-Identifier: MIT
-- The dark block on the floor that is nearest to the robot's middle, and how far it is.
return function(world)
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
