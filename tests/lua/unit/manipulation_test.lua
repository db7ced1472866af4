-- SPDX-License-Identifier: MIT
-- How a robot handles blocks, with a fake one whose magnets work.

local Approach = require 'manipulation.approach'
local geometry = require 'common.geometry'
local machine_with = require 'machine_with'
local unit = require 'unit'
local case, near, same = unit.case, unit.near, unit.same
local SIDE = geometry.SIDE

local function dark(block) return block.colour == 0 end
local function lit(block) return block.colour == 3 end

case('each outcome of a state leads to a state or an end, and each is come to', function()
   local reached = { travel = true }
   for state, outcomes in pairs(Approach.TRANSITIONS) do
      assert(Approach.states[state], state)
      for outcome, to in pairs(outcomes) do
         assert(Approach.TRANSITIONS[to] or Approach.ENDS[to] ~= nil, state .. ' ' .. outcome)
         reached[to] = true
      end
   end
   for state in pairs(Approach.states) do assert(reached[state] and Approach.TRANSITIONS[state], state) end
   for name in pairs(Approach.ENDS) do assert(reached[name], name) end
end)

-- Goes through an approach of which each state says what it is told; the states that it came to.
local function scripted(outcomes)
   local machine = machine_with()
   local came, real = {}, {}
   for name, state in pairs(Approach.states) do
      real[name] = state
      Approach.states[name] = function(_, run)
         table.insert(came, name)
         run.seen = 'seen'
         return table.remove(outcomes, 1)
      end
   end
   local good, result = machine.approach:to { block = { x = 0.3, y = 0 }, lowest = 0 }
   for name, state in pairs(real) do Approach.states[name] = state end
   return table.concat(came, ' '), good, result
end

case('the transitions are followed', function()
   local function check(outcomes, states, good, result)
      local came, is_good, is = scripted(outcomes)
      same('states', came, states)
      same('good', is_good, good)
      same('result', is, result)
   end
   check({ 'arrived', 'seen', 'seen', 'aligned', 'there' },
         'travel acquire align verify dock', true, 'seen')
   check({ 'arrived', 'seen', 'unseen', 'again', 'obstructed', 'done' },
         'travel acquire align retreat travel give way', false, 'busy')
   check({ 'arrived', 'seen', 'seen', 'askew', 'exhausted' },
         'travel acquire align verify retreat', false, 'no approach succeeded')
   check({ 'arrived', 'seen', 'seen', 'aligned', 'obstructed', 'done' },
         'travel acquire align verify dock back out', false, 'busy')
end)

case('an approach ends over the block, squarely', function()
   local machine, fake, run = machine_with { { x = 0.45, y = 0.1, yaw = 0.3 } }
   local block = run(function() return machine.search:find(dark) end)
   same('docked', run(function() return machine.approach:to { block = block, lowest = 0.015 } end), true)
   local x, y = geometry.into(fake.pose, 0.45, 0.1)
   near('ahead', x, 0.094, 1e-3)
   near('aside', y, 0, 2e-3)
   near('squarely', geometry.wrap_quarter(fake.pose.yaw - 0.3), 0, 0.03)
end)

case('an approach begins where there is room to turn', function()
   local machine = machine_with()
   local approach, needed = machine.approach, machine.sweep.reach + 0.015
   local block = { x = 0.5, y = 0.02, yaw = 0 }
   local run = { block = { x = 0.5, y = 0.02, z = 0.0275 }, target = { apart = true }, attempt = 1 }
   local ahead = { x = 0.5, y = 0.02, yaw = 0 }
   near('with nothing about', approach:stand_off_on(ahead, run), 0.24, 1e-9)
   near('straight on', approach:heading_to(block, run), 0)
   -- a wall on this side of the block, out of the way of the nearest place to turn alone
   local pivot = machine.odometry.ahead
   local wall = 0.5 - 0.22 + pivot - needed
   machine.clearance.room = function(x) return x - wall end
   near('nearer', approach:stand_off_on(ahead, run), 0.22, 1e-9)
   near('still straight on', approach:heading_to(block, run), 0)
   machine.clearance.room = function(x) return x - wall - 0.06 end
   near('from the side', math.abs(approach:heading_to(block, run)), math.pi / 2)
   -- a block of the structure is come to from where its site asks for
   run.target.apart = nil
   near('a brick', approach:heading_to(block, run), 0)
   near('from farther off', approach:stand_off_on(ahead, run), 0.30, 1e-9)
   run.target.apart, machine.clearance.room = true, function() return 0.05 end
   near('where there is room nowhere', approach:heading_to(block, run), 0)
end)

