-- SPDX-License-Identifier: MIT
-- Drives as its parameters say, and tells where it believes to be. Parameters: ahead (m), turn
-- (degrees), speed (m/s of the rims), times.

local robotics = require 'robotics'
local handling = require 'handling'

local function main()
   local params = robot.params
   handling.wait(0.4)
   for _ = 1, params.times or 1 do
      if params.ahead then handling.go_by(params.ahead, params.speed) end
      if params.turn then
         local whole, rest = math.modf(params.turn / 120)
         for _ = 1, whole do handling.turn_by(math.rad(120), params.speed) end
         if rest ~= 0 then handling.turn_by(math.rad(rest * 120), params.speed) end
      end
   end
   handling.wait(1)
   local pose = robotics.pose
   log(string.format('done %.6f %.6f %.6f', pose.x, pose.y, pose.yaw))
end

function init() handling.start(main) end
function step() handling.step() end
