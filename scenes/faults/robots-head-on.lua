-- SPDX-License-Identifier: MIT
-- Ends the run when both robots are past the corridor, or one of them lies on its side.

local through = {}

function on_step(world)
   local count = 0
   for i = 1, 2 do
      local robot = world.robot(i)
      local x = robot.position.x
      through[i] = through[i] or i == 1 and x > 0.35 or i == 2 and x < -0.35
      if through[i] then count = count + 1 end
      if vector3(0, 0, 1):rotate(robot.orientation).z < 0.5 then
         world.stop(robot.name .. ' lies on its side')
      end
   end
   world.measure('through', count)
   if count == 2 then world.stop('both are through') end
end
