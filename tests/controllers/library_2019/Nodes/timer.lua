-- SPDX-License-Identifier: MIT
-- A node that runs for a time, calling a function at each step.
return function(seconds, during)
   local begun
   return function()
      begun = begun or robot.system.time
      if robot.system.time - begun >= seconds then
         begun = nil
         return false, true
      end
      if during then during() end
      return true
   end
end
