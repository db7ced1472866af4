-- SPDX-License-Identifier: MIT
-- How a robot moves, with a fake one that does as it is told.

local FakeRobot = require 'fake_robot'
local Machine = require 'machine'
local Navigation = require 'motion.navigation'
local Sweep = require 'motion.sweep'
local geometry = require 'common.geometry'
local machine_with = require 'machine_with'
local unit = require 'unit'
local case, near, same = unit.case, unit.near, unit.same

case('a turn ends at its heading, a drive on its line', function()
   local machine, fake, run = machine_with()
   same('turned', run(function() return machine.path:turn_to(2) end), true)
   near('yaw', fake.pose.yaw, 2, 1e-4)
   local line = { x = 0.5, y = 0.1, yaw = 0.2 }
   fake.pose.yaw, machine.odometry.pose.yaw = 0, 0
   same('arrived', run(function() return machine.path:follow(line, 0, 0.1) end), true)
   local along, aside, angle = machine.odometry:on_line(line)
   near('along', along, 0, 2e-4)
   near('aside', aside, 0, 2e-3)
   near('angle', angle, 0, 0.02)
   near('as it is', fake.pose.x, machine.odometry.pose.x, 1e-6)
   run(function() return machine.path:go_by(-0.2) end)
   near('back', machine.odometry:on_line(line), -0.2, 2e-3)
end)

case('a robot drives and turns at its pace', function()
   local took = {}
   for i, pace in ipairs { 1, 0.25 } do
      local machine, fake, run = machine_with(nil, { pace = pace })
      run(function() return machine.path:go_by(0.3) end)
      run(function() return machine.path:turn_to(3) end)
      near('there', fake.pose.yaw, 3, 1e-3)
      took[i] = machine.process:time()
   end
   same('much longer', took[2] > 2 * took[1], true)
   for _, pace in ipairs { 0, -1, 0.05, 1.5, 0 / 0, 'slow' } do
      local good, problem = pcall(machine_with, nil, { pace = pace })
      same('refused', good, false)
      same('says so', tostring(problem):find('params.pace has to be from 0.1 to 1') ~= nil, true)
   end
end)

case('a turn on the spot leaves the pivot where it is, and a place is reached by it', function()
   local machine, fake, run = machine_with()
   local pivot = fake.robot.description.drive.pivot
   run(function() return machine.path:turn_to(math.pi / 2) end)
   near('x, turned', fake.pose.x, pivot, 1e-5)
   near('y, turned', fake.pose.y, -pivot, 1e-5)
   run(function() return machine.path:turn_to(-math.pi / 2) end)
   near('x, turned back', fake.pose.x, pivot, 1e-5)
   near('y, turned back', fake.pose.y, pivot, 1e-5)
   run(function() return machine.path:go_to(0.3, 0.4) end)
   run(function() return machine.path:turn_to(2) end)
   local x, y = geometry.out_of(fake.pose, pivot, 0)
   near('x, there', x, 0.3, 1e-3)
   near('y, there', y, 0.4, 1e-3)
   near('odometry of x', machine.odometry.pose.x, fake.pose.x, 1e-9)
   near('odometry of y', machine.odometry.pose.y, fake.pose.y, 1e-9)
end)

case('from where it is told to turn it stands on the line, once it has turned', function()
   local machine, fake, run = machine_with()
   local line = { x = 0.5, y = 0.3, yaw = 2.5 }
   run(function() return machine.path:go_to(machine.odometry:pivot_on(line, -0.2)) end)
   local along, aside = machine.odometry:turned_onto(line)
   near('along, to be', along, -0.2, 1e-3)
   near('aside, to be', aside, 0, 1e-3)
   run(function() return machine.path:turn_to(line.yaw) end)
   along, aside = geometry.into(line, fake.pose.x, fake.pose.y)
   near('along', along, -0.2, 1e-3)
   near('aside', aside, 0, 1e-3)
end)

case('a turn to look about brakes as hard as it can, and ends about its heading', function()
   local machine, fake, run = machine_with()
   local function seconds(turn)
      local start = machine.odometry.time
      run(turn)
      return machine.odometry.time - start
   end
   local turn = seconds(function() machine.path:turn_to(1.6, 0.05) end)
   local swing = seconds(function() machine.path:swing_to(0, 0.05) end)
   near('about there', fake.pose.yaw, 0, 0.3)
   same('sooner', swing < turn, true)
   -- as it ends where `each` says so
   seconds(function() machine.path:swing_to(1.6, 0.05, function() return fake.pose.yaw > 0.8 end) end)
   same('ended', fake.pose.yaw > 0.8 and fake.pose.yaw < 1.4, true)
end)

