-- SPDX-License-Identifier: MIT
-- The least of a world in which ARGoS's BuilderBots can work: wheels that turn as told, a lift, magnets
-- that draw what is near enough, blocks that fall straight down, tags and LEDs in a camera's picture.
-- No forces, and nothing pushes anything. Sizes and laws of the devices are ARGoS's.

local mock = require 'mock_argos'
local senses = require 'argos_senses'
local world = { blocks = senses.blocks, robots = {}, time = 0 }

local turned, on_robot = senses.turned, senses.on_robot

local SIDE, HALF = 0.055, 0.0275
local TICK = 0.2
local TRACK = 0.120
local HOLDS = 0.012            -- m/s, by which rims may change a turn in a tick without slipping
local GRIP, EFFECTOR, UNDER = 0.095025, 0.0980875, 0.055
local RADIO = 0.020

-- The same numbers in every run.
local seed = 1
local function random()
   seed = (1103515245 * seed + 12345) % 0x80000000
   return seed / 0x80000000
end

-- Radios --------------------------------------------------------------------------------------

-- Numbers come as floats.
local function copy_of(message)
   local copy = {}
   for i, byte in ipairs(message) do copy[i] = byte + 0.0 end
   return copy
end

local function in_reach(from, to)
   local dx, dy, dz = to[1] - from[1], to[2] - from[2], to[3] - from[3]
   return dx * dx + dy * dy + dz * dz < RADIO * RADIO
end

local function radio_of(robot)
   return on_robot(robot, EFFECTOR - 0.0343, 0, UNDER + robot.lift - 0.0275)
end

-- From a robot to blocks.
local function send(robot, message)
   for _, block in ipairs(world.blocks) do
      for _, face in ipairs(mock.FACES) do
         if in_reach(radio_of(robot), senses.face_of(block, face)) then
            table.insert(block.inbox[face], copy_of(message))
         end
      end
   end
end

-- From a block to robots.
local function answer(block, face, message)
   for _, robot in ipairs(world.robots) do
      if in_reach(radio_of(robot), senses.face_of(block, face)) then table.insert(robot.inbox, copy_of(message)) end
   end
end

-- Blocks --------------------------------------------------------------------------------------

local function add_block(one, program)
   local block = {
      id = one.id, x = one.x, y = one.y, z = one.z + HALF, yaw = math.rad(one.turn), fixed = one.fixed,
      colour = one.colour, leds = {}, radios = {}, inbox = {},
   }
   for _, face in ipairs(mock.FACES) do block.inbox[face] = {} end
   block.script = mock.load(program.script, program.devices, one.id, program.params, {
      log = print, radios = mock.FACES, colour = function(colour) block.colour, block.leds = colour, {} end,
      led = function(led, colour)
         block.leds[led] = colour
         -- as the first face shows it
         if led == 4 then block.colour = table.concat(block.leds, '/') end
      end,
      send = function(face, message) answer(block, face, message) end,
   })
   block.script.init()
   table.insert(world.blocks, block)
end

local function step_block(block)
   for _, face in ipairs(mock.FACES) do
      block.script.fields['radio ' .. face].recv = block.inbox[face]
      block.inbox[face] = {}
   end
   block.script.step()
end

-- Falls straight down on what is there, and clings to what is right beside or below it.
local function drop(block)
   local floor = HALF
   block.held = false
   for _, other in ipairs(world.blocks) do
      local x, y = turned(block.x - other.x, block.y - other.y, -other.yaw)
      if other ~= block and other.z < block.z and math.max(math.abs(x), math.abs(y)) < 0.9 * SIDE then
         floor = math.max(floor, other.z + SIDE)
      end
   end
   block.z = floor
   for _, other in ipairs(world.blocks) do
      local x, y = turned(block.x - other.x, block.y - other.y, -other.yaw)
      local u, v = math.floor(x / SIDE + 0.5), math.floor(y / SIDE + 0.5)
      local level = math.floor((block.z - other.z) / SIDE + 0.5)
      local off = math.max(math.abs(x - u * SIDE), math.abs(y - v * SIDE))
      if other ~= block and math.abs(u) + math.abs(v) + math.abs(level) == 1 and off < 0.025 then
         local px, py = turned(u * SIDE, v * SIDE, other.yaw)
         block.x, block.y, block.yaw = other.x + px, other.y + py, other.yaw
         return
      end
   end
end

local function alone(block)
   for _, other in ipairs(world.blocks) do
      local dx, dy, dz = block.x - other.x, block.y - other.y, block.z - other.z
      if other ~= block and dx * dx + dy * dy + dz * dz < (1.25 * SIDE) ^ 2 then return false end
   end
   return not block.fixed and block.z < SIDE
end

-- Robots --------------------------------------------------------------------------------------

