-- SPDX-License-Identifier: MIT
-- Who goes in where robots meet at a site, and whose turn it is where all could do but one and the same.

local RightOfWay = require 'mission.right_of_way'
local SideAllocation = require 'mission.side_allocation'
local StructureMap = require 'mission.structure_map'
local Turns = require 'mission.turns'
local geometry = require 'common.geometry'
local machine_with = require 'machine_with'
local map_of = require 'map_of'
local unit = require 'unit'
local case, near, same = unit.case, unit.near, unit.same

local ALL = { '+x', '+y', '-x', '-y' }
local SIDE = geometry.SIDE

local function way_of(machine, map) return RightOfWay.new(machine, map, nil, nil, { delay = 30 }) end

case('with the lift at its top a robot is seen on the other side of a site', function()
   local machine, fake, run = machine_with {}
   local way = way_of(machine, {})
   machine.ranges.range = function(_, name)
      return name == 'front' and fake.robot.lift_system.position > 0.13 and 0.12 or nil
   end
   local other = run(function() return way:opposite() end)
   near('ahead', other.x, machine.description.effector.front + 0.12, 1e-3)
   near('straight', other.y, 0, 1e-3)
   machine.ranges.range = function() return nil end
   same('nobody', run(function() return way:opposite() end), nil)
end)

-- Lower, the picture's upper edge cuts off the tags of a block that another holds before an adjoining side.
case('a robot looks to both sides for others with the lift at its top', function()
   local machine, fake, run = machine_with {}
   local way = way_of(machine, { known = { x = 0.3, y = 0, reach = 0.03 } })
   local least, most, lowest = 0, 0, math.huge
   local busy = run(function() return way:sees_others_work { x = 0.3, y = 0, yaw = 0 } end, function()
      least, most = math.min(least, fake.pose.yaw), math.max(most, fake.pose.yaw)
      if math.abs(fake.pose.yaw) > 0.1 then lowest = math.min(lowest, fake.robot.lift_system.position) end
   end)
   same('nobody', busy, nil)
   same('to both sides', least < -0.7 and most > 0.7, true)
   near('lift', lowest, machine.lift:top(), 0.001)
   near('ahead again', fake.pose.yaw, 0, 0.02)
end)

-- What a robot before a column at x = 0.3 finds that looks to both sides, where in the turn to the right it sees a block
-- in another's hand, so far aside; how far it turned; and where it faces in the end.
local function look_aside(left)
   local machine, fake, run = machine_with {}
   local map = {
      is_on_adjoining_side = function() return true end,
      room_about = function(_, x, y) return geometry.apart({ x = x, y = y }, { x = 0.3, y = 0 }) - geometry.HALF end,
   }
   local way = way_of(machine, map)
   local furthest, seen = 0, false
   local busy = run(function() return way:sees_others_work { x = 0.3, y = 0, yaw = 0 } end, function()
      furthest = math.max(furthest, math.abs(fake.pose.yaw))
      if fake.pose.yaw < -0.4 and not seen then
         seen = true
         table.insert(machine.tracker.tracks, {
            id = 1, x = 0.3, y = left, z = 0.138, yaw = 0, turned = 0, colour = 4, seen = 9, missed = 0,
            time = machine.odometry.time, top_time = 0, variance = 1e-6,
         })
      end
   end)
   return busy, furthest, fake.pose.yaw
end

case('what another holds counts as soon as it is seen in a turn aside', function()
   local busy, furthest, yaw = look_aside(0.1)
   near('somebody', busy.y, 0.1, 1e-9)
   same('at once', furthest > 0.4 and furthest < 0.6, true)
   near('ahead again', yaw, 0, 0.02)
end)

case('who stands farther off for a look of its own is not at work', function()
   local busy, furthest = look_aside(0.17)
   same('nobody', busy, nil)
   same('to both sides', furthest > 0.7, true)
end)