case('a turn ends soon although motors lag and go past its heading', function()
   local machine, fake, run = machine_with()
   fake.robot.description.drive.acceleration = 0.04
   local set, speeds = fake.robot.differential_drive.set_target_velocity, { 0, 0 }
   fake.robot.differential_drive.set_target_velocity = function(left, right)
      for i, wanted in ipairs { left, right } do speeds[i] = speeds[i] + 0.3 * (wanted - speeds[i]) end
      set(speeds[1], speeds[2])
   end
   local start = machine.odometry.time
   run(function() machine.path:turn_to(1.6, 0.05) end)
   same('soon', machine.odometry.time - start < 8, true)
   near('there', machine.odometry.pose.yaw, 1.6, 0.02)
end)

-- Against a robot turned in small steps: what lies under it then and not at first.
case('what a turn sweeps is what comes by', function()
   local description = FakeRobot.new().robot.description
   local sweep, pivot = Sweep.new(description), description.drive.pivot
   local effector, body = description.effector, description.body
   local function is_under(x, y)
      return x >= pivot and x <= effector.front and math.abs(y) <= effector.half_width or
             x >= -body.back and x <= body.front and math.abs(y) <= body.half_width
   end
   local function comes_by(x, y, angle)
      for step = 0, 300 do
         local dx, dy = geometry.into({ x = pivot, y = 0, yaw = angle * step / 300 }, x, y)
         if is_under(pivot + dx, dy) then return true end
      end
      return false
   end
   local touched, free = 0, 0
   for i = 1, 600 do
      local x, y = 0.28 * ((i * 0.6180) % 1 - 0.4), 0.28 * ((i * 0.7548) % 1 - 0.5)
      local angle = 6 * ((i * 0.5698) % 1 - 0.5)
      if is_under(x, y) then
         same('under it', sweep:touches(x, y, angle, 0.01), false)
      elseif comes_by(x, y, angle) then
         touched = touched + 1
         same('touched', sweep:touches(x, y, angle, 1e-4), true)
      elseif not comes_by(x, y, angle + (angle < 0 and -0.03 or 0.03)) then
         free = free + 1
         same('free', sweep:touches(x, y, angle, 0), false)
      end
   end
   assert(touched > 60 and free > 200, touched .. ' ' .. free)
   near('farthest', sweep.reach, math.sqrt(0.105 ^ 2 + 0.044 ^ 2), 1e-9)
   same('beyond it', sweep:touches(pivot, sweep.reach + 0.001, 3, 0), false)
   near('ahead', sweep:room_along({ x = pivot, y = 0 }, { x = 0, y = 1 }), sweep.reach, 1e-9)
   near('aside', sweep:room_along({ x = 0, y = 1 }, { x = 1, y = 0 }), 0)
end)

case('a line that is lost ends the drive', function()
   local machine, fake, run = machine_with()
   local good, why = run(function()
      return machine.path:follow(function()
         return fake.pose.x < 0.1 and { x = 0.5, y = 0, yaw = 0 } or nil
      end, 0, 0.1)
   end)
   same('good', good, false)
   same('why', why, 'target lost')
   near('it stands', machine.odometry.left, 0, 1e-4)
end)

case('it travels as fast as what its rangefinders see allows', function()
   same('far', machine_with().path.cruise, 0.16)
   local fake = FakeRobot.new()
   fake.robot.description.rangefinders['5'].range = 0.05
   local machine = Machine.new(fake.robot)
   near('near', machine.path.cruise, 0.1)
   same('short-sighted', machine.clearance:backed(), false)
   fake.robot.rangefinders['7'].proximity = 0.01
   same('even then', machine.clearance:backed(), false)
   fake.robot.description.lift = nil
   same('without a lift', pcall(Machine.new, fake.robot), false)
end)

case('what the rangefinders see is in the way', function()
   local machine, fake, run = machine_with()
   local clearance, finders = machine.clearance, fake.robot.rangefinders
   same('nothing', clearance:blocked() or clearance:backed() or clearance:meets(), false)
   finders['12'].proximity = 0.04
   same('blocked', clearance:blocked(), true)
   same('not as near', clearance:blocked(0.03), false)
   same('between', clearance:between(0.3), true)
   machine.magnets.carrying = true
   same('hidden by what is carried', clearance:blocked(), false)
   machine.magnets.carrying = false
   finders['12'].proximity, finders.front.proximity = 0.2, 0.02
   same('an arm between', clearance:between(0.3), true)
   same('the column itself', clearance:between(0.24), false)
   finders.front.proximity = 0.1
   same('an arm', clearance:meets(0.5), true)
   same('beyond the end', clearance:meets(0.05), false)
   finders.front.proximity, finders['7'].proximity = 0.2, 0.06
   run(function() return machine.path:back_off(0.1) end)
   near('no room behind', fake.pose.x, 0, 1e-9)
end)

