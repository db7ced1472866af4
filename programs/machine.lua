-- SPDX-License-Identifier: MIT
-- A robot with its parts: what it perceives with, moves with and handles blocks with. Written for the
-- interface of the real robot (docs/controllers.md); its figures are those of `robot.description`.
--
--     function init()
--        machine = Machine.new(robot)
--        machine:start(function() machine.pickup:pick_up(...) end)
--     end
--     function step()  machine:step()  end

local Process = require 'common.process'
local Odometry = require 'perception.odometry'
local RangeSensors = require 'perception.range_sensors'
local Camera = require 'perception.camera'
local BlockDetector = require 'perception.block_detector'
local BlockTracker = require 'perception.block_tracker'
local LineOfSight = require 'perception.line_of_sight'
local UnexplainedReturns = require 'perception.unexplained_returns'
local Clearance = require 'motion.clearance'
local Sweep = require 'motion.sweep'
local PathFollower = require 'motion.path_following'
local Search = require 'motion.search'
local Magnets = require 'manipulation.magnets'
local Lift = require 'manipulation.lift'
local Gripper = require 'manipulation.gripper'
local Approach = require 'manipulation.approach'
local Pickup = require 'manipulation.pickup'
local Placement = require 'manipulation.placement'

local Machine = {}
Machine.__index = Machine

-- What the robot's description has to say for the parts below.
local NEEDED = { 'drive', 'lift', 'effector', 'body', 'magnets', 'camera', 'rangefinders' }

-- Call it in init or reset, once readings are there.
function Machine.new(robot)
   local description = robot.description
   for _, name in ipairs(NEEDED) do
      if not description[name] then error('the robot has no ' .. name) end
   end
   local self = setmetatable({ robot = robot, description = description, dozes = false }, Machine)
   self:perceive_with(robot, description)
   self:move_with(robot, description)
   self:handle_with(robot, description)
   robot.camera_system.enable()
   return self
end

function Machine:perceive_with(robot, description)
   self.odometry = Odometry.new(robot, description)
   self.process = Process.new(robot, self.odometry)
   self.ranges = RangeSensors.new(robot, description)
   self.camera = Camera.new(robot, description)
   local detector = BlockDetector.new(robot, self.camera)
   self.tracker = BlockTracker.new(self.odometry, self.camera, detector)
   self.sight = LineOfSight.new(self.odometry, self.camera, self.tracker)
   self.sweep = Sweep.new(description)
   self.returns = UnexplainedReturns.new(self.odometry, self.ranges, self.tracker, self.sweep)
end

function Machine:move_with(robot, description)
   self.magnets = Magnets.new(robot, self.ranges)
   self.lift = Lift.new(robot, description, self.odometry, self.process, self.magnets)
   self.clearance = Clearance.new(robot, description, self.process, self.ranges, self.magnets,
                                  self.sweep, self.returns)
   self.path = PathFollower.new(robot, description, self.odometry, self.process, self.ranges,
                                self.clearance)
   self.search = Search.new(self.odometry, self.process, self.tracker, self.magnets, self.lift,
                            self.clearance, self.path)
end

function Machine:handle_with(robot, description)
   self.gripper = Gripper.new(robot, description, self.ranges, self.process, self.magnets, self.lift)
   self.approach = Approach.new {
      description = description, odometry = self.odometry, process = self.process, ranges = self.ranges,
      camera = self.camera, tracker = self.tracker, clearance = self.clearance, sweep = self.sweep,
      path = self.path, magnets = self.magnets, lift = self.lift,
   }
   self.pickup = Pickup.new(self.process, self.tracker, self.path, self.approach, self.gripper, self.lift)
   self.placement = Placement.new {
      odometry = self.odometry, process = self.process, tracker = self.tracker, path = self.path,
      magnets = self.magnets, lift = self.lift, gripper = self.gripper, approach = self.approach,
   }
end

-- Runs `main` from now on, a step of it in each `step()`.
function Machine:start(main)
   self.process:start(main)
end

-- One that `dozes` stands, and looks at no pictures and ranges; it knows where it is, and whether it holds its block.
function Machine:sense()
   self.tracker:add_process_noise(self.odometry:sense())
   if not self.dozes then
      self.tracker:sense()
      self.returns:sense()
   end
   self.gripper:sense()
end

-- Senses, and goes on with the behaviour. False when it has ended.
function Machine:step()
   self:sense()
   return self.process:resume()
end

return Machine