case('of two robots that see each other the one goes before the other by their sides, another one at each level', function()
   local task = { transport = 4, sides = ALL, turns = true }
   -- each at its own side of a brick, which it sees ahead; places of others are to its left, opposite and to its right
   local others = { { 0.3, 0.2 }, { 0.5, 0 }, { 0.3, -0.2 } }
   local function order_at(level)
      local said = {}
      for _, side in ipairs { '+x', '+y', '-x', '-y' } do
         local map = map_of({ { 0, 0, 0 } }, { x = 0.3, y = 0, yaw = 0 }, task, { side = side })
         map:remember(map:in_memory())
         map:settle()
         for _, other in ipairs(others) do
            table.insert(said, map:goes_before({ x = other[1], y = other[2] }, level) and 'first' or 'then')
         end
      end
      return table.concat(said, ' ')
   end
   -- who is to the left of +x is at -y, to the left of +y at +x, and so on
   same('by the order of sides', order_at(0), 'first first first then first first then then first then then then')
   same('from the next on', order_at(1), 'then then then first first first then first first then then first')
   local map = map_of({ { 0, 0, 0 } }, { x = 0.3, y = 0, yaw = 0 }, task, { side = '+x' })
   map:remember(map:in_memory())
   map:settle()
   local count = 0
   for _ = 1, 200 do count = count + (map:goes_before({ x = 0.1, y = 0 }, 0) and 1 or 0) end
   same('by chance on one side', count > 50 and count < 150, true)
end)

-- What a robot before the origin does that finds `found` in its looks, one after the other: an `other` that is seen at work, a
-- place `across` the corner, or false for nobody. Whether it goes in; what it did in between, in words; what it was told to pass
-- over. `map` answers what is asked of it.
local function looks(map, found, turn)
   local did, passed = {}, {}
   local way = setmetatable({
      map = map,
      process = { wait = function() table.insert(did, 'stays') end, enter = function() end },
      path = { follow_back = function() end },
      turns = {
         is_own = function() return turn or false end,
         await_brick = function() table.insert(did, 'waits for a brick') end,
      },
   }, RightOfWay)
   function way:other_at_work(_, first)
      table.insert(passed, first)
      local is = table.remove(found, 1)
      self.across = is and is.across or nil
      return is and is.other and not (first and is.leaves) and is.other or nil
   end
   return way:is_alone({ x = 0, y = 0, yaw = 0 }, 1), table.concat(did, ', '), passed
end

-- A map by which the robot goes before others, or not, who are on adjoining sides, or not, and for whom it waits, or not.
local function answers(before, adjoins, waits)
   return {
      goes_before = function() return before end,
      is_on_adjoining_side = function() return adjoins end,
      waits_at_corner = function() return waits end,
      room_about = function(_, x, y) return math.sqrt(x * x + y * y) - geometry.HALF end,
      side = 0,
   }
end

case('who goes first stays, looks again, and then goes in whoever comes; the other leaves at once', function()
   -- a block in line with the site
   local same_site = { other = { x = 0, y = 0.1, z = 0.16 }, leaves = true }
   local goes, did, passed = looks(answers(true, true), { same_site, same_site })
   same('goes in', goes, true)
   same('stays once', did, 'stays')
   same('past who leaves', passed[2], true)
   goes, did = looks(answers(false, true), { same_site, same_site })
   same('leaves', goes, false)
   same('at once', did, '')
   local opposite = { other = { x = 0.06, y = 0, opposite = true } }
   goes, did = looks(answers(true, false), { opposite, opposite, opposite, opposite })
   same('not for ever', goes, false)
   same('stays', did, 'stays, stays, stays')
   goes, did, passed = looks(answers(false, true), { same_site }, true)
   same('goes in, where it is its turn', goes, true)
   same('passed over', passed[1], true)
   same('at once', did, '')
end)