-- As if a rangefinder had seen something at a place of the robot's frame, where none sees it now.
local function saw(machine, x, y)
   local place_x, place_y = geometry.out_of(machine.odometry.pose, x, y)
   machine.returns.points = { seen = { x = place_x, y = place_y, time = machine.odometry.time } }
end

case('an arm may reach out from where another robot was seen, though no rangefinder sees it', function()
   local machine = machine_with()
   local clearance = machine.clearance
   saw(machine, 0.25, 0.09)
   same('a wall, perhaps', clearance:meets(1), false)
   clearance.explained = function() return false end
   same('ahead', clearance:meets(1), true)
   same('beyond the end', clearance:meets(0), false)
   clearance.explained = function(x, y) return x > 0.2 and y > 0 end
   same('no robot', clearance:meets(1), false)
   clearance.explained = function() return false end
   same('none that counts', clearance:meets_arm_ahead(0.08, function() return false end), false)
   saw(machine, 0.25, 0.14)
   same('too far aside', clearance:meets(1), false)
   saw(machine, 0.02, 0.08)
   same('beside', clearance:meets(1) or clearance:backed(), false)
   saw(machine, -0.03, 0.08)
   same('beside, on the way on', clearance:meets(1), false)
   same('beside, on the way back', clearance:backed(), true)
   saw(machine, -0.16, -0.08)
   same('behind', clearance:backed(), true)
   machine.odometry.time = machine.odometry.time + 11
   same('long ago', clearance:backed(), false)
   saw(machine, -0.16, -0.08)
   clearance.alone = true
   same('of one that is alone', clearance:backed(), false)
end)

case('a block in its own hand, held low, is no other robot ahead', function()
   local machine, fake, run = machine_with()
   machine.clearance.explained = function() return false end
   fake.robot.rangefinders['2'].proximity = 0.03
   machine.magnets.carrying, fake.robot.lift_system.position = true, 0.03
   run(function() machine.process:wait(0.4) end)
   same('held low', machine.clearance:meets_arm_ahead(0.08), false)
   fake.robot.lift_system.position = 0.08
   run(function() machine.process:wait(0.4) end)
   same('held above', machine.clearance:meets_arm_ahead(0.08), true)
end)

case('a block that another robot was seen to hold is in the way', function()
   local machine = machine_with()
   local clearance, tracker = machine.clearance, machine.tracker
   local held = { x = 0.17, y = 0.06, z = 0.11, colour = 4, seen = 3, time = 0 }
   tracker.tracks = { held }
   same('ahead', clearance:meets(1), true)
   same('in a turn', clearance:has_company(), true)
   held.colour = 1
   same('a brick', clearance:meets(1) or clearance:has_company(), false)
   clearance.transport = 1
   same('of the colour that blocks have on their way', clearance:meets(1), true)
   held.z = 0.0275
   same('lying', clearance:meets(1), false)
   held.z, held.x, held.y = 0.11, -0.05, 0.12
   same('aside', clearance:meets(1), false)
   same('where a turn sweeps', clearance:has_company(), true)
   held.seen = 1
   same('hardly seen', clearance:has_company(), false)
end)

case('before a turn that sweeps a brick it goes away from that', function()
   local machine, fake, run = machine_with()
   local clearance, brick = machine.clearance, { x = -0.02, y = -0.085, z = 0.0275, yaw = 0 }
   clearance.bricks = function() return { brick } end
   clearance.room = function(x, y) return geometry.apart(brick, { x = x, y = y }) end
   same('to the left', clearance:turns_into_bricks(1.5), true)
   same('a little', clearance:turns_into_bricks(0.05), false)
   run(function() return machine.path:turn_by(1.5) end)
   same('ahead', fake.pose.x > 0.005, true)
   near('and turned', fake.pose.yaw, 1.5, 0.01)
   same('from there', clearance:turns_into_bricks(-1.5), false)
   brick.x, brick.y = geometry.out_of(machine.odometry.pose, 0.11, -0.075)
   fake.robot.lift_system.position = 0.02
   same('with the effector', clearance:turns_into_bricks(-1.5), true)
   fake.robot.lift_system.position = 0.07
   same('over it', clearance:turns_into_bricks(-1.5), false)
end)