case('from a loose block that was missed a robot goes back no farther than it has room to turn', function()
   local machine = machine_with()
   local approach = machine.approach
   same('all the way', approach:way_back_to_turn(0.10), 0.10)
   -- a brick behind
   local behind = machine.odometry.ahead - 0.05 - machine.sweep.room
   machine.clearance.room = function(x) return x - behind end
   near('as far as that leaves', approach:way_back_to_turn(0.10), 0.04, 1e-9)
   machine.clearance.room = function() return 0.05 end
   same('nowhere', approach:way_back_to_turn(0.10), 0)
end)

case('an approach to a brick high up begins where it is in the picture', function()
   local machine = machine_with()
   local approach, camera, highest = machine.approach, machine.camera, machine.lift.highest
   local function begins(level, ahead)
      local run = { block = { x = 1, y = 0, z = SIDE * (level + 0.5) }, target = { ahead = ahead }, attempt = 2 }
      return approach:farthest_beginning(run), camera:farthest_in_sight(highest, run.block)
   end
   near('of a low one there is no need to', begins(0, 0), 0.32, 1e-9)
   local from, seen = begins(2, 0)
   near('high up', from, seen, 1e-9)
   same('nearer', from < 0.30, true)
   from, seen = begins(2, -SIDE)
   near('before it', from, seen - SIDE, 1e-9)
end)

case('a brick aside and high up is turned to as far as the picture is narrow', function()
   local machine = machine_with()
   local camera, lift = machine.camera, machine.lift.highest
   local function aside(level, ahead) return camera:farthest_aside(lift, { z = SIDE * (level + 0.5) }, ahead) end
   same('less from nearer', aside(1, 0.20) < aside(1, 0.25), true)
   same('less of a higher one', aside(2, 0.25) < aside(1, 0.25), true)
   local eye, turn = camera:pose(lift)
   local p = (vector3(0.25, aside(1, 0.25), SIDE * 2) - eye):rotate(turn:inverse())
   same('in the picture', camera:frames(p, 0), true)
end)

case('a block that has been in the picture for a while needs no first look', function()
   local machine, fake, run = machine_with { { x = 0.30, y = 0 } }
   local approach = machine.approach
   local function acquire(seconds)
      return run(function()
         machine.lift:to(0.08)
         machine.process:wait(seconds)
         local block = machine.tracker:recall(function() return true end)
         local attempt = { block = block, lowest = 0.07, attempt = 1, line = { x = 0.3, y = 0, yaw = 0 } }
         local start = machine.odometry.time
         same('seen', approach.states.acquire(approach, attempt), 'seen')
         return machine.odometry.time - start
      end)
   end
   same('looks first', acquire(0.8) > 0.4, true)
   same('knows it', acquire(3) < 0.3, true)
   fake.blocks = {}
   local block = machine.tracker:recall(function() return true end)
   run(function() machine.process:wait(0.2) end)
   same('not in the picture', approach:is_in_view(block), false)
end)

case('where wheels slipped in a turn, sight tells where the block is', function()
   for _, slip in ipairs { 0, 0.02 } do
      local machine, fake, run = machine_with { { x = 0.45, y = 0 } }
      local block = run(function() return machine.search:find(dark) end)
      local function alone()
         fake.pose.x = fake.pose.x + slip
         return true
      end
      local target = { block = block, lowest = 0.07, heading = 0, alone = alone }
      same('docked', run(function() return machine.approach:to(target) end), true)
      near('ahead', geometry.into(fake.pose, 0.45, 0), 0.094, 1e-3)
   end
end)