case('who sees another at work at an adjoining site waits until a new brick is in sight', function()
   local in_there = { other = { x = 0.055, y = 0.055, z = 0.09 } }
   local goes, did = looks(answers(true, true, true), { in_there, false })
   same('goes in then', goes, true)
   local lost = answers(true, true, true)
   lost.side = nil
   same('not where the structure is lost meanwhile', (looks(lost, { in_there, false })), false)
   same('in between', did, 'waits for a brick')
   goes, did = looks(answers(true, true, false), { in_there, in_there, false })
   same('likewise where the other is to wait at corners', goes, true)
   same('while that one is in there', did, 'waits for a brick, waits for a brick')
   -- a block as far as who looks to both sides holds his
   local stands = { other = { x = 0.055, y = 0.122, z = 0.16 } }
   goes, did = looks(answers(true, true, false), { stands, stands })
   same('who stands is to wait', goes, true)
   same('by the second look', did, 'stays')
   local felt = { other = { x = 0.055, y = 0.175 } }
   goes, did = looks(answers(true, true, false), { felt, felt })
   same('felt', goes, true)
   same('likewise', did, 'stays')
   goes, did = looks(answers(true, true, true), { stands, stands, stands, stands })
   same('who is to wait does so, not for ever', goes, false)
   same('three times', did, 'waits for a brick, waits for a brick, waits for a brick')
end)

case('of two at a corner the one along y waits until the other is through, which looks once more', function()
   local place = { across = { x = 0.06, y = 0.12 } }
   for along_y, said in pairs { [true] = 'waits for a brick', [false] = 'stays' } do
      local goes, did = looks(answers(true, true, along_y), { place, false })
      same('goes in', goes, true)
      same('in between', did, said)
   end
   local goes, did = looks(answers(true, true, true), { place, place, place })
   same('who has waited goes in', goes, true)
   same('after one more look', did, 'waits for a brick, stays')
   same('nobody', select(2, looks(answers(true, true, true), { false })), '')

   local machine, fake = machine_with {}
   local way = way_of(machine, {})
   local effector = machine.description.effector.front
   local function felt(yaw, ahead)
      machine.odometry.pose = { x = 0, y = 0, yaw = yaw }
      fake.robot.rangefinders.front.proximity = ahead
      return way:felt_across { x = 0.19, y = 0, yaw = 0 }
   end
   local place_seen = felt(0.5, 0.26 - effector)
   near('ahead', place_seen.x, 0.26 * math.cos(0.5), 1e-9)
   near('aside', place_seen.y, 0.26 * math.sin(0.5), 1e-9)
   same('beyond the site', felt(0, 0.26 - effector), nil)
   same('before the same site', felt(0.5, 0.21 - effector), nil)
   same('nothing', felt(0.5, 0.2), nil)
end)

case('sides along y wait at a corner for those along x', function()
   local task, said = { transport = 4, sides = ALL, turns = true }, {}
   for _, side in ipairs { '+x', '+y', '-x', '-y' } do
      local map = map_of({ { 0, 0, 0 } }, { x = 0.3, y = 0, yaw = 0 }, task, { side = side })
      map:remember(map:in_memory())
      map:settle()
      for _, other in ipairs { { 0.3, 0.2 }, { 0.5, 0 }, { 0.3, -0.2 } } do
         table.insert(said, map:waits_at_corner { x = other[1], y = other[2] } and 'waits' or 'goes')
      end
   end
   same('sides', table.concat(said, ' '),
        'goes goes goes waits goes waits goes goes goes waits goes waits')
end)

