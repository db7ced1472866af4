-- SPDX-License-Identifier: MIT
-- Twice, three seconds after the robot has lifted a block, it falls to the floor beside it.

-- A block that hangs in the robot's hand.
local function carried(world)
   local robot = world.robot(1)
   for i = 1, world.blocks() do
      local block = world.block(i)
      local away = block.position - robot.position
      local high = block.position.z > 0.07
      away.z = 0
      if high and not block.left and away:length() < 0.12 then return block end
   end
end

local times, since = 0, nil

function on_step(world)
   local block = times < 2 and carried(world)
   if not block then
      since = nil
      return
   end
   since = since or world.time()
   if world.time() - since < 3 then return end
   local robot = world.robot(1).position
   local aside = vector3(robot.x, robot.y + (robot.y > 0 and -0.15 or 0.15), 0.0275)
   if world.place(block.name, aside, quaternion(0, vector3(0, 0, 1))) then
      times, since = times + 1, nil
      log(block.name, ' slipped')
      world.measure('slips', times)
   end
end