case('the lift does not come down on who stands below it', function()
   local machine, fake, run = machine_with()
   run(function() machine.lift:to(0.12) end)
   fake.robot.rangefinders['1'].proximity = 0.06
   same('below', run(function() return machine.path:clear_below() end), false)
   near('backed out', fake.pose.x, -0.1, 2e-3)
   fake.robot.rangefinders['1'].proximity = 0.2
   same('gone', run(function() return machine.path:clear_below() end), true)
   near('stays', fake.pose.x, -0.1, 2e-3)
end)

case('a robot backs out of the reach of who stays beside it before it turns', function()
   local machine, fake, run = machine_with()
   fake.robot.rangefinders['4'].proximity = 0.05
   run(function() machine.path:clear_round() end)
   near('a wall, perhaps', fake.pose.x, 0, 1e-9)
   machine.clearance.explained = function() return false end
   run(function() machine.path:clear_round() end)
   near('back', fake.pose.x, -0.1, 2e-3)
end)

case('it waits for another robot where a turn may touch its arm, and not for what is known', function()
   local machine, fake, run = machine_with()
   local clearance = machine.clearance
   -- right behind it
   fake.robot.rangefinders['8'].proximity = 0.08
   clearance.explained = function() return false end
   local function waited(angle)
      local start = machine.odometry.time
      run(function() machine.path:await_company(angle) end)
      return machine.odometry.time - start
   end
   run(function() machine.process:wait(0.4) end)
   assert(waited(2) > 0.5)
   near('a turn that sweeps little', waited(0.2), 0, 0.3)
   clearance.explained = function() return true end
   near('a brick', waited(2), 0, 0.3)
   clearance.explained = function() return false end
   clearance.alone = true
   near('nobody else is there', waited(2), 0, 0.3)
   clearance.alone = false
   fake.robot.rangefinders['8'].proximity = 0.2
   run(function() machine.process:wait(8) end)
   near('gone', waited(2), 0, 0.3)
end)

case('a look round does not push a block that is known', function()
   local machine, _, run = machine_with()
   local known = { id = 1, x = 0.15, y = 0, z = 0.0275, level = 0, yaw = 0, colour = 1, seen = 3, missed = 0, first = 0, time = 0,
                   top_time = -1, variance = 1e-6, turned = 1e-4 }
   local off
   run(function()
      machine.tracker.tracks = { known }
      machine.search:look_round(function()
         off = off or geometry.apart(machine.odometry:pivot(), known)
         return true
      end)
   end)
   assert(off >= machine.sweep.from_block - 2e-3, off)
end)

case('it backs into no remembered brick', function()
   local machine, fake, run = machine_with()
   local back = fake.robot.description.body.back
   -- a wall aslant, 0.1 m behind the middle of the body's back
   machine.clearance.room = function(x, y) return math.max(0, x + 0.1 * y + back + 0.1) end
   run(function() return machine.path:back_off(0.2) end)
   assert(fake.pose.x < -0.05 and fake.pose.x > -0.1, fake.pose.x)
   local before = fake.pose.x
   run(function() return machine.path:back_off(0.2) end)
   near('nor any farther', fake.pose.x, before, 1e-9)
end)

case('a robot with others beside it waits before it turns, but not for ever', function()
   local machine, fake, run = machine_with()
   fake.robot.rangefinders['4'].proximity = 0.05
   local start = machine.odometry.time
   run(function() return machine.clearance:await_room() end)
   local waited = machine.odometry.time - start
   assert(waited > 0 and waited <= 8.4)
end)

case('a look round finds what is behind, and ends there', function()
   local machine, fake, run = machine_with { { x = -0.30, y = 0.02 }, { x = 0, y = 0.4, colour = 2 } }
   local found = run(function()
      return machine.search:find(function(block) return block.colour == 0 end)
   end)
   near('x', found.x, -0.30, 2e-3)
   near('y', found.y, 0.02, 2e-3)
   assert(fake.robot.lift_system.position > 0.05)
   assert(machine.odometry.time < 60)
end)