case('a place beside a block is come to after a look to both sides, though the block is not in the picture then', function()
   for _, left in ipairs { -geometry.SIDE, geometry.SIDE } do
      local machine, fake, run = machine_with { { x = 0.45, y = 0 } }
      local block = run(function() return machine.search:find(dark) end)
      fake.robot.camera_system.resolution.x = 380  -- too narrow for it, straight ahead
      local target = { block = block, lowest = 0.07, heading = 0, left = left, alone = function() return true end }
      same('docked', run(function() return machine.approach:to(target) end), true)
      local ahead, aside = geometry.into(fake.pose, 0.45, left)
      near('ahead', ahead, 0.094, 2e-3)
      near('aside', aside, 0, 3e-3)
   end
end)

case('a block that is gone is forgotten', function()
   local machine, fake, run = machine_with { { x = 0.40, y = 0 } }
   local block = run(function() return machine.search:find(dark) end)
   fake.blocks = {}
   local good, why = run(function() return machine.pickup:pick_up(block) end)
   same('good', good, false)
   same('why', why, 'it is not there')
   same('forgotten', machine.tracker:again(block), nil)
end)

case('where the line is not met it backs off and tries again, four times', function()
   local machine, _, run = machine_with { { x = 0.40, y = 0 } }
   local block = run(function() return machine.search:find(dark) end)
   local tries = 0
   machine.approach.look_aside = function(_, known)
      return setmetatable({ y = known.y + 0.02 }, { __index = known })
   end
   local enter = machine.process.enter
   machine.process.enter = function(self, state)
      if state == 'approach' then tries = tries + 1 end
      enter(self, state)
   end
   local good, why = run(function() return machine.approach:to { block = block, lowest = 0.015 } end)
   same('good', good, false)
   same('why', why, 'no approach succeeded')
   same('tries', tries, 4)
end)

case('a robot in the way is busy, and made way for', function()
   local machine, fake, run = machine_with { { x = 0.40, y = 0 } }
   local block = run(function() return machine.search:find(dark) end)
   local good, why = run(function() return machine.approach:to { block = block, lowest = 0.015 } end,
                         function() fake.robot.rangefinders['1'].proximity = 0.06 end)
   same('good', good, false)
   same('why', why, 'busy')
end)

case('a block is picked up, coloured, and put on another', function()
   local machine, fake, run = machine_with { { x = 0.40, y = 0.05, yaw = 0.2 },
                                             { x = 0.5, y = -0.3, colour = 3 } }
   local block = run(function() return machine.search:find(dark) end)
   same('picked up', run(function() return machine.pickup:pick_up(block) end), true)
   same('carried', machine.magnets:holds() and fake.held == fake.blocks[1], true)
   same('in transport', fake.blocks[1].colour, 4)
   same('current', fake.sent.discharge, 'disable')
   run(function() return machine.path:back_off(0.1) end)
   local base = run(function() return machine.search:find(lit) end)
   same('placed', run(function() return machine.placement:place(base, 'raise', { colour = 2 }) end), true)
   same('level', fake.blocks[1].level, 1)
   same('colour', fake.blocks[1].colour, 2)
   near('x', fake.blocks[1].x, 0.5, 1.5e-3)
   near('y', fake.blocks[1].y, -0.3, 1.5e-3)
   same('let go', machine.magnets.carrying, false)
end)

-- Lets a machine take the dark block that lies about; the lit one, before which it is to be put down.
local function with_block_before(machine, run)
   local block = run(function() return machine.search:find(dark) end)
   run(function() return machine.pickup:pick_up(block) end)
   return run(function() return machine.search:find(lit) end)
end

case('before a column that keeps the effector off its place a block is let go higher over the floor', function()
   local function let_go_over(level, kept_off, where)
      local machine, _, run = machine_with { { x = 0.40, y = 0 }, { x = 0.5, y = 0.35, colour = 3 } }
      local base = with_block_before(machine, run)
      machine.approach.mean_ahead = function(_, way) return kept_off and way - kept_off end
      local asked, height
      local to = machine.lift.to
      machine.lift.to = function(lift, where_to)
         asked = where_to
         return to(lift, where_to)
      end
      machine.gripper.let_go = function()
         height = asked
         return true
      end
      run(function() return machine.placement:place(base, where or 'extend', { colour = 2, level = level }) end)
      return height - SIDE * level
   end
   near('on to its place', let_go_over(0), 0.002, 1e-9)
   near('a millimetre or two before it', let_go_over(0, 0.002), 0.002, 1e-9)
   near('kept off', let_go_over(0, 0.0085), 0.006, 1e-9)
   near('over a brick', let_go_over(1, 0.0085), 0.002, 1e-9)
   near('from above, lower', let_go_over(1, nil, 'raise'), 0.001, 1e-9)
end)

