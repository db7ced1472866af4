-- SPDX-License-Identifier: MIT
-- What a robot perceives, against what is there.

local FakeRobot = require 'fake_robot'
local geometry = require 'common.geometry'
local led_code = require 'common.led_code'
local profile = require 'motion.profile'
local structures = require 'perception.structures'
local BlockDetector = require 'perception.block_detector'
local BlockTracker = require 'perception.block_tracker'
local Camera = require 'perception.camera'
local LineOfSight = require 'perception.line_of_sight'
local Odometry = require 'perception.odometry'
local RangeSensors = require 'perception.range_sensors'
local UnexplainedReturns = require 'perception.unexplained_returns'
local Sweep = require 'motion.sweep'
local unit = require 'unit'
local case, near, same = unit.case, unit.near, unit.same

-- A robot with what perceives, and a step of all.
local function perceiver(blocks)
   local fake = FakeRobot.new(blocks)
   local robot, description = fake.robot, fake.robot.description
   local odometry, camera = Odometry.new(robot, description), Camera.new(robot, description)
   local tracker = BlockTracker.new(odometry, camera, BlockDetector.new(robot, camera))
   local ranges = RangeSensors.new(robot, description)
   local self = {
      fake = fake, robot = robot, odometry = odometry, camera = camera, tracker = tracker,
      ranges = ranges, sight = LineOfSight.new(odometry, camera, tracker),
      returns = UnexplainedReturns.new(odometry, ranges, tracker, Sweep.new(description)),
   }
   function self.step(times)
      for _ = 1, times or 1 do
         fake:step()
         tracker:add_process_noise(odometry:sense())
         tracker:sense()
         self.returns:sense()
      end
   end
   return self
end

case('a frame and back', function()
   local frame = { x = 1, y = -2, yaw = 0.7 }
   local x, y = geometry.into(frame, geometry.out_of(frame, 0.3, -0.4))
   near('x', x, 0.3)
   near('y', y, -0.4)
   near('quarter turns', geometry.wrap_quarter(math.pi / 2 + 0.1), 0.1)
   near('three quarters back', geometry.wrap(1.5 * math.pi), -math.pi / 2)
   same('level', geometry.level_of(2.5 * geometry.SIDE), 2)
end)

case('a rim stops where the profile says, and within its acceleration', function()
   local left, speed = 0.5, 0
   for _ = 1, 200 do
      local after = profile.speed(left, speed, 0.1, 0.2, 1)
      assert(after >= 0 and after <= 0.1 + 1e-9 and math.abs(after - speed) <= 0.2 + 1e-9)
      left, speed = left - profile.distance(speed, after, 0.2, 1), after
   end
   near('left', left, 0, 1e-5)
   near('backwards', profile.speed(-0.3, 0, 0.1, 0.2, 1), -profile.speed(0.3, 0, 0.1, 0.2, 1))
end)

-- What was learnt before a turn counts little after it: the wheels slip.
case('after looks to both sides a block is where it is seen by then', function()
   local p = perceiver { { x = 0.25, y = 0, colour = 1 } }
   p.robot.lift_system.set_position(0.05)
   p.step(40)
   local before = p.tracker:blocks()[1].x
   for _ = 1, 160 do p.tracker:add_process_noise(0, 0.02) end
   p.fake.pose.x = p.fake.pose.x + 0.010
   p.step(6)
   near('nearer', p.tracker:blocks()[1].x, before - 0.010, 0.0015)
end)

