-- SPDX-License-Identifier: MIT
-- Every two seconds, a block comes 4 mm before each face that shows Q2.
local NORMALS = {
   vector3(1, 0, 0), vector3(0, -1, 0), vector3(-1, 0, 0), vector3(0, 1, 0),
   vector3(0, 0, 1), vector3(0, 0, -1),
}
local OFFER, EVERY, AWAY = 2, 2, 0.059
local next_time, waited = 1, 0

function on_step(world)
   if world.time() < next_time then return end
   next_time = world.time() + EVERY
   local came = false
   for number = 1, world.blocks() do
      local block = world.block(number)
      for face, colour in ipairs(block.faces) do
         if colour == OFFER then
            local way = vector3(NORMALS[face]):rotate(block.orientation)
            local where, aside = block.position + way * AWAY, way:cross(vector3(0, 0, 1))
            local yaw = block.orientation:toeulerangles()
            -- A neighbour may stand a little askew.
            for _, shift in ipairs { 0, 0.003, -0.003 } do
               if world.drop(where + aside * shift, yaw) then came = true break end
            end
         end
      end
   end
   waited = came and 0 or waited + 1
   if waited == 3 then world.stop('nothing is offered any more') end
end

function on_end(world)
   local sizes = {}
   for number = 1, world.blocks() do
      local block = world.block(number)
      if block.lattice then sizes[block.lattice] = (sizes[block.lattice] or 0) + 1 end
   end
   world.measure('blocks', world.blocks())
   world.measure('largest', sizes[1] or 0)
   world.measure('second', sizes[2] or 0)
end
