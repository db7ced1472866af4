-- SPDX-License-Identifier: MIT
-- The block's program for ARGoS 3. A message's first byte, '1' to '4', sets all LEDs to that colour;
-- anything else turns them off. They begin as the experiment's file says.

local COLOURS = { [49] = 'magenta', [50] = 'orange', [51] = 'green', [52] = 'blue' }

function init() end

function step()
   for _, radio in pairs(robot.simple_radios) do
      for _, message in ipairs(radio.recv) do
         robot.directional_leds.set_all_colors(COLOURS[message[1]] or 'black')
      end
   end
end

function reset() end

function destroy() end
