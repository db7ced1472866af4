-- SPDX-License-Identifier: MIT
-- The program of the stigmergic block of 2017: dark until somebody touches one of its faces with
-- a radio. A message's first byte, '1' to '4', sets all LEDs to that colour; anything else turns
-- them off. A 'w' and four such digits, which blocks of 2017 did not know, set the four LEDs of each
-- face one by one, as a code word for more kinds of brick than four. Nor did they answer, as ours do: an
-- 'a' and the message tell whoever sent it that it came. Neighbours hear that too, and do nothing. What comes after a
-- 'p' is passed on by the lowest face, and one answer to it back: a robot reaches a brick by way of the block that it
-- holds over it, and one below that by way of both. Blocks stand as they were laid out, with their top up.

local FACES, LEDS = 6, 4
local LONGEST = LEDS + 3  -- bytes of a message: a code word by way of two blocks
local ANSWER, PASS = string.byte("a"), string.byte("p")

-- The face by which the next answer goes on that is heard at the lowest one.
local asks

local function colour_of(byte)
   local colour = (byte or 0) - string.byte("0")
   return colour >= 1 and colour <= 4 and colour or 0
end

local function show(message)
   robot.directional_leds.set_all_colors(colour_of(message[1]))
   if message[1] ~= string.byte("w") then return end
   for led = 1, FACES * LEDS do
      robot.directional_leds.set_single_color(led, colour_of(message[2 + (led - 1) % LEDS]))
   end
end

function init()
   robot.directional_leds.set_all_colors("off")
end

local function hear(face, message)
   local radios = robot.simple_radios
   if message[1] == PASS then
      asks = face
      radios.bottom.send({ table.unpack(message, 2, LONGEST) })
   elseif message[1] ~= ANSWER then
      show(message)
      radios[face].send({ ANSWER, table.unpack(message, 1, LEDS + 1) })
   elseif asks and face == "bottom" then
      radios[asks].send(message)
      asks = nil
   end
end

function step()
   for face, radio in pairs(robot.simple_radios) do
      for _, message in ipairs(radio.recv) do hear(face, message) end
   end
end
