-- SPDX-License-Identifier: MIT
-- luacheck: globals Say api package debug
-- What a step knows of the world, from places as they were told in 2019.
local api = { speed = tonumber(robot.params.default_speed or 0.01), effector = vector3(0.098, 0, 0.055) }
local half = vector3(0, 0, -0.0275)

function api.move(left, right)
   robot.differential_drive.set_target_velocity(left, -right)
end

function api.process()
   local camera = robot.camera_system.transform
   assert(camera.anchor == 'end_effector')
   local at = camera.position + api.effector + vector3(0, 0, robot.lift_system.position)
   api.blocks = {}
   for _, tag in ipairs(robot.camera_system.tags) do
      local middle = vector3(half):rotate(tag.orientation) + tag.position
      table.insert(api.blocks, vector3(middle):rotate(camera.orientation) + at)
   end
end

return api