case('a block far from the bricks does not count for who goes before its robot, but one that is going in does', function()
   local machine = machine_with {}
   local map = {
      goes_before = function() return true end,
      is_on_adjoining_side = function(_, block) return math.abs(block.y) > 0.06 end,
      room_about = function(_, x, y) return geometry.apart({ x = x, y = y }, { x = 0.3, y = 0 }) - geometry.HALF end,
   }
   local way = way_of(machine, map)
   local line = { x = 0.3, y = 0, yaw = 0 }
   local function holds(y, x)
      machine.tracker.tracks = { { x = x or 0.3, y = y, z = 0.14, colour = 4, time = machine.odometry.time } }
      return way:held_at_work(line, false) ~= nil, way:held_at_work(line, true) ~= nil
   end
   local counts, for_first = holds(0.096)
   same('looks to both sides', counts, true)
   same('is to leave', for_first, false)
   counts, for_first = holds(0.06)
   same('goes in', counts and for_first, true)
   counts, for_first = holds(0.11, 0.355)
   same('at an adjoining site', counts and for_first, true)
   machine.returns.near = function() return { { x = 0.3, y = 0.145 } } end
   same('felt', way:felt_at_work(line, 0, false).y, 0.145)
   same('is to leave', way:felt_at_work(line, 0, true), nil)
   machine.returns.near = function() return { { x = 0.3, y = 0.11 } } end
   same('goes in', way:felt_at_work(line, 0, true).y, 0.11)
end)

