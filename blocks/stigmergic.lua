-- SPDX-License-Identifier: MIT
-- The program of the stigmergic block of 2017: dark until somebody touches one of its faces with
-- a radio. A message's first byte, '1' to '4', sets all LEDs to that colour; anything else turns
-- them off.

function init()
   robot.directional_leds.set_all_colors("off")
end

function step()
   for _, radio in pairs(robot.simple_radios) do
      for _, message in ipairs(radio.recv) do
         local colour = (message[1] or 0) - string.byte("0")
         if colour < 1 or colour > 4 then colour = 0 end
         robot.directional_leds.set_all_colors(colour)
      end
   end
end
