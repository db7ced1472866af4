-- SPDX-License-Identifier: MIT
-- Fetches a dark block, carries it round a square, and stacks it on a lit one. Parameters, all
-- optional: carry (m, of the way round), error and error_angle (mm and degrees, the most by which
-- both approaches are misjudged on purpose).

local robotics = require 'robotics'
local handling = require 'handling'

local function error_on_purpose()
   local most, angle = (robot.params.error or 0) / 1000, math.rad(robot.params.error_angle or 0)
   if most == 0 and angle == 0 then return nil end
   local function any(limit) return (2 * math.random() - 1) * limit end
   return { x = any(most), y = any(most), yaw = any(angle) }
end

local function dark(block) return block.level == 0 and block.colour == 0 end
local function lit(block) return block.colour >= 1 and block.colour <= 3 end

local function say(...)
   log(string.format('%.1f s: ', robotics.time), ...)
end

-- In legs with a quarter turn between them; away from what stands in the way.
local function carry(way)
   handling.enter('carry')
   local start = robotics.travelled
   while robotics.travelled - start < way do
      local pose, leg = robotics.pose, math.min(way / 4, way - (robotics.travelled - start))
      local line = { x = pose.x, y = pose.y, yaw = pose.yaw }
      handling.follow(line, leg, robotics.profile.cruise, handling.blocked)
      if handling.blocked() then handling.go_by(-0.10) end
      handling.turn_by(math.pi / 2)
   end
end

local function main()
   local block = handling.search(dark)
   if not block then return say('no block found') end
   local good, problem = handling.pick_up(block, { misjudged = error_on_purpose() })
   if not good then return say('not picked up: ', problem) end
   say('picked up')
   handling.go_by(-0.10, 0.1)
   carry(robot.params.carry or 2)
   say(handling.holds() and 'carried' or 'lost')
   for _ = 1, 8 do
      local base = handling.search(lit)
      if not base then return say('no structure found') end
      good, problem = handling.place(base, 'raise', { colour = 2, misjudged = error_on_purpose() })
      if good then return say('done: stacked') end
      say('not stacked: ', problem)
   end
end

function init() handling.start(main) end
function reset() handling.start(main) end
function step() handling.step() end
