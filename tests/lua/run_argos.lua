-- SPDX-License-Identifier: MIT
-- Runs an experiment for a while against the mock of ARGoS, and says what came of it.
--
--     lua5.4 run_argos.lua EXPERIMENT.lua TICKS BRICKS
--
-- It ends earlier when so many blocks are lit and nobody carries one.

local mock = require 'mock_argos'
local world = require 'argos_world'

local experiment, ticks, bricks = dofile(arg[1]), tonumber(arg[2]), tonumber(arg[3])
world.start(experiment)

local function built()
   local lit = 0
   for _, block in ipairs(world.blocks) do
      if block.held then return false end
      if block.colour ~= 'black' then lit = lit + 1 end
   end
   return lit >= bricks
end

local tick = 0
repeat
   tick = tick + 1
   world.step()
until tick >= ticks or built()
for _, one in ipairs(world.robots) do one.script.reset() end
for _ = 1, 5 do world.step() end
for _, one in ipairs(world.robots) do one.script.destroy() end

print('ticks ' .. tick)
for _, robot in ipairs(world.robots) do
   print(string.format('robot %s picked %d travelled %.2f', robot.id, robot.picked, robot.travelled))
end
for _, block in ipairs(world.blocks) do
   print(string.format('block %s %s %.4f %.4f %.4f %.3f', block.id, block.colour, block.x, block.y, block.z, block.yaw))
end
local names = {}
for name in pairs(mock.calls) do table.insert(names, name) end
table.sort(names)
for _, name in ipairs(names) do print('call ' .. name .. ' ' .. mock.calls[name]) end
