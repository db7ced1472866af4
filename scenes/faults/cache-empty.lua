-- SPDX-License-Identifier: MIT
-- A cache of its own: when no block lies within 0.35 m of it, it drops one; after the second only 300 s
-- later.

local dropped, from = 0, 0

local function is_there(world)
   for i = 1, world.blocks() do
      local block = world.block(i)
      local away = block.position - vector3(0.35, 0, 0)
      away.z = 0
      if not block.left and away:length() < 0.35 then return true end
   end
end

function on_step(world)
   if is_there(world) then
      from = dropped == 2 and world.time() + 300 or world.time()
      return
   end
   if world.time() < from or not world.drop(vector3(0.35, 0, 0.125)) then return end
   dropped = dropped + 1
   log('block ', dropped)
   world.measure('dropped', dropped)
end