case('a column that ends the last way is crept up to, though the next reading may not tell of it', function()
   local machine, _, run = machine_with { { x = 0.40, y = 0 } }
   local block = run(function() return machine.search:find(dark) end)
   local told, crept, off = false, nil, nil
   machine.approach.creep = function(_, way, held_off) crept, off = way, held_off end
   local target = { block = block, lowest = 0.08 }
   function target.stop()
      local ahead = geometry.into(machine.odometry.pose, block.x, block.y)
      local now = not told and ahead < machine.description.magnets.ahead + 0.022
      told = told or now
      return now
   end
   same('docked', run(function() return machine.approach:to(target) end), true)
   near('the rest of the way', crept, 0.012, 6e-3)
   same('told once', told, true)
   same('so far off a column, of one that meets nobody', off, 0.010)
   told, target.alone = false, function() return true end
   run(function()
      machine.path:back_off(0.15)
      return machine.approach:to(target)
   end)
   same('and of one that may', off, 0.012)
end)

case('what is ahead is read as often as it takes to know it', function()
   local function read(noise, near_end)
      local machine, _, run = machine_with()
      local reading = 0
      machine.approach.ranges = { range = function()
         reading = reading + 1
         return 0.03 + (reading % 2 == 0 and noise or -noise)
      end }
      local mean = run(function() return machine.approach:mean_ahead(near_end and 0.04 or 0.02) end)
      return mean, reading
   end
   local mean, readings = read(0)
   near('the mean', mean, 0.03, 1e-9)
   same('what never differs', readings, 6)
   mean, readings = read(0.002)
   near('the mean', mean, 0.03, 3e-4)
   same('2 mm off', readings, 13)
   same('and where it ends the way', select(2, read(0.001, true)), 13)
   same('for so long at most', select(2, read(0.01, true)), 40)
   local machine, _, run = machine_with()
   machine.approach.ranges = { range = function() end }
   same('nothing', run(function() return machine.approach:mean_ahead(0.02) end), nil)
end)

case('how a carried block hangs is the mean of many readings, and of none before it slipped', function()
   local machine, fake = machine_with()
   local finders, gripper = fake.robot.rangefinders, machine.gripper
   machine.magnets.carrying = true
   local function read(left, right, off)
      for i = 1, 40 do
         local sign = i % 2 == 0 and 1 or -1
         finders.left.proximity, finders.right.proximity = left + sign * off, right - sign * off
         gripper:sense()
      end
   end
   local gap = gripper.gap
   read(gap + 0.002, gap + 0.004, 0.001)
   local ahead, yaw = gripper:seat()
   near('ahead', ahead, 0.003, 1e-4)
   near('yaw', yaw, math.atan(0.002 / 0.040), 5e-3)
   -- of a block that was drawn ahead, or of one reading that was far off
   finders.left.proximity, finders.right.proximity = gap + 0.012, gap + 0.012
   for _ = 1, 2 do gripper:sense() end
   near('far off', gripper:seat(), 0.003, 1e-4)
   gripper:sense()
   near('slipped', gripper:seat(), 0.012, 1e-9)
   -- none is carried: what is read now counts
   machine.magnets.carrying = false
   gripper:sense()
   finders.left.proximity, finders.right.proximity = gap, gap
   near('now', gripper:seat(), 0, 1e-9)
end)

case('a block is told a code word', function()
   local machine, fake, run = machine_with { { x = 0.40, y = 0.05, yaw = 0.2 } }
   local block = run(function() return machine.search:find(dark) end)
   same('picked up', run(function() return machine.pickup:pick_up(block) end), true)
   for _, kind in ipairs { 5, 16, 17, 62, 3, 0 } do
      run(function() machine.gripper:colour(kind) end)
      same('kind', fake.held.colour, kind)
   end
end)