-- A tower of so many bricks, of a rule that raises it to three from any side, and bricks to be put before its faces then: the
-- map of a robot on a side, one of `crew`; and what it knows of turns and of the right of way.
local function at_tower(side, crew, height, more)
   local task = {
      transport = 4, sides = ALL, all_sides = ALL, turns = true, levels = 3, asks = {}, delay = 30,
      structure = { { 0, 0, 0, 3 }, { 0, 0, 1, 3 }, { 0, 0, 2, 3 }, { 1, 0, 0, 2 }, { 0, 1, 0, 2 }, { -1, 0, 0, 2 },
                    { 0, -1, 0, 2 }, { 2, 0, 0, 1 } },
      decide = function(column)
         if column.top_colour == 3 and column.top_level < 2 then return { what = 'raise', colour = 3 } end
         if column.top_colour == 3 then return { what = 'extend', colour = 2, level = 0 } end
         if column.top_colour == 2 then return { what = 'extend', colour = 1, level = 0 } end
      end,
   }
   local cells = {}
   for level = 0, height - 1 do table.insert(cells, { 0, 0, level, colour = 3 }) end
   table.move(more or {}, 1, #(more or {}), #cells + 1, cells)
   local map, machine = map_of(cells, { x = 0.3, y = 0, yaw = 0 }, task, { side = side, sides = side, crew = crew })
   -- of a column that is seen at once, each look makes sure of one level more
   for _ = 1, height do map:remember(map:in_memory()) end
   map:settle()
   local sides = SideAllocation.new(machine, map, nil, task)
   local turns = Turns.new(machine, map, sides, task)
   return turns, RightOfWay.new(machine, map, sides, turns, task), map, machine, task
end

case('where but one brick is due robots take turns by the order of their sides, another first at each level', function()
   for height, wanted in pairs { '3 0 1 2', '2 3 0 1' } do
      local said = {}
      for _, side in ipairs { '+x', '+y', '-x', '-y' } do
         local before, site = at_tower(side, 4, height):order()
         table.insert(said, before)
         same('the tower', site.u == 0 and site.v == 0 and site.level, height)
      end
      same('who goes before', table.concat(said, ' '), wanted)
   end
   same('its turn', at_tower('+y', 4, 1):is_own(), true)
   same('another\'s', at_tower('+x', 4, 1):is_own(), false)
   local before, site = at_tower('+x', 4, 3):order()
   same('where each has its own', before, 0)
   same('none is the only one', site, nil)
   same('where sides are without a robot', at_tower('+x', 3, 1):order(), 0)
end)

-- What a robot does in Turns:await: how long it waits for what, by the answers of its map, {true} as soon as it is asked.
local function waits(turns, process)
   local out = {}
   turns.process, turns.lift.to = process, function() end
   function process.enter() end
   function process:wait_until(done, time)
      table.insert(out, string.format('%.0f', time))
      return self.answer(done)
   end
   function process.wait() end
   return turns:await(0.13), table.concat(out, ' ')
end

case('a robot waits for its turn as long as others\' turns last, and until it sees that they are over', function()
   local turns = at_tower('+x', 4, 1)
   -- three go before, and who looks from here would see their brick
   turns.would_see = function() return true end
   local waited, times = waits(turns, { answer = function() return false end })
   same('waited', waited, true)
   same('three turns', times, '84')
   turns = at_tower('+x', 4, 1)
   turns.would_see = function() return false end
   same('one, where it would not', select(2, waits(turns, { answer = function() return false end })), '28')
   turns.odometry.time = 28
   same('not where that is over', select(2, waits(turns, { answer = error })), '')

   local others, _, map = at_tower('-x', 4, 1)
   others.would_see = function() return true end
   same('its turn once a brick is seen', select(2, waits(others, {
      answer = function(done)
         map:note_brick(0.3, 0, 1, 3)
         return done()
      end,
   })), '28')
   same('its turn has come', (waits(others, { answer = error })), false)
end)

-- Of a robot that sees the tower's top put in its first wait, and nothing in others.
local function sees_top_once(map)
   local seen = false
   return {
      answer = function(done)
         if seen then return false end
         seen = true
         map:note_brick(0.3, 0, 2, 3)
         return done()
      end,
   }
end

case('after the last turn those on its side and opposite wait for a brick of the others', function()
   for side, wanted in pairs { ['+x'] = '56 28', ['+y'] = '84', ['-y'] = '28' } do
      local turns, _, map = at_tower(side, 4, 2)
      turns.would_see = function() return true end
      same(side, select(2, waits(turns, sees_top_once(map))), wanted)
   end
   local lost, _, lost_map = at_tower('+x', 4, 2)
   lost.would_see = function() return true end
   same('the structure is lost meanwhile', (waits(lost, {
      answer = function(done)
         lost_map:lose()
         return done()
      end,
   })), true)
   -- whoever has the last turn, at whatever level: here it is +y alone from where the tower is to be raised
   for side, wanted in pairs { ['-x'] = '28', ['-y'] = '28 28' } do
      local turns, _, map, _, task = at_tower(side, 4, 2)
      local decide, raises = task.decide, StructureMap.name_of((1 - map:order_of_side(0)) % 4)
      task.decide = function(column)
         return (column.top_colour ~= 3 or column.top_level == 2 or column.side == raises) and decide(column) or nil
      end
      turns.would_see = function() return true end
      same('not at its level, ' .. side, select(2, waits(turns, sees_top_once(map))), wanted)
   end
   -- who has put it, too, when it comes back
   local turns, _, map = at_tower('-x', 4, 2)
   turns:place(function() map:note_brick(0.3, 0, 2, 3) end)
   same('back', select(2, waits(turns, { answer = function() return true end })), '28')
   same('once', (waits(turns, { answer = error })), false)
end)

case('nobody is met at a site next to which no brick is missing that others could put', function()
   local ahead = SIDE * 2
   local bricks = { { -1, 0, 0, colour = 2 } }
   local _, way, map = at_tower('+x', 4, 3, bricks)
   local function cell(x, y, level)
      local u, v = map:cell_of(0.3 + x, y)
      return { u = u, v = v, level = level }
   end
   same('farther out', way:may_meet(cell(-ahead, 0, 0)), false)
   same('at a corner', way:may_meet(cell(-SIDE, 0, 0)), true)
   map:note_brick(0.3, SIDE, 0, 2)
   same('one corner is filled', way:may_meet(cell(-SIDE, 0, 0)), true)
   map:note_brick(0.3, -SIDE, 0, 2)
   map:note_brick(0.3 - ahead, 0, 0, 1)
   same('both are', way:may_meet(cell(-SIDE, 0, 0)), false)
   _, way = at_tower('+x', 3, 3, bricks)
   same('where sides are without a robot', way:may_meet(cell(-ahead, 0, 0)), true)
   _, way = at_tower('+x', 4, 1)
   same('where others could do the same', way:may_meet(cell(0, 0, 1)), true)
end)
