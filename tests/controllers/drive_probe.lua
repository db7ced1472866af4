-- SPDX-License-Identifier: MIT
-- Drives as its parameters say, and tells where it believes to be. Parameters: ahead (m), turn
-- (degrees), speed (m/s of the rims), times.

local Machine = require 'machine'
local machine

local function main()
   local params, path = robot.params, machine.path
   machine.process:wait(0.4)
   for _ = 1, params.times or 1 do
      if params.ahead then path:go_by(params.ahead, params.speed) end
      if params.turn then
         local whole, rest = math.modf(params.turn / 120)
         for _ = 1, whole do path:turn_by(math.rad(120), params.speed) end
         if rest ~= 0 then path:turn_by(math.rad(rest * 120), params.speed) end
      end
   end
   machine.process:wait(1)
   local pose = machine.odometry.pose
   log(string.format('done %.6f %.6f %.6f', pose.x, pose.y, pose.yaw))
end

function init()
   machine = Machine.new(robot)
   machine:start(main)
end
function step() machine:step() end