case('on top, beside a neighbour, a block has its colour before it comes near', function()
   local machine, fake, run = machine_with { { x = 0.40, y = 0 }, { x = 0.5, y = 0.35, colour = 3 } }
   local base = with_block_before(machine, run)
   -- the colour over the place, before it is let down
   local function over(where, aside, from_above)
      machine.gripper:colour(4)
      local options = { colour = 2, aside = aside, heading = math.pi / 2, level = from_above and 1, over = from_above }
      same('there', machine.placement:approach_site(base, where, options), true)
      machine.path:back_off(0.15)
      return fake.held.colour
   end
   same('beside one', run(function() return over('raise', 1) end), 2)
   same('beside none, or two', run(function() return over('raise', 0) end), 4)
   same('in front', run(function() return over('extend', 1) end), 4)
   same('from above', run(function() return over('beside', 1, true) end), 2)
   -- where it does not come there, it is in transport
   machine.approach.to = function(_, target)
      target.begin()
      return false, 'busy'
   end
   run(function() return machine.placement:approach_site(base, 'raise', { colour = 2, aside = 1 }) end)
   same('on its way again', fake.held.colour, 4)
end)

case('on the last way magnets hold harder where the block is to stay and no neighbour draws it', function()
   local machine, _, run = machine_with { { x = 0.40, y = 0 }, { x = 0.5, y = 0.35, colour = 3 } }
   local base = with_block_before(machine, run)
   local begin
   machine.approach.to = function(_, target)
      begin = target.begin
      return false, 'busy'
   end
   local function begins(where, options)
      options.heading = math.pi / 2
      run(function() return machine.placement:approach_site(base, where, options) end)
      return begin ~= nil
   end
   same('on top', begins('raise', { colour = 2 }), true)
   local held
   machine.magnets.hold_fast = function(_, on) held = on end
   begin()
   same('held', held, true)
   same('in front, beside a neighbour', begins('extend', { colour = 2, aside = 1 }), false)
   same('in front of one alone', begins('extend', { colour = 2 }), true)
   same('only over it, to tell it its colour', begins('raise', {}), false)
end)

case('a block that hangs askew is brought so far aside as the turn that squares it will take it', function()
   local machine, _, run = machine_with { { x = 0.40, y = 0 }, { x = 0.5, y = 0.35, colour = 3 } }
   local base, left = with_block_before(machine, run), nil
   machine.approach.to = function(_, target)
      left = target.left
      return false, 'busy'
   end
   local ahead = machine.description.magnets.ahead - machine.odometry.ahead
   for _, yaw in ipairs { 0, 0.008, 0.02, -0.02 } do
      machine.gripper.seat = function() return 0, yaw end
      run(function() return machine.placement:approach_site(base, 'extend', { colour = 2 }) end)
      near('neighbours on both sides', left, 0, 1e-9)
      run(function() return machine.placement:approach_site(base, 'extend', { colour = 2, aside = 1 }) end)
      near('one to its right', left, 0.002 + math.max(math.abs(yaw) > 0.012 and ahead * yaw or 0, -0.0005), 1e-9)
      run(function() return machine.placement:approach_site(base, 'extend', { colour = 2, aside = -1 }) end)
      near('one to its left', left, -0.002 + math.min(math.abs(yaw) > 0.012 and ahead * yaw or 0, 0.0005), 1e-9)
      run(function() return machine.placement:approach_site(base, 'extend', { colour = 2, open = true }) end)
      near('none', left, math.abs(yaw) > 0.012 and ahead * yaw or 0, 1e-9)
   end
end)

