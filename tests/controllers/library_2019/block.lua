-- SPDX-License-Identifier: MIT
-- Takes the colour that comes by radio.
local colours = { ['0'] = 'black', ['1'] = 'magenta', ['2'] = 'orange', ['3'] = 'green', ['4'] = 'blue' }

function step()
   for side, radio in pairs(robot.radios) do
      if #radio.rx_data > 0 then
         local letter = string.char(radio.rx_data[1][1])
         print('received ' .. letter .. ' on ' .. side)
         robot.directional_leds.set_all_colors(colours[letter])
      end
   end
end
