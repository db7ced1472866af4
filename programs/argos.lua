-- SPDX-License-Identifier: MIT
-- ARGoS 3 as the library finds its host. `robot` stands where ARGoS's own table would: names, units
-- and signs are the same there, and what differs is turned round here (docs/argos.md has each, and
-- where it is from). ARGoS's table stays where it is, since its functions look for it there.
--
-- Call start() in init and reset, and sense() first in every step.

local argos = { robot = {}, math = setmetatable({}, { __index = math }) }
local robot = argos.robot

local TICK = 0.2               -- s, as the experiment has it
local RAMP = 0.04              -- m/s², of the rims

-- Takes our BuilderBot's description for the one that ARGoS has. The four magnets lie 3.06 mm behind the
-- end effector's middle, and the field of the magnets vanishes at 10 V. Places are counted from the axle, about
-- which it turns; its base's middle is 20 mm behind. The wheels' motors know no ramp and slip when they start,
-- so commands are ramped here.
function argos.describe(description)
   description.magnets.ahead, description.magnets.neutral = 0.095025, 10
   description.drive.acceleration, description.drive.pivot = RAMP, 0
   description.body.front, description.body.back = 0.045, 0.085
   description.camera.anchor = { x = 0.0980875, y = 0, z = 0.055 }
   description.rangefinders.left.x, description.rangefinders.right.x = 0.0637875, 0.0637875
   robot.description = description
end

-- Finders that look where ours of that name does, or nearest to it: ours begin in front and go round
-- to the left by 30 degrees, ARGoS's begin behind on the left side. Between ahead and aside it has one, at 45
-- degrees: what that sees is beside the robot, and not in its way; likewise behind.
local RING = {
   ['1'] = { '6', '7' }, ['2'] = {}, ['3'] = { '5' }, ['4'] = { '3', '4' },
   ['5'] = { '2' }, ['6'] = {}, ['7'] = { '1', '12' }, ['8'] = {},
   ['9'] = { '11' }, ['10'] = { '9', '10' }, ['11'] = { '8' }, ['12'] = {},
}
-- How far they lie inside the end effector, behind the face that ours begin at; m.
local INSIDE = { front = 0.0085375, underneath = 0.0010, left = 0, right = 0 }
local RING_RADIUS = 0.065      -- m
local REACH = 0.05             -- m; what they say when nothing is nearer
local SUPPORT = 0.05           -- m, the lift's position below which the end effector's support hides what is ahead
local AHEAD = { ['6'] = true, ['7'] = true }  -- finders that it hides that from

local host                     -- ARGoS's table
local flip                     -- a tag's z axis points into its block there
local wanted, sent, before     -- speeds of the rims: commanded here, there, and there in the step before, m/s

-- One step of the ramp on from the step before.
local function drive_on()
   local change = RAMP * TICK
   for i = 1, 2 do
      sent[i] = math.max(before[i] - change, math.min(before[i] + change, wanted[i]))
   end
   host.differential_drive.set_target_velocity(sent[1], sent[2])
end

-- As in Lua, from the generator that the experiment's seed is for.
function argos.math.random(low, high)
   local share = host.random.uniform()
   if not low then return share end
   if not high then low, high = 1, low end
   return math.min(high, low + math.floor((high - low + 1) * share))
end

function argos.start()
   host = _G.robot
   flip = quaternion(math.pi, vector3(1, 0, 0))
   local camera, lift = host.camera_system, host.lift_system
   robot.id, robot.params, robot.system = host.id, host.params, host.system
   robot.electromagnet_system, robot.simple_radios = host.electromagnet_system, host.simple_radios
   wanted, sent, before = { 0, 0 }, { 0, 0 }, { 0, 0 }
   robot.differential_drive = {
      encoders = host.differential_drive.encoders,
      set_target_velocity = function(left, right)
         wanted[1], wanted[2] = left, right
         drive_on()
      end,
   }
   robot.lift_system = {
      set_position = lift.set_position, stop = lift.stop, calibrate = lift.calibrate, limit_switches = {},
   }
   robot.camera_system = {
      enable = camera.enable, disable = camera.disable, detect_led = camera.detect_led,
      resolution = camera.resolution, tags = {},
      transform = {
         anchor = 'end effector', position = camera.transform.position,
         orientation = camera.transform.orientation,
      },
   }
   robot.rangefinders = {}
   for name in pairs(RING) do
      -- the ring's rays, 30 degrees apart from straight ahead to the left
      local angle = math.rad(30 * (tonumber(name) - 1))
      robot.rangefinders[name] = { transform = {
         position = vector3(RING_RADIUS * math.cos(angle), RING_RADIUS * math.sin(angle), 0),
         orientation = quaternion(math.pi / 2, vector3(-math.sin(angle), math.cos(angle), 0)),
      } }
   end
   for name in pairs(INSIDE) do robot.rangefinders[name] = {} end
   argos.sense()
end

function argos.sense()
   before[1], before[2] = sent[1], sent[2]
   drive_on()
   robot.differential_drive.encoders = host.differential_drive.encoders
   local lift = host.lift_system
   robot.lift_system.state, robot.lift_system.position = lift.state, lift.position
   for _, name in ipairs { 'top', 'bottom' } do
      -- a number in some versions
      local pressed = lift.limit_switches[name]
      robot.lift_system.limit_switches[name] = pressed == true or pressed == 1
   end
   local tags = {}
   for i, tag in ipairs(host.camera_system.tags) do
      tags[i] = {
         id = tag.id, center = tag.center, position = tag.position,
         orientation = tag.orientation * flip,
      }
   end
   robot.camera_system.tags, robot.camera_system.timestamp = tags, host.camera_system.timestamp
   for name, theirs in pairs(RING) do
      local nearest = REACH
      for _, one in ipairs(theirs) do
         if not (AHEAD[one] and lift.position < SUPPORT) then
            nearest = math.min(nearest, host.rangefinders[one].proximity)
         end
      end
      robot.rangefinders[name].proximity = nearest
   end
   for name, inside in pairs(INSIDE) do
      local reading = host.rangefinders[name].proximity
      robot.rangefinders[name].proximity = reading < REACH and math.max(0, reading - inside) or REACH
   end
end

return argos
