-- SPDX-License-Identifier: MIT
-- Fetches a dark block, carries it round a square, and stacks it on a lit one. Parameters, all
-- optional: carry (m, of the way round), error and error_angle (mm and degrees, the most by which
-- both approaches are misjudged on purpose).

local geometry = require 'common.geometry'
local Approach = require 'manipulation.approach'
local Machine = require 'machine'

local machine
local misjudged    -- {x, y, yaw} in the frame of its line: the error of the next approach's last way

local function misjudge_next()
   local most, angle = (robot.params.error or 0) / 1000, math.rad(robot.params.error_angle or 0)
   misjudged = nil
   if most == 0 and angle == 0 then return end
   local function any(limit) return (2 * math.random() - 1) * limit end
   misjudged = { x = any(most), y = any(most), yaw = any(angle) }
end

-- In place of the approach's own: the line as it would be taken for with the error.
local function aim(approach, run)
   local line, off = Approach.aim(approach, run), misjudged
   misjudged = nil
   if not off then return line end
   local x, y = geometry.out_of(line, off.x, off.y)
   return { x = x, y = y, yaw = line.yaw + off.yaw }
end

local function dark(block) return block.level == 0 and block.colour == 0 end
local function lit(block) return block.colour >= 1 and block.colour <= 3 end

local function say(...)
   log(string.format('%.1f s: ', machine.odometry.time), ...)
end

-- In legs with a quarter turn between them; away from what stands in the way.
local function carry(way)
   local odometry, path = machine.odometry, machine.path
   local function blocked() return machine.clearance:blocked() end
   machine.process:enter('carry')
   local start = odometry.travelled
   while odometry.travelled - start < way do
      path:go_by(math.min(way / 4, way - (odometry.travelled - start)), nil, blocked)
      if blocked() then path:go_by(-0.10) end
      path:turn_by(math.pi / 2)
   end
end

local function fetch()
   local block = machine.search:find(dark)
   if not block then return say('no block found') end
   misjudge_next()
   local good, problem = machine.pickup:pick_up(block)
   if not good then return say('not picked up: ', problem) end
   say('picked up')
   machine.path:go_by(-0.10, 0.1)
   return true
end

local function stack()
   for _ = 1, 8 do
      local base = machine.search:find(lit)
      if not base then return say('no structure found') end
      misjudge_next()
      local good, problem = machine.placement:place(base, 'raise', { colour = 2 })
      if good then return say('done: stacked') end
      say('not stacked: ', problem)
   end
end

local function main()
   if not fetch() then return end
   carry(robot.params.carry or 2)
   say(machine.magnets:holds() and 'carried' or 'lost')
   stack()
end

local function start()
   machine = Machine.new(robot)
   machine.approach.aim = aim
   machine:start(main)
end

function init() start() end
function reset() start() end
function step() machine:step() end
