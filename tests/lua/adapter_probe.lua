-- SPDX-License-Identifier: MIT
-- A controller's script below the adapter, in the world that check_argos.py sets up for it: a block
-- ahead of the chassis (the magnets draw it, and the support hides it), one 30 mm to the left, one 40 mm behind, and an orange
-- one farther ahead, turned by 20 degrees.
-- luacheck: read globals argos

local robot, math = argos.robot, argos.math
argos.describe { magnets = {}, drive = {}, camera = {}, body = {},
                 rangefinders = { left = {}, right = {} } }

local function near(what, is, wanted, within)
   if math.abs(is - wanted) > (within or 1e-6) then
      error(string.format('%s: %.6f, wanted %.6f', what, is, wanted), 2)
   end
end

local function check_ranges()
   local function range(name) return robot.rangefinders[name].proximity end
   near('ahead, behind the support of the end effector', range '1', 0.05)
   near('to the left', range '4', 0.030)
   near('behind', range '7', 0.040)
   near('to the right', range '10', 0.05)
   -- of the block in its hand: how it sits, as Gripper:seat asks
   local gap = robot.description.magnets.ahead - 0.0275 - robot.description.rangefinders.left.x
   near('left', range 'left', gap)
   near('right', range 'right', gap)
   near('underneath', range 'underneath', 0)
end

local function check_tags()
   local camera, anchor = robot.camera_system, robot.description.camera.anchor
   assert(camera.transform.anchor == 'end effector' and camera.resolution.x == 320)
   local eye = camera.transform.position +
               vector3(anchor.x, anchor.y, anchor.z + robot.lift_system.position)
   near('height of the camera', eye.z, 0.130)
   local found
   for _, tag in ipairs(camera.tags) do
      local turn = camera.transform.orientation
      local place = vector3(tag.position):rotate(turn) + eye
      local normal = vector3(0, 0, 1):rotate(turn * tag.orientation)
      if normal.z > 0.99 and place.x > 0.15 then
         found = true
         near('x of the tag', place.x, 0.22)
         near('y of the tag', place.y, 0.02)
         near('z of the tag', place.z, 0.05555, 1e-4)
         local axis = vector3(1, 0, 0):rotate(turn * tag.orientation)
         near('turn of the block', math.deg(math.atan(axis.y, axis.x)) % 90, 20)
         local led = vector3(0.020, 0, -0.001):rotate(tag.orientation)
         assert(camera.detect_led(tag.position + led) == 2)
      end
   end
   assert(found, 'the block ahead is not seen from above')
end

local function check_random()
   for _ = 1, 200 do
      local share, one, two = math.random(), math.random(3), math.random(5, 6)
      assert(share >= 0 and share < 1)
      assert(one == 1 or one == 2 or one == 3)
      assert(two == 5 or two == 6)
      assert(math.type(one) == 'integer')
   end
end

local steps = 0
function init()
   argos.start()
   robot.camera_system.enable()
end
function reset() end
function step()
   argos.sense()
   steps = steps + 1
   if steps < 3 then return end
   near('time', robot.system.time, 0.2 * steps)
   assert(robot.params.side == '-y' and robot.id == '1')
   assert(robot.lift_system.limit_switches.bottom and not robot.lift_system.limit_switches.top)
   check_ranges()
   check_tags()
   check_random()
end
function destroy() log('probed') end
