-- SPDX-License-Identifier: MIT
-- Counts, every five seconds, the bricks of five pyramids that are in their cells and colours; ends the
-- run when all stand.

local SIDE, NEAR = 0.055, 0.010  -- m
local MIDDLES = {
   vector3(0, 0, 0), vector3(2.5, 0, 0), vector3(0, 2.5, 0), vector3(-2.5, 0, 0), vector3(0, -2.5, 0),
}

-- The colour that belongs in a cell: the middle column, and four staircases of two and one.
local function wanted(x, y, z)
   local out = math.abs(x) + math.abs(y)
   if x ~= 0 and y ~= 0 or out > 2 or z < 0 or z > 2 - out then return nil end
   return 3 - out
end

local BRICKS, due = 15, 0

function on_step(world)
   if world.time() < due then return end
   due = due + 5
   local count = { 0, 0, 0, 0, 0 }
   for i = 1, world.blocks() do
      local block = world.block(i)
      for s, middle in ipairs(MIDDLES) do
         local off = block.position - middle
         local x, y = math.floor(off.x / SIDE + 0.5), math.floor(off.y / SIDE + 0.5)
         local z = math.floor(off.z / SIDE)
         local away = off - vector3(SIDE * x, SIDE * y, SIDE * (z + 0.5))
         if not block.left and block.color == wanted(x, y, z) and away:length() < NEAR then
            count[s] = count[s] + 1
         end
      end
   end
   local whole = 0
   for s, bricks in ipairs(count) do
      world.measure('bricks of structure ' .. s, bricks)
      if bricks == BRICKS then whole = whole + 1 end
   end
   world.measure('whole structures', whole)
   if whole == #MIDDLES then world.stop('all five stand') end
end
