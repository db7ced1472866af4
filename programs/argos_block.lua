-- SPDX-License-Identifier: MIT
-- The block's program for ARGoS 3. A message's first byte, '1' to '4', sets all LEDs to that colour;
-- anything else turns them off. A 'w' and four such digits set the four LEDs of each face one by one, as
-- a code word. They begin as the experiment's file says.

local COLOURS = { [49] = 'magenta', [50] = 'orange', [51] = 'green', [52] = 'blue' }
local WORD = 119
local FACES, LEDS = 6, 4

function init() end

function step()
   for _, radio in pairs(robot.simple_radios) do
      for _, message in ipairs(radio.recv) do
         robot.directional_leds.set_all_colors(COLOURS[message[1]] or 'black')
         for led = 1, message[1] == WORD and FACES * LEDS or 0 do
            robot.directional_leds.set_single_color(led, COLOURS[message[2 + (led - 1) % LEDS]] or 'black')
         end
      end
   end
end

function reset() end

function destroy() end
