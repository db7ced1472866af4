-- SPDX-License-Identifier: MIT
-- What scripts of faults ask of the world's truth.
local truth = {}

-- How far apart two places are as seen from above, m.
function truth.apart(a, b)
   return math.sqrt((a.x - b.x) ^ 2 + (a.y - b.y) ^ 2)
end

-- The block that hangs in a robot's hand.
function truth.carried(world, robot)
   local at = world.robot(robot).position
   for i = 1, world.blocks() do
      local block = world.block(i)
      if block.position.z > 0.07 and not block.lattice and not block.left and
         truth.apart(block.position, at) < 0.12 then return block end
   end
end

-- The brick in a cell of the lattice whose cell (0, 0, 0) is the world's origin.
function truth.brick(world, x, y, z)
   local place = vector3(0.055 * x, 0.055 * y, 0.055 * (z + 0.5))
   for i = 1, world.blocks() do
      local block = world.block(i)
      if not block.left and block.color ~= 0 and (block.position - place):length() < 0.010 then
         return block
      end
   end
end

return truth