case('where no brick stands behind a place, what comes up there is another robot', function()
   local machine, fake, run = machine_with { { x = 0.40, y = 0 }, { x = 0.5, y = 0.35, colour = 3 } }
   local base = with_block_before(machine, run)
   local nearest
   local function bring(clear)
      local heading = math.pi / 2
      nearest = math.huge
      fake.robot.rangefinders.front.proximity = 0.2
      return run(function()
         return machine.placement:approach_site(base, 'raise', { colour = 2, heading = heading, clear = clear })
      end, function()
         if machine.process.state ~= 'reach' then return end
         nearest = math.min(nearest, 0.35 - fake.pose.y)
         if nearest < 0.16 then fake.robot.rangefinders.front.proximity = 0.03 end
      end)
   end
   local there, why = bring(true)
   same('not there', there, false)
   same('somebody', why, 'busy')
   assert(nearest > 0.12, nearest)
   same('a column in the next cell but one', bring(false), true)
   near('over its place', nearest, 0.094, 2e-3)
end)

case('from 25 mm before its place the next cell is as much farther', function()
   local machine, fake = machine_with {}
   local function filled(ahead, short)
      fake.robot.rangefinders.front.proximity = ahead
      return machine.approach:next_cell_filled { short = short }
   end
   same('at its place', filled(0.039), true)
   same('a column two cells on', filled(0.045), false)
   same('before it', filled(0.060, -0.025), true)
   same('likewise a column', filled(0.070, -0.025), false)
   same('of a block that hangs back', filled(0.039, 0.002), true)
end)

case('of two that meet at a place the one goes on when the other has left', function()
   local machine, fake, run = machine_with {}
   local asked, leaves_at, met_at, block = nil, math.huge, nil, { x = 0.3, y = 0.06 }
   local front = fake.robot.rangefinders.front
   local function reach(goes_before, line, clear)
      fake.pose.x, machine.odometry.pose.x = 0, 0
      local attempt = { target = {
         clear = clear,
         goes_before = goes_before and function(other) asked = other return goes_before() end,
         contested = function()
            local now = machine.odometry.time
            if machine.odometry.pose.x < 0.1 or now > leaves_at then return nil end
            met_at = met_at or now
            return not clear and block or nil
         end,
      } }
      return run(function() return machine.approach:follow_last(attempt, line, -0.05) end)
   end
   local line = { x = 0.3, y = 0, yaw = 0 }
   same('leaves', reach(function() return false end, line), 'obstructed')
   same('before the other', asked, block)
   met_at, leaves_at = nil, machine.odometry.time + 4
   same('goes on', reach(function() return true end, line), 'there')
   near('to its place', machine.odometry.pose.x, 0.25, 1e-3)
   same('no sooner', machine.odometry.time > leaves_at, true)
   met_at, leaves_at = nil, math.huge
   same('who stays is not waited for', reach(function() return true end, line), 'obstructed')
   same('nobody goes before anybody', reach(nil, line), 'obstructed')
   block, met_at, leaves_at = { x = 0.3, y = 0.03 }, nil, machine.odometry.time + 4
   same('a block that was last seen at the place is there', reach(function() return true end, line), 'obstructed')
   -- an effector ahead that backs out, and one that goes down
   for after, ended in pairs { [0.06] = 'there', [0.2] = 'obstructed' } do
      local from = nil
      fake.feel = function()
         local x = machine.odometry.pose.x
         if x > 0.1 then from = from or machine.odometry.time end
         front.proximity = not from and 0.2 or machine.odometry.time - from < 2 and 0.035 or after
      end
      same('ahead ' .. after, reach(function() return true end, line, true), ended)
   end
end)