-- By place alone each would be taken for the one that stood nearer to it.
case('blocks of a row are known again by their colours after a slip', function()
   local p = perceiver { { x = 0.26, y = -0.02, colour = 1 }, { x = 0.26, y = 0.035, colour = 2 } }
   p.robot.lift_system.set_position(0.05)
   p.step(40)
   local before = {}
   for _, known in ipairs(p.tracker:blocks()) do before[known.colour] = known end
   p.fake.pose.y = p.fake.pose.y + 0.035
   p.step(6)
   same('none is new', #p.tracker:blocks(), 2)
   for colour, known in pairs(before) do
      same('colour ' .. colour, known.colour, colour)
      near('aside ' .. colour, known.y, (colour == 1 and -0.02 or 0.035) - 0.035, 0.003)
   end
end)

case('odometry follows a curve', function()
   local p = perceiver()
   p.robot.differential_drive.set_target_velocity(0.05, -0.06)
   p.step(20)
   near('x', p.odometry.pose.x, p.fake.pose.x, 1e-6)
   near('y', p.odometry.pose.y, p.fake.pose.y, 1e-6)
   near('yaw', p.odometry.pose.yaw, p.fake.pose.yaw, 1e-9)
   near('travelled', p.odometry.travelled, 0.055 * 4 - 0.055 ^ 2 / 2, 2e-4)
   near('time', p.odometry.time, 4)
   local along, aside = p.odometry:on_line { x = 0, y = 0, yaw = math.pi / 2 }
   near('along', along, p.fake.pose.y, 1e-6)
   near('aside', aside, -p.fake.pose.x, 1e-6)
end)

case('two code words differ in three LEDs of four, or in two where there are more than sixteen', function()
   for kinds, distance in pairs { [4] = 4, [16] = 3, [62] = 2 } do
      for one = 1, kinds do
         for other = 1, one - 1 do
            local a, b, differ = led_code.word_of(one), led_code.word_of(other), 0
            for i = 1, 4 do differ = differ + (a[i] ~= b[i] and 1 or 0) end
            assert(differ >= distance, string.format('%d and %d', one, other))
         end
      end
   end
end)

case('a kind is known with an LED missed, and with few kinds with one misread', function()
   for kind = 1, 62 do
      local kinds = kind <= 16 and 16 or 62
      same('whole', led_code.kind_of(led_code.word_of(kind), kinds), kind)
      for i = 1, 4 do
         local word = led_code.word_of(kind)
         word[i] = 0
         same('missed', led_code.kind_of(word, kinds), kind)
         word[i] = led_code.word_of(kind)[i] % 4 + 1
         if kinds == 16 then same('misread', led_code.kind_of(word, kinds), kind) end
         same('misread, of many', led_code.kind_of(word, 62) ~= kind, true)
      end
   end
   same('dark', led_code.kind_of({ 0, 0, 0, 0 }, 16), 0)
   same('one alone', led_code.kind_of({ 0, 0, 0, 2 }, 16), nil)
end)

case('a block that shows a code word is known by it', function()
   for _, kind in ipairs { 5, 11, 16, 17, 40, 62 } do
      local p = perceiver { { x = 0.30, y = 0.02, level = 0, yaw = 0.3, colour = kind } }
      p.tracker.detector.kinds = kind <= 16 and 16 or 62
      p.robot.lift_system.set_position(0.09)
      p.step(5)
      same('kind', p.tracker:blocks()[1].colour, kind)
      p.fake.dark_led = 2
      p.step(5)
      same('an LED missed', p.tracker:blocks()[1].colour, kind)
   end
end)

case('blocks of a column are found where they stand, in their colours', function()
   local p = perceiver { { x = 0.30, y = 0.02, level = 0, yaw = 0.3, colour = 3 },
                                    { x = 0.30, y = 0.02, level = 1, yaw = 0.3, colour = 2 } }
   p.robot.lift_system.set_position(0.09)
   p.step(5)
   local found = p.tracker:blocks()
   same('blocks', #found, 2)
   table.sort(found, function(a, b) return a.z < b.z end)
   for i, block in ipairs(found) do
      near('x', block.x, 0.30, 1e-3)
      near('y', block.y, 0.02, 1e-3)
      near('yaw', geometry.wrap_quarter(block.yaw - 0.3), 0, 1e-3)
      same('level', block.level, i - 1)
      same('colour', block.colour, 4 - i)
   end
end)

case('blocks are where they stand though pictures come a step late, while the robot turns and the lift goes', function()
   local p = perceiver { { x = 0.30, y = 0.05, colour = 2 } }
   local system, camera = p.robot.system, p.robot.camera_system
   local before = { tags = {}, time = 0 }
   local function late_step()
      p.fake:step()
      local taken = { tags = camera.tags, time = system.time }
      camera.tags, camera.timestamp, before = before.tags, before.time, taken
      p.odometry:sense()
      p.tracker:sense()
   end
   p.robot.lift_system.set_position(0.08)
   for _ = 1, 4 do late_step() end
   local most = 0
   for i = 1, 4 do
      -- rims of opposite signs on mirrored motors: to the left
      p.robot.differential_drive.set_target_velocity(-0.03, -0.03)
      p.robot.lift_system.set_position(0.08 + 0.006 * i)
      late_step()
      local known = p.tracker:blocks()[1]
      most = math.max(most, geometry.apart(known, { x = 0.30, y = 0.05 }))
   end
   same('turned', p.odometry.pose.yaw > 0.3, true)
   near('at most off', most, 0, 1e-3)
   -- a clock that is not the robot's tells nothing
   camera.timestamp = -1e6
   same('as it is now', p.camera:taken_from(p.odometry.pose).yaw, p.odometry.pose.yaw)
end)

case('a tag that looks tilted the other way is that of a block that stands there as far as is known', function()
   local p = perceiver { { x = 0.30, y = 0.01, colour = 1 } }
   p.robot.lift_system.set_position(0.077)
   p.step(4)
   local before = p.tracker:blocks()[1]
   local x, y, level, count = before.x, before.y, before.level, #p.tracker.tracks
   for _ = 1, 3 do
      p.fake:step()
      -- turned by half about the line of sight, and half about itself: its picture is nearly the same
      for _, tag in ipairs(p.robot.camera_system.tags) do
         local ray = vector3(tag.position)
         local half = quaternion(math.pi, vector3(ray.x / ray:length(), ray.y / ray:length(), ray.z / ray:length()))
         tag.orientation = half * tag.orientation * quaternion(math.pi, vector3(0, 0, 1))
      end
      p.tracker:add_process_noise(p.odometry:sense())
      p.tracker:sense()
   end
   local after = p.tracker:blocks()[1]
   near('x', after.x, x, 2e-3)
   near('y', after.y, y, 2e-3)
   same('level', after.level, level)
   same('colour', after.colour, 1)
   same('no other', #p.tracker.tracks, count)
end)

case('three sightings make a block, three misses end it, one out of sight is remembered', function()
   local p = perceiver { { x = 0.25, y = 0, colour = 1 } }
   p.robot.lift_system.set_position(0.077)
   p.step(2)
   same('seen twice', #p.tracker:blocks(), 0)
   p.step(2)
   same('seen often', #p.tracker:blocks(), 1)
   local block = p.tracker:blocks()[1]
   p.fake.blocks = {}
   p.step(2)
   same('missed twice', #p.tracker.tracks, 1)
   same('again', p.tracker:again(block), block)
   p.step()
   same('missed thrice', #p.tracker.tracks, 0)
   p.fake.blocks = { { x = 0.25, y = 0 } }
   p.step(4)
   p.fake.pose.yaw, p.odometry.pose.yaw = math.pi, math.pi
   p.step(60 * 5 - 10)
   same('behind', #p.tracker.tracks, 1)
   p.step(20)
   same('after a minute', #p.tracker.tracks, 0)
end)

case('what is remembered gets less certain on the way', function()
   local p = perceiver { { x = 0.25, y = 0 } }
   p.robot.lift_system.set_position(0.077)
   p.step(4)
   local block = p.tracker.tracks[1]
   local before = block.variance
   p.tracker:add_process_noise(0.1, 0)
   near('variance', block.variance - before, 1e-6, 1e-12)
end)

case('a block that is pushed keeps its track, the nearest of two recalls', function()
   local p = perceiver { { x = 0.25, y = 0.02 }, { x = 0.26, y = -0.04 } }
   p.robot.lift_system.set_position(0.077)
   p.step(4)
   local id = p.tracker:recall(function() return true end).id
   p.fake.blocks[1].x = 0.27
   p.step()
   near('in one picture alone a tag may be far off', p.tracker:again { id = id }.x, 0.25, 1e-3)
   p.step()
   local moved = p.tracker:again { id = id }
   near('x', moved.x, 0.27, 1e-3)
   same('the other', p.tracker:recall(function(block) return block.id ~= id end).y < -0.03, true)
   p.tracker:forget(moved)
   same('forgotten', #p.tracker.tracks, 1)
end)

case('a block has the colour that it shows now and then, until it is dark for long', function()
   local p = perceiver { { x = 0.25, y = 0, colour = 2 } }
   p.robot.lift_system.set_position(0.077)
   p.step(4)
   for _ = 1, 5 do
      p.fake.blocks[1].colour = 0
      p.step(5)
      same('dark', p.tracker:recall(function() return true end).colour, 2)
      p.fake.blocks[1].colour = 2
      p.step()
   end
   p.fake.blocks[1].colour = 0
   p.step(8)
   same('dark for good', p.tracker:recall(function() return true end).colour, 0)
end)

case('a brick that would be seen and is not, is not there', function()
   local p = perceiver { { x = 0.25, y = 0, colour = 1 } }
   p.robot.lift_system.set_position(0.09)
   p.step(4)
   same('on top', p.sight:would_see(0.25, 0, 1, 0), true)
   same('behind', p.sight:would_see(0.25 + 0.055, 0, 0, 0), true)
   same('far to the side', p.sight:would_see(0.25, 0.4, 0, 0), false)
   same('behind the robot', p.sight:would_see(-0.25, 0, 0, 0), false)
   p.fake.blocks = { { x = 0.20, y = 0 }, { x = 0.20, y = 0, level = 1 } }
   p.tracker:forget_all()
   p.robot.lift_system.set_position(0.06)
   p.step(4)
   same('hidden', p.sight:would_see(0.30, 0, 0, 0), false)
end)

case('a brick hides what is behind and below it after it has left the picture', function()
   local p = perceiver {}
   p.robot.lift_system.set_position(0.09)
   p.step(4)
   same('nothing before it', p.sight:would_see(0.305, 0, 0, 0), true)
   p.sight.remembered = function()
      return { { x = 0.25, y = 0, z = 0.0275, yaw = 0 }, { x = 0.305, y = 0, z = 0.0825, yaw = 0 } }
   end
   same('neither its front nor its top', p.sight:would_see(0.305, 0, 0, 0), false)
   same('the one above itself', p.sight:would_see(0.305, 0, 1, 0), true)
end)

case('a lattice fits blocks that stand next to each other', function()
   local blocks = {}
   for i, cell in ipairs { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 8, 0 } } do
      local x, y = geometry.out_of({ x = 0.3, y = 0.1, yaw = 0.4 }, 0.055 * cell[1], 0.055 * cell[2])
      blocks[i] = { id = i, x = x, y = y, z = 0.0275, yaw = 0.4 + i * math.pi / 2, turned = 1e-4, colour = i }
   end
   local all = structures.of(blocks)
   same('structures', #all, 2)
   same('blocks', #all[1].blocks, 3)
   near('yaw', geometry.wrap_quarter(all[1].frame.yaw - 0.4), 0)
   same('of one colour', #structures.of(blocks, function(block) return block.colour == 4 end), 1)
   near('square', geometry.wrap_quarter(structures.square_of(blocks[2], blocks) - 0.4), 0)
end)

case('readings become metres as the calibration says', function()
   local fake = FakeRobot.new()
   local robot, description = fake.robot, fake.robot.description
   local ranges = RangeSensors.new(robot, description)
   robot.rangefinders.front.proximity = 0.07
   near('metres', ranges:range('front'), 0.07)
   robot.rangefinders.front.proximity = 0.2
   same('nothing', ranges:range('front'), nil)
   description.rangefinders.front = { calibration = 'power', coefficients = { 5000, 90 } }
   robot.rangefinders.front.proximity = 5000 * math.exp(-90 * 0.03)
   near('power', ranges:range('front'), 0.03)
   description.rangefinders.front = { calibration = 'quadratic', coefficients = { 1250, -5500, 7200 } }
   local v = math.exp(-0.04)
   robot.rangefinders.front.proximity = 1250 - 5500 * v + 7200 * v ^ 2
   near('quadratic', ranges:range('front'), 0.04)
   robot.rangefinders.front.proximity = 0
   same('no counts', ranges:range('front'), nil)
   near('the nearest', ranges:nearest { '1', 'front' }, 1)
   near('reach', ranges:reach(), 0.2)
end)

case('a return is unexplained where no block is known, and gone when it is seen through', function()
   local p = perceiver()
   p.step()
   same('nothing', #p.returns:near(0.10, 0, 0.1, 0), 0)
   p.robot.rangefinders['1'].proximity = 0.03
   p.step()
   local points = p.returns:near(0.075, 0, 0.01, 0)
   same('one', #points, 1)
   near('x', points[1].x, 0.075, 1e-9)
   same('in a turn to the left', p.returns:sweeps(0.5), false)
   p.robot.rangefinders['3'].proximity = 0.03
   p.step()
   same('with something to the left', p.returns:sweeps(1.3), true)
   same('not as far', p.returns:sweeps(0.7), false)
   same('to the right', p.returns:sweeps(-0.5), false)
   same('its back, farther', p.returns:sweeps(-1.3), true)
   p.tracker.tracks = { { x = 0.03, y = 0.09, z = 0.0275 } }
   same('a block is in the way', p.returns:sweeps(1.3), true)
   same('but not of what is carried over it', p.returns:sweeps(1.3, 0.07), false)
   same('while the back passes over nothing', p.returns:sweeps(-1.3, 0.07), true)
   table.insert(p.tracker.tracks, { x = 0.03, y = 0.09, z = 0.0825 })
   same('nor over one on it', p.returns:sweeps(1.3, 0.07), true)
   p.tracker.tracks = {}
   same('nor over what is no block', p.returns:sweeps(1.3, 0.07), true)
   p.robot.rangefinders['1'].proximity = 0.2
   p.step()
   same('gone', #p.returns:near(0.075, 0, 0.01, 0), 0)
   p.tracker.tracks = { { x = 0.06, y = 0.08, z = 0.0275 } }
   same('a block', #p.returns:near(0.05, 0.07, 0.05, 0), 0)
end)
