-- SPDX-License-Identifier: MIT
-- The block's program for ARGoS 3. A message's first byte, '1' to '4', sets all LEDs to that colour;
-- anything else turns them off. A 'w' and four such digits set the four LEDs of each face one by one, as
-- a code word. An 'a' and the message are the answer to whoever sent it, which other blocks leave alone. LEDs
-- begin as the experiment's file says.

local COLOURS = { [49] = 'magenta', [50] = 'orange', [51] = 'green', [52] = 'blue' }
local WORD, ANSWER = 119, 97
local FACES, LEDS = 6, 4

local function show(message)
   robot.directional_leds.set_all_colors(COLOURS[message[1]] or 'black')
   for led = 1, message[1] == WORD and FACES * LEDS or 0 do
      robot.directional_leds.set_single_color(led, COLOURS[message[2 + (led - 1) % LEDS]] or 'black')
   end
end

-- What was heard, said again with an 'a' before it: bytes come in as numbers with a fraction, and go out as whole ones.
local function answer(message)
   local out = { ANSWER }
   for i = 1, math.min(#message, LEDS + 1) do out[i + 1] = math.floor(message[i]) end
   return out
end

function init() end

function step()
   for _, radio in pairs(robot.simple_radios) do
      for _, message in ipairs(radio.recv) do
         if message[1] ~= ANSWER then
            show(message)
            radio.send(answer(message))
         end
      end
   end
end

function reset() end

function destroy() end