case('a block that catches on a neighbour on its way is brought again, farther off that', function()
   local machine, fake, run = machine_with { { x = 0.40, y = 0 }, { x = 0.5, y = 0.35, colour = 3 } }
   local base = with_block_before(machine, run)
   local lefts, catches = {}, 1
   local to = machine.approach.to
   machine.approach.to = function(approach, target)
      table.insert(lefts, target.left)
      return to(approach, target)
   end
   local finders = fake.robot.rangefinders
   local function bring()
      local left = finders.left.proximity
      lefts = {}
      local there, why = run(function()
         return machine.placement:approach_site(base, 'extend', { colour = 2, heading = math.pi / 2, aside = 1 })
      end, function()
         local reaches = machine.process.state == 'reach' and fake.pose.y > 0.13
         -- by which the block is pushed back
         local pushed = reaches and #lefts <= catches and 0.005 or 0
         finders.left.proximity, finders.right.proximity = left - pushed, left - pushed
      end)
      finders.left.proximity, finders.right.proximity = left, left
      return there, why
   end
   same('there', bring(), true)
   same('at the second attempt', #lefts, 2)
   near('farther off', lefts[2] - lefts[1], 0.002, 1e-9)
   catches = math.huge
   local there, why = bring()
   same('not for ever', #lefts, 3)
   same('not there', there, false)
   same('why', why, 'the block has caught')
end)

case('a place over which another robot holds a block is contested, whatever the block shows', function()
   local machine = machine_with()
   local placement = machine.placement
   local held = { x = 0.31, y = 0.01, z = 0.11, colour = 2, time = machine.odometry.time }
   machine.tracker.tracks = { held }
   same('over it', placement:contested_by(0.3, 0, 0), held)
   same('beside it', placement:contested_by(0.255, 0, 0), nil)
   same('below it', placement:contested_by(0.3, 0, 2), nil)
   held.colour = 4
   same('in transport', placement:contested_by(0.25, 0, 0), held)
   machine.odometry.time = machine.odometry.time + 1
   same('no longer in sight', placement:contested_by(0.3, 0, 0), nil)
end)

case('in front of another a block goes down before its face, and then in', function()
   local machine, fake, run = machine_with { { x = 0.40, y = 0 }, { x = 0.5, y = 0.35, colour = 3 } }
   local base = with_block_before(machine, run)
   local heading = math.pi / 2
   same('placed', run(function()
      return machine.placement:place(base, 'extend', { colour = 1, heading = heading })
   end), true)
   same('level', fake.blocks[1].level, 0)
   near('x', fake.blocks[1].x, 0.5, 1.5e-3)
   -- 1 mm is left to the magnets
   near('y', fake.blocks[1].y, 0.35 - 0.055 - 0.001, 1.5e-3)
end)

case('a block that was lost on the way is not put down', function()
   local machine, fake, run = machine_with { { x = 0.40, y = 0 }, { x = 0.5, y = 0.35, colour = 3 } }
   local block = run(function() return machine.search:find(dark) end)
   run(function() return machine.pickup:pick_up(block) end)
   fake.held.x, fake.held = 2, nil
   local good, why = run(function()
      coroutine.yield()
      return machine.placement:place(block, 'raise')
   end)
   same('good', good, false)
   same('why', why, 'the block was lost')
end)

case('a site over which another holds a block is not free', function()
   local machine = machine_with()
   local placement = machine.placement
   same('free', placement:is_free(0.3, 0, 0), true)
   machine.tracker.tracks = { { x = 0.38, y = 0, z = 0.1, colour = 4, time = 0, missed = 0 } }
   same('held near', placement:is_free(0.3, 0, 0), false)
   machine.tracker.tracks[1].id, placement.spared = 7, 7
   same('a brick that shows what blocks in hands do', placement:is_free(0.3, 0, 0), true)
   same('nor is its place contested', placement:contested_by(0.38, 0, 0), nil)
   placement.spared = false
   machine.tracker.tracks = { { x = 0.38, y = 0, z = 0.0275, colour = 1, time = 0, missed = 0 } }
   same('a brick beside', placement:is_free(0.3, 0, 0), true)
   same('where it stands', placement:is_free(0.38, 0.01, 0), false)
   same('on top of it', placement:is_free(0.38, 0.01, 1), true)
end)

case('the lift is sent beyond its rest, and holds fast what it carries', function()
   local machine, fake, run = machine_with()
   same('there', run(function() return machine.lift:to(0.05) end), true)
   near('from below', fake.sent.lift, 0.0508)
   run(function() return machine.lift:to(0.03) end)
   near('from above', fake.sent.lift, 0.0292)
   run(function() return machine.lift:to(1) end)
   near('the highest', fake.sent.lift, 0.136)
   local fast = false
   machine.magnets.carrying = true
   run(function() return machine.lift:to(0.08) end, function()
      fast = fast or fake.sent.discharge == 'constructive'
   end)
   same('held fast', fast, true)
   same('no more', fake.sent.discharge, 'disable')
end)
