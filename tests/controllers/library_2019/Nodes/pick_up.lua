-- SPDX-License-Identifier: MIT
-- luacheck: globals Say api package debug
-- Drives blindly onto a block that is straight ahead, takes it and sets its colour by radio.
local sequence, timer = require('sequence'), require('timer')
Say.name('pick up')

return function(target)
   return sequence {
      function()
         -- Seen in the very first step, since init has switched the camera on.
         local place = api.blocks[1]
         Say('block at', place.x, place.y)
         robot.debug.draw('arrow(red)(0,0,0)(' .. place.x .. ',' .. place.y .. ',0.1)')
         target.far = place.x - api.effector.x
         robot.electromagnet_system.set_discharge_mode('disable')
         robot.lift_system.set_position(0.06)
      end,
      timer(6),
      function() target.seconds = target.far / api.speed end,
      function() target.drive = timer(target.seconds, function() api.move(api.speed, api.speed) end) end,
      function() return target.drive() end,
      function() api.move(0, 0) end,
      function()
         robot.lift_system.set_position(0)
         return robot.rangefinders['underneath'].proximity > 0.003
      end,
      function() robot.electromagnet_system.set_discharge_mode('constructive') end,
      timer(2),
      function() robot.lift_system.set_position(robot.lift_system.position + 0.05) end,
      timer(3),
      function()
         robot.nfc.write(tostring(target.type))
         robot.electromagnet_system.set_discharge_mode('disable')
      end,
      timer(1),
   }
end