case('a search in vain goes on along a spiral', function()
   local machine, _, run = machine_with()
   local places = {}
   same('found', run(function()
      return machine.search:find(function() return true end, 3, function(x, y)
         table.insert(places, { x, y })
      end)
   end), nil)
   same('legs', #places, 3)
   local pivot = { x = 0.030, y = 0 }
   local function from_pivot(place) return { x = place[1] - pivot.x, y = place[2] - pivot.y } end
   local first, second = from_pivot(places[1]), from_pivot(places[2])
   near('first leg', geometry.apart(first, { x = 0, y = 0 }), 0.33, 1e-6)
   near('a quarter turn', second.x * first.x + second.y * first.y, 0, 1e-2)
end)

case('the way to the far side leads round the structure', function()
   local machine, fake, run = machine_with()
   local map = { known = { x = 0.6, y = 0, reach = 0.08, yaw = 0 } }
   local navigation = Navigation.new(machine, map)
   local nearest = math.huge
   same('there', run(function() return navigation:to(1.2, 0.05) end, function()
      nearest = math.min(nearest, geometry.apart(fake.pose, map.known))
   end), true)
   near('x', machine.odometry:pivot().x, 1.2, 0.02)
   assert(nearest > 0.08 + 0.165 - 0.01, nearest)
end)

case('before a place a robot stops and faces it, nearer than that it stays where it is', function()
   local machine, fake, run = machine_with()
   local navigation = Navigation.new(machine, {})
   same('there', run(function() return navigation:to_before(0.6, 0.5, 0.26) end), true)
   local pivot = machine.odometry:pivot()
   near('before it', geometry.apart(pivot, { x = 0.6, y = 0.5 }), 0.26, 0.02)
   near('facing it', fake.pose.yaw, math.atan(0.5 - pivot.y, 0.6 - pivot.x), 0.02)
   same('behind it', run(function() return navigation:to_before(pivot.x, pivot.y + 0.2, 0.26) end), true)
   near('x', machine.odometry:pivot().x, pivot.x, 1e-3)
   near('y', machine.odometry:pivot().y, pivot.y, 1e-3)
   near('turned to it', fake.pose.yaw, math.pi / 2, 0.02)
end)

case('a way past the cache leaves it aside', function()
   local machine, fake, run = machine_with()
   local cache = { x = 0.4, y = 0.02 }
   local navigation = Navigation.new(machine, { cache = cache })
   local nearest = math.huge
   run(function() return navigation:to(0.8, 0) end, function()
      nearest = math.min(nearest, geometry.apart(fake.pose, cache))
   end)
   near('x', machine.odometry:pivot().x, 0.8, 0.02)
   assert(nearest > 0.15, nearest)
end)

case('a remembered place is looked at from a distance that shows it', function()
   local machine, fake, run = machine_with { { x = 0.8, y = 0.1 } }
   local navigation = Navigation.new(machine, {})
   local function seen() return #machine.tracker:blocks() > 0 end
   same('seen', run(function() return navigation:look_again({ x = 0.8, y = 0.1 }, seen, 2) end), true)
   near('away', geometry.apart(fake.pose, { x = 0.8, y = 0.1 }), 0.36, 0.02)
end)

case('what cannot be come near to be looked at is given up at once by who asks for that', function()
   local machine, fake, run = machine_with()
   local navigation = Navigation.new(machine, {})
   local turned, found, blocked = 0, nil, nil
   fake.robot.rangefinders['1'].proximity = 0.05
   run(function() found, blocked = navigation:look_again({ x = 0.8, y = 0 }, function() return true end, 1, 1) end, function()
      turned = math.max(turned, math.abs(fake.pose.yaw))
   end)
   same('not looked at', found, nil)
   same('since something is in the way', blocked, true)
   assert(turned < 0.1)  -- nor is it given way to
end)

case('who is met is waited for out of its reach', function()
   local machine, fake, run = machine_with()
   local navigation = Navigation.new(machine, {})
   local clearance = machine.clearance
   clearance.explained = function() return false end
   fake.robot.rangefinders['1'].proximity = 0.05
   local waits
   clearance.await_way = function()
      waits = waits or fake.pose.x
      return false
   end
   run(function() return navigation:straight_to(0.5, 0, 1) end)
   near('back from it', waits, -0.08, 2e-3)
end)

case('something in the way is waited for, and then given way to', function()
   local machine, fake, run = machine_with()
   local navigation = Navigation.new(machine, {})
   local far = 0
   fake.robot.rangefinders['1'].proximity = 0.05
   same('there', run(function() return navigation:straight_to(0.5, 0) end, function()
      far = math.max(far, fake.pose.x)
   end), false)
   assert(far < 0.3)
end)