local function add_robot(one, program)
   local robot = {
      id = one.id, x = one.x, y = one.y, yaw = math.rad(one.turn), left = 0, right = 0, spin = 0, travelled = 0,
      lift = 0, voltage = 0, mode = 'disable', watches = false, leds = {}, picked = 0, inbox = {},
   }
   robot.script = mock.load(program.script, program.devices, one.id, program.params, {
      log = print, random = random, radios = { 'nfc', 'wifi' }, finders = senses.finders,
      velocity = function(left, right) robot.left, robot.right = left, right end,
      discharge = function(mode) robot.mode = mode end,
      lift = function(height) robot.target = height end,
      lift_stop = function() robot.target = nil end,
      camera = function(on) robot.watches = on end,
      detect_led = function(at) return senses.detect_led(robot, at) end,
      send = function(radio, message) if radio == 'nfc' then send(robot, message) end end,
   })
   robot.script.init()
   table.insert(world.robots, robot)
end

-- As ARGoS's lift moves: half the error a second, within 10 and 18 mm/s.
local function move_lift(robot)
   if not robot.target then return end
   local off = robot.target - robot.lift
   if math.abs(off) < 0.001 then robot.target = nil return end
   local speed = math.max(0.010, math.min(0.018, 0.5 * math.abs(off)))
   if off < 0 then speed = -speed end
   if speed < 0 and robot.lift < 0.001 then robot.target = nil return end
   robot.lift = math.max(0, math.min(0.1375, robot.lift + speed * TICK))
end

local function move_magnets(robot)
   local change = 0.38 * (22.9 - robot.voltage)
   local sign = robot.mode == 'constructive' and 1 or robot.mode == 'destructive' and -1 or 0
   if sign ~= 0 then change = change - 1.3 * (robot.voltage - 6.5) end
   robot.voltage = robot.voltage + TICK * change
   local reach = math.min(0.02, 0.015 * (1 + sign * 0.1 * robot.voltage))
   if robot.carries and reach <= 0 then
      drop(robot.carries)
      robot.carries = nil
   end
   if robot.carries then return end
   local grip = on_robot(robot, GRIP, 0, UNDER + robot.lift)
   for _, block in ipairs(world.blocks) do
      local off = math.sqrt((block.x - grip[1]) ^ 2 + (block.y - grip[2]) ^ 2)
      local gap = grip[3] - block.z - HALF
      -- the magnets lie 1 mm and 4.5 mm under the surfaces
      if not block.held and off < 0.012 and gap > -0.002 and gap + 0.0055 < reach and alone(block) then
         robot.carries, block.held, robot.picked = block, true, robot.picked + 1
         return
      end
   end
end

local function carry(robot)
   local block = robot.carries
   if not block then return end
   local at = on_robot(robot, GRIP, 0, math.max(HALF, UNDER + robot.lift - HALF))
   block.x, block.y, block.z = at[1], at[2], at[3]
   local quarter = math.pi / 2
   block.yaw = robot.yaw + quarter * math.floor((block.yaw - robot.yaw) / quarter + 0.5)
end

local function step_robot(robot)
   local f = robot.script.fields
   local tags, leds = senses.look(robot)
   if world.time < 1.5 * TICK then tags = {} end  -- ARGoS's camera says nothing in the first step
   robot.leds = leds
   f.camera_system.tags, f.camera_system.timestamp = tags, world.time
   f.encoders.left, f.encoders.right = robot.left, robot.right
   f.electromagnet_system.voltage = robot.voltage
   f.lift_system.state = robot.target and 'position_control' or 'inactive'
   f.lift_system.position = robot.lift
   f.switches.top, f.switches.bottom = robot.lift > 0.1375 and 1 or 0, robot.lift < 0.001 and 1 or 0
   for _, name in ipairs(senses.finders) do f['finder ' .. name].proximity = senses.range(robot, name) end
   f.system.time = world.time
   if f['radio nfc'] then f['radio nfc'].recv, robot.inbox = robot.inbox, {} end
   robot.script.step()
end

-- The body takes up a turn only so fast: where the rims change theirs faster they slip, and encoders, which
-- are the rims', say nothing of it.
local function drive(robot)
   local left, right = robot.left, -robot.right
   local change = (right - left) / 2 - robot.spin
   robot.spin = robot.spin + math.max(-HOLDS, math.min(HOLDS, change))
   local ahead, turn = (left + right) / 2 * TICK, 2 * robot.spin / TRACK * TICK
   local dx, dy = turned(ahead, 0, robot.yaw + turn / 2)
   robot.x, robot.y, robot.yaw = robot.x + dx, robot.y + dy, robot.yaw + turn
   robot.travelled = robot.travelled + math.abs(ahead)
end

-- The experiment's file as a table: see check_argos.py.
function world.start(experiment)
   for _, one in ipairs(experiment.blocks) do add_block(one, experiment.controllers[one.controller]) end
   for _, one in ipairs(experiment.robots) do add_robot(one, experiment.controllers[one.controller]) end
end

function world.step()
   world.time = world.time + TICK
   for _, block in ipairs(world.blocks) do step_block(block) end
   for _, robot in ipairs(world.robots) do step_robot(robot) end
   for _, robot in ipairs(world.robots) do
      drive(robot)
      move_lift(robot)
      carry(robot)
      move_magnets(robot)
   end
end

return world
