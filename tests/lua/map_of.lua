-- SPDX-License-Identifier: MIT
-- Maps of structures for unit tests.

local FakeRobot = require 'fake_robot'
local Machine = require 'machine'
local StructureMap = require 'mission.structure_map'
local geometry = require 'common.geometry'

local SIDE = geometry.SIDE

-- A map of a structure of these cells {along, across, level}, whose first is at a frame's origin, as a
-- robot remembers it.
return function(cells, frame, task, params)
   local fake = FakeRobot.new()
   fake.robot.params = params or {}
   local machine = Machine.new(fake.robot)
   local map = StructureMap.new(fake.robot, machine.odometry, machine.tracker, task)
   for i, cell in ipairs(cells) do
      local x, y = geometry.out_of(frame, SIDE * cell[1], SIDE * cell[2])
      machine.tracker.tracks[i] = {
         id = i, x = x, y = y, z = SIDE * (cell[3] + 0.5), level = cell[3], yaw = frame.yaw, turned = 1e-4,
         colour = cell.colour or 1, seen = 9, missed = 0, time = 0, top_time = 0,
      }
   end
   return map, machine
end
