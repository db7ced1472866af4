-- SPDX-License-Identifier: MIT
-- The block's program for ARGoS 3. A message's first byte, '1' to '4', sets all LEDs to that colour;
-- anything else turns them off. A 'w' and four such digits set the four LEDs of each face one by one, as
-- a code word. An 'a' and the message are the answer to whoever sent it, which other blocks leave alone. What comes after a
-- 'p' is passed on by the lowest face, and one answer to it back. LEDs begin as the experiment's file says.

local COLOURS = { [49] = 'magenta', [50] = 'orange', [51] = 'green', [52] = 'blue' }
local WORD, ANSWER, PASS = 119, 97, 112
local FACES, LEDS = 6, 4
local LONGEST = LEDS + 3  -- bytes of a message: a code word by way of two blocks

local function show(message)
   robot.directional_leds.set_all_colors(COLOURS[message[1]] or 'black')
   for led = 1, message[1] == WORD and FACES * LEDS or 0 do
      robot.directional_leds.set_single_color(led, COLOURS[message[2 + (led - 1) % LEDS]] or 'black')
   end
end

-- The face by which the next answer goes on that is heard at the lowest one.
local asks

-- What was heard, from a byte on, after others: bytes come in as numbers with a fraction, and go out as whole ones.
local function after(out, message, from)
   for i = from, math.min(#message, LONGEST) do table.insert(out, math.floor(message[i])) end
   return out
end

local function hear(face, message)
   local radios = robot.simple_radios
   if message[1] == PASS then
      asks = face
      radios.bottom.send(after({}, message, 2))
   elseif message[1] ~= ANSWER then
      show(message)
      radios[face].send(after({ ANSWER }, message, 1))
   elseif asks and face == 'bottom' then
      radios[asks].send(after({}, message, 1))
      asks = nil
   end
end

function init() end

function step()
   for face, radio in pairs(robot.simple_radios) do
      for _, message in ipairs(radio.recv) do hear(face, message) end
   end
end

function reset() end

function destroy() end
