-- SPDX-License-Identifier: MIT
-- What a robot that builds knows and decides, and a small structure that a fake one builds.

local FakeRobot = require 'fake_robot'
local Builder = require 'mission.builder'
local Column = require 'mission.column'
local DueRows = require 'mission.due_rows'
local SideAllocation = require 'mission.side_allocation'
local SiteWork = require 'mission.site_work'
local StructureMap = require 'mission.structure_map'
local Target = require 'mission.target'
local geometry = require 'common.geometry'
local machine_with = require 'machine_with'
local map_of = require 'map_of'
local unit = require 'unit'
local case, near, same = unit.case, unit.near, unit.same

local ALL = { '+x', '+y', '-x', '-y' }
local SIDE = geometry.SIDE

case('the structure is faced from the side that the robot begins on', function()
   local task = { transport = 4, sides = ALL, turns = false }
   -- behind the robot, as it stands at first
   local map = map_of({ { 0, 0, 0 } }, { x = -0.3, y = 0, yaw = 0.1 }, task, { side = '+y' })
   same('remembered', map:remember(map:in_memory()), true)
   near('faces it', map.known.yaw, geometry.wrap(math.pi + 0.1), 1e-9)
   near('reach', map.known.reach, SIDE / 2)
   same('new side', map:settle(), true)
   same('its own', map:side_name(), '+y')
   same('still', map:settle(), false)
   near('the next side', geometry.wrap(map:heading_of(StructureMap.SIDES['-x']) - map.known.yaw), math.pi / 2)
end)

case('rows are counted from the robot, and what juts out beside one', function()
   local task = { transport = 4, sides = ALL, turns = true }
   local map = map_of({ { 0, 0, 0 }, { 0, 1, 0 }, { -1, 1, 0 }, { -2, 1, 0 } }, { x = 0.5, y = 0, yaw = 0 }, task)
   map:remember(map:in_memory())
   map:settle()
   local rows = map:rows()
   local front = {}
   for v, row in pairs(rows) do table.insert(front, { v, row.front, row.juts }) end
   same('rows', #front, 2)
   table.sort(front, function(a, b) return a[2] < b[2] end)
   same('how far', front[2][2] - front[1][2], 2)
   near('juts', front[1][3], 2 * SIDE)
   near('juts not', front[2][3], 0)
   same('no room', map.room_before(rows, rows[front[1][1]]), false)
   same('room', map.room_before(rows, rows[front[2][1]]), true)
   local line = map.line_before(rows[front[2][1]])
   near('x', line.x, 0.5 - 2 * SIDE, 1e-9)
   near('y', line.y, SIDE, 1e-9)
end)

case('a brick far from the structure is one that was lost, and a structure far away another place', function()
   local task = { transport = 4, sides = ALL, turns = false }
   local map, machine = map_of({ { 0, 0, 0 } }, { x = -0.3, y = 0, yaw = 0 }, task, { side = '+x' })
   map.cache = { x = 0.2, y = 0 }
   map:remember(map:in_memory())
   map:settle()
   local track = machine.tracker.tracks[1]
   track.x = 0.5
   same('not that', map:in_memory(), nil)
   local elsewhere = map:in_memory(true)
   same('lost', map:remember(elsewhere), false)
   same('unknown', map.known, nil)
   same('what was seen before does not count any more', #machine.tracker.tracks, 0)
   -- the way to where blocks come from tells the directions
   map.cache = { x = 0.5, y = 0.5 }
   same('known again', map:remember(elsewhere), true)
   near('turned', geometry.wrap(map.known.yaw), -math.pi / 2, 1e-9)
   -- what is on its way is no brick
   machine.tracker.tracks = { track }
   track.colour = 4
   same('in transport', map:in_memory(true), nil)
end)

case('a structure whose rules hold in every turn is known anew where it is found elsewhere', function()
   local task = { transport = 4, sides = ALL, turns = true }
   local map, machine = map_of({ { 0, 0, 0 }, { 1, 0, 0 } }, { x = -0.3, y = 0, yaw = 0 }, task)
   map.cache = { x = 0.2, y = 0 }
   map:remember(map:in_memory())
   map:settle()
   local far = map.cache_way
   local turned = machine.tracker.tracks
   for _, track in ipairs(turned) do track.yaw = 0.5 end
   turned[2].x, turned[2].y = -0.3 + SIDE * math.cos(0.5), SIDE * math.sin(0.5)
   same('known', map:remember(map:in_memory()), true)
   same('its bricks alone', map:count_bricks(), 2)
   near('how it lies', geometry.wrap_quarter(map.known.yaw - 0.5), 0, 1e-9)
   near('its cache as far off', geometry.apart(map:beginning(), map.cache), far, 1e-9)
end)

case('a structure of which only what is high up is seen at first is known by that', function()
   local task = { transport = 4, sides = ALL, turns = true }
   local map = map_of({ { 0, 0, 1 } }, { x = 0.3, y = 0, yaw = 0.1 }, task)
   same('remembered', map:remember(map:in_memory()), true)
   near('where it is', map.known.x, 0.3, 1e-9)
   near('its reach', map.known.reach, SIDE / 2, 1e-9)
   same('the brick', map:had_brick(0.3, 0, 1), true)
end)

case('bricks are remembered where they were seen, until the structure is lost', function()
   local task = { transport = 4, sides = ALL, turns = false }
   local map, machine = map_of({ { 0, 0, 0 }, { 1, 0, 0 } }, { x = -0.3, y = 0, yaw = 0 }, task)
   same('nothing is known', map:room_about(-0.3, 0), math.huge)
   map:remember(map:in_memory())
   near('beside the second', map:room_about(-0.3 + SIDE, 0.1275), 0.1, 1e-9)
   near('off a corner', map:room_about(-0.3 - 0.0575, -0.0675), 0.05, 1e-9)
   near('on one', map:room_about(-0.29, 0), 0, 1e-9)
   machine.tracker.tracks = { machine.tracker.tracks[1] }
   map:remember(map:in_memory())
   near('out of sight', map:room_about(-0.3 + SIDE, 0.1275), 0.1, 1e-9)
   near('the middle of both', map.known.x, -0.3 + SIDE / 2, 1e-9)
   near('as far as both reach', map.known.reach, SIDE, 1e-9)
   same('its level', map:had_brick(-0.3 + SIDE, 0, 0), true)
   same('no other', map:had_brick(-0.3 + SIDE, 0, 1), false)
   map:note_brick(-0.3 + SIDE, 0.01, 1)
   same('one put on it', map:had_brick(-0.3 + SIDE, 0, 1), true)
   map:lose()
   same('nor known any more', map:had_brick(-0.3 + SIDE, 0, 1), false)
   same('lost', map:room_about(-0.3, 0), math.huge)
end)

case('a block in the air is no brick, but one that another holds from beside is', function()
   local task = { transport = 4, sides = ALL, turns = false }
   local map, machine = map_of({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 0, 2 } }, { x = -0.3, y = 0, yaw = 0 }, task)
   map:remember(map:in_memory())
   same('on the floor', map:had_brick(-0.3 + SIDE, 0, 0), true)
   same('in the air', map:had_brick(-0.3 + SIDE, 0, 2), false)
   machine.tracker.tracks[3].z = 1.5 * SIDE
   map:remember(map:in_memory())
   same('on one', map:had_brick(-0.3 + SIDE, 0, 1), true)
   machine.tracker.tracks[1].x, machine.tracker.tracks[1].z = -0.3 + 2 * SIDE, 1.5 * SIDE
   map:remember(map:in_memory())
   same('an overhang', map:had_brick(-0.3 + 2 * SIDE, 0, 1), true)
end)

case('a brick that would be seen, and is not, is forgotten', function()
   local task = { transport = 4, sides = ALL, turns = false }
   local map, machine = map_of({ { 0, 0, 0 }, { 0, 0, 1 }, { 0, 1, 0 } }, { x = 0.3, y = 0, yaw = 0 }, task)
   map:remember(map:in_memory())
   map:settle()
   local row = map:rows()[0]
   -- the second was in another's hand, the third is below the picture
   table.remove(machine.tracker.tracks, 2)
   machine.tracker.tracks[2].time = -1
   local hidden = SIDE
   machine.sight.would_see = function(_, _, y) return math.abs(y - hidden) > 1e-3 end
   for _ = 1, 11 do map:forget_gone(row, machine.sight, {}) end
   same('not yet', map:had_brick(0.3, 0, 1), true)
   map:note_brick(0.3, 0, 1)
   for _ = 1, 11 do map:forget_gone(row, machine.sight, {}) end
   same('seen meanwhile', map:had_brick(0.3, 0, 1), true)
   map:forget_gone(row, machine.sight, {})
   same('gone', map:had_brick(0.3, 0, 1), false)
   same('seen', map:had_brick(0.3, 0, 0), true)
   same('hidden', map:had_brick(0.3, SIDE, 0), true)
   hidden = math.huge
   for _ = 1, 12 do map:forget_gone(row, machine.sight, {}) end
   same('none of the column', map:had_brick(0.3, SIDE, 0), false)
   same('bricks', map:count_bricks(), 1)
end)

case('a block is drawn aside to a lower brick that nothing stands against', function()
   local task = { transport = 4, sides = ALL, turns = false }
   local map = map_of({ { 0, 0, 0 }, { 1, 0, 0 } }, { x = -0.3, y = 0, yaw = 0 }, task)
   local first, second = -0.3, -0.3 + SIDE
   same('nothing is known', map:draws_aside(second, 0, 1), false)
   map:remember(map:in_memory())
   same('at the end of a row', map:draws_aside(second, 0, 1), true)
   same('on the floor', map:draws_aside(second + SIDE, 0, 0), false)
   map:note_brick(first, 0, 1)
   same('up to one of its level', map:draws_aside(second, 0, 1), false)
   map:note_brick(second + SIDE, 0, 0)
   map:note_brick(second, SIDE, 0)
   same('to the left', map:draws_aside(second, 0, 1), true)
   map:note_brick(second, -SIDE, 0)
   same('to both sides alike', map:draws_aside(second, 0, 1), false)
end)

case('a cache is where blocks were found, or as far from the beginning as another, whatever has grown', function()
   local task = { transport = 4, sides = ALL, turns = false }
   local map, machine = map_of({ { 0, 0, 0 } }, { x = -0.3, y = 0, yaw = 0 }, task, { side = '+x' })
   local function knows_cache(x, y)
      map.cache = { x = x, y = y }
      map:remember(map:in_memory())
      map:settle()
   end
   same('none yet', map:cache_of(0), nil)
   knows_cache(0.2, 0)
   local sides = SideAllocation.new(machine, map, nil, task)
   -- an arm has grown towards the robot
   for i = 1, 2 do map:note_brick(-0.3 + i * SIDE, 0, 0) end
   map:remember(map:in_memory())
   near('the middle has moved', map.known.x, -0.3 + SIDE, 1e-9)
   sides:take(StructureMap.SIDES['+y'])
   near('beside the beginning', map.cache.x, -0.3, 1e-9)
   near('as far off', math.abs(map.cache.y), 0.5, 1e-9)
   knows_cache(-0.28, map.cache.y)
   sides:take(StructureMap.SIDES['+x'])
   near('the first again', map.cache.x, 0.2, 1e-9)
   sides:take(StructureMap.SIDES['+y'])
   near('where the second was found', map.cache.x, -0.28, 1e-9)
   -- farther off than the others
   knows_cache(-0.3, -0.7)
   near('of those that are known the nearest', geometry.apart(map:cache_of(StructureMap.SIDES['-x']), { x = -0.3, y = 0 }), 0.5, 0.01)
end)

-- Rules of a task: raise what shows 2 on the floor; from -x extend what shows 3.
local function decides(column)
   if column.top_colour == 2 and column.top_level == 0 then return { what = 'raise', colour = 1 } end
   if column.top_colour == 3 and column.side == '-x' and column.cell(1, 0, 0) == 'empty' then
      return { what = 'extend', colour = 1 }
   end
end

case('rows are due where the rules ask for them in what is remembered', function()
   local task = { transport = 4, sides = ALL, turns = false, levels = 2, decide = decides }
   local map = map_of({ { 0, 0, 0 }, { 0, 1, 0, colour = 2 }, { 1, 0, 0, colour = 3 } }, { x = 0.3, y = 0, yaw = 0 }, task)
   map:remember(map:in_memory())
   map:settle()
   local function due(side)
      local out = {}
      for v, row in pairs(DueRows.of(map, task, StructureMap.SIDES[side])) do
         table.insert(out, v .. ':' .. row.front)
      end
      table.sort(out)
      return table.concat(out, ' ')
   end
   same('from its own side', due('+x'), '1:0')
   same('from the other', due('-x'), '-1:0 0:1')
   same('from the side', due('-y'), '0:1')
   map:note_brick(0.3, SIDE, 1, 1)
   same('once it is built', due('+x'), '')
   map:note_brick(0.3 + SIDE, 0, 0, nil)
   same('nor where a colour is not known', due('-x'), '')
end)

case('what is raised on an overhang is due over its highest brick', function()
   local task = {
      transport = 4, sides = ALL, turns = false, levels = 3,
      decide = function(column)
         return not column.top_level and column.cell(0, 0, 1) == 2 and { what = 'raise', colour = 1 } or nil
      end,
   }
   local map = map_of({ { 0, 0, 0 }, { 0, 0, 1 }, { 0, 1, 1, colour = 2 } }, { x = 0.3, y = 0, yaw = 0 }, task)
   map:remember(map:in_memory())
   map:settle()
   map:note_brick(0.3, SIDE, 1, 2)
   local site = DueRows.of(map, task, StructureMap.SIDES['+x'])[1].site
   same('level', site.level, 2)
   same('column', site.v, 1)
end)

case('a column that is below the picture of a look is the one that was seen on the way', function()
   local task = { transport = 4, sides = ALL, turns = true, levels = 2, asks = { { 0, 0, 1 } },
                  decide = function() return { what = 'raise', colour = 1 } end }
   local map, machine = map_of({ { 0, 0, 0, colour = 2 }, { 0, 1, 0, colour = 3 } }, { x = 0.3, y = 0, yaw = 0 }, task)
   map:remember(map:in_memory())
   map:settle()
   local column = Column.new(machine.odometry, machine.tracker, machine.sight, map, task, map:rows()[1])
   local wish = column:decide()
   same('top', wish.top.colour, 3)
   near('height', wish.top.z, SIDE / 2, 1e-9)
end)

case('a robot that has lost the structure wants nothing at a column', function()
   local task = { transport = 4, sides = ALL, turns = false, levels = 2, asks = {}, decide = decides, structure = { { 0, 0, 0, 2 } } }
   local map, machine = map_of({ { 0, 0, 0, colour = 2 } }, { x = 0.3, y = 0, yaw = 0 }, task)
   map:remember(map:in_memory())
   map:settle()
   local column = Column.new(machine.odometry, machine.tracker, machine.sight, map, task, map:rows()[0])
   local known = map.known
   map:lose()
   -- found again, before it knows on which side of it it is
   map.known, map.directions.doubtful = known, true
   local wish, seen = column:decide()
   same('wish', wish, nil)
   same('top', seen, false)
end)

case('a robot goes to a row that is due before others, and at once to the side where there is one', function()
   local task = {
      transport = 4, sides = ALL, turns = false, levels = 2, asks = {}, delay = 0, decide = decides,
   }
   local map, machine = map_of({ { 0, 0, 0 }, { 0, 1, 0, colour = 2 }, { 1, 0, 0, colour = 3 } },
                               { x = 0.3, y = 0, yaw = 0 }, task)
   map:remember(map:in_memory())
   map:settle()
   local sides = SideAllocation.new(machine, map, nil, task)
   sides.withdraw = function() end
   local work = SiteWork.new(machine, map, nil, sides, nil, task)
   work.magnets = { holds = function() return true end }
   same('chosen', work:choose_row(), 'chosen')
   same('due, though not straight ahead', work.row.v, 1)
   work:set_aside(1)
   same('to another side', work:choose_row(), 'none')
   same('the nearest', sides.wanted, StructureMap.SIDES['-y'])
   same('at once', work:stays(), false)
   same('which is no round in vain', work.in_vain, 0)
   sides.navigation = { to = function() end }
   same('changes', sides:change(), true)
   same('there', map:side_name(), '-y')
   same('and no farther', sides.wanted, nil)
   for v = 0, 1 do work.prospects:note_in_vain(StructureMap.SIDES['-y'], v) end
   same('next', work:choose_row(), 'none')
   same('the other', sides.wanted, StructureMap.SIDES['-x'])
   -- where nothing is due as far as it remembers, all rows are tried
   sides.wanted = nil
   task.decide = function() end
   same('any', work:choose_row(), 'chosen')
   task.delay, task.decide = 30, decides
   work:set_aside(0)
   work:set_aside(1)
   work.in_vain = 0
   work:choose_row()
   same('who shares its sides stays', sides.wanted, nil)
end)

case('a robot that shares its sides and finds nothing to do goes to the one where a row is due', function()
   local task = { transport = 4, sides = ALL, turns = false, levels = 2, asks = {}, delay = 30, decide = decides }
   local map, machine = map_of({ { 0, 0, 0 }, { 1, 0, 0, colour = 3 } }, { x = 0.3, y = 0, yaw = 0 }, task)
   map:remember(map:in_memory())
   map:settle()
   local worked, edge = false, nil
   local sides = SideAllocation.new(machine, map, { to = function() end }, task)
   sides.withdraw, sides.path.back_off, map.cache_way = function() end, function() end, 0.5
   sides.is_worked = function(_, _, from)
      edge = from
      return worked
   end
   local work = SiteWork.new(machine, map, nil, sides, nil, task)
   work.rest = function() end
   map.side = StructureMap.SIDES['+y']
   same('stays at first', work:stays(), true)
   machine.odometry.time = 200
   same('leaves where nothing has changed for long', work:stays(), false)
   same('to where extending is asked for', sides.wanted, StructureMap.SIDES['-x'])
   worked = true
   same('somebody is there', sides:change(), false)
   same('seen from the nearer edge', edge, 1)
   same('remembered', sides.worked, StructureMap.SIDES['-x'])
   machine.odometry.time = 600
   same('again', work:stays(), false)
   same('not there again at once', sides.wanted, nil)
   worked = false
   same('to the next on the other way round', sides:change(), true)
   same('named', map:side_name(), '+x')
   same('forgotten', sides.worked, nil)
   sides.robot.params.crew = 3
   same('where sides are free, at once', work:stays(), false)
   sides.robot.params.crew, map.side, work.tried = 4, StructureMap.SIDES['+y'], {}
   same('not at once to others\' sides', work:leaves_for_due(), false)
   sides.taken[StructureMap.SIDES['-x']] = true
   same('to one that it found free', work:leaves_for_due(), true)
   same('that one', sides.wanted, StructureMap.SIDES['-x'])
end)

-- Work of one of two robots at a bar of four bricks, of which it knows these cells, on the side of this name.
local function work_at_bar(cells, side)
   local task = {
      transport = 4, sides = ALL, turns = false, levels = 1, asks = {}, delay = 30, decide = function() end,
      structure = { { 0, 0, 0, 3 }, { 1, 0, 0, 1 }, { 2, 0, 0, 2 }, { -1, 0, 0, 1 } },
   }
   local map, machine = map_of(cells, { x = 0.3, y = 0, yaw = math.pi }, task, { side = '+x', crew = 2 })
   map:remember(map:in_memory())
   map:settle()
   map.side = StructureMap.SIDES[side]
   local sides = SideAllocation.new(machine, map, { to = function() end }, task)
   sides.withdraw, sides.path.back_off = function() end, function() end
   local work = SiteWork.new(machine, map, nil, sides, nil, task)
   work.magnets, work.rest = { holds = function() return true end }, function() end
   return work, sides, map
end

case('rows at which a brick of the final structure is missing, as far as a robot knows', function()
   local work, _, map = work_at_bar({ { 0, 0, 0, colour = 3 }, { 1, 0, 0, colour = 1 } }, '+y')
   local SIDES = StructureMap.SIDES
   -- its cells are counted from the side; beside the ends of the row that runs along the side, and before it in its own line
   same('seen from aside', work.prospects:is_unfinished(SIDES['+y']), true)
   same('before the one end', work.prospects:is_unfinished(SIDES['+x']), true)
   same('before the other', work.prospects:is_unfinished(SIDES['-x']), true)
   for _, u in ipairs { -1, 2 } do
      for _, way in ipairs { 1, -1 } do
         local x, y = map.place_of({ v = 0, front = 0, frame = map:frame_of(0) }, way * u, 0)
         if not map:had_brick(x, y, 0) then map:note_brick(x, y, 0, u == 2 and 2 or 1) end
      end
   end
   same('a structure that is none of its own fits in no way', work.prospects:unfinished_from(0), nil)
   local done = work_at_bar({ { 0, 0, 0, colour = 3 }, { 1, 0, 0, colour = 1 }, { 2, 0, 0, colour = 2 },
                              { -1, 0, 0, colour = 1 } }, '+y')
   for _, side in pairs(SIDES) do same('none when it stands', done.prospects:is_unfinished(side), false) end
   done.map.target = nil
   same('not known where the task does not have it', done.prospects:unfinished_from(0), nil)
end)

case('a robot knows when it has seen all that is in sight in the end', function()
   local function sees_all(cells) return (work_at_bar(cells, '+y')).prospects:has_seen_all() end
   local bar = { { 0, 0, 0, colour = 3 }, { 1, 0, 0, colour = 1 }, { 2, 0, 0, colour = 2 }, { -1, 0, 0, colour = 1 } }
   same('all', sees_all(bar), true)
   same('but for the last', sees_all { bar[1], bar[2], bar[3] }, false)
   same('another structure', sees_all { bar[1], bar[2], { 1, 1, 0, colour = 2 } }, false)
   local work = work_at_bar(bar, '+y')
   work.map.target = nil
   same('one without a target never does', work.prospects:has_seen_all(), false)
   -- a plate whose middle nobody sees, of which each robot has seen the rim
   local plate, rim = {}, {}
   for u = -1, 1 do
      for v = -1, 1 do
         local middle = u == 0 and v == 0
         table.insert(plate, { u, v, 0, middle and 3 or 1 })
         if not middle then table.insert(rim, { u, v, 0, colour = 1 }) end
      end
   end
   work = work_at_bar(rim, '+y')
   work.map.target = Target.new(plate)
   same('not what is hidden by others', work.prospects:has_seen_all(), true)
   work.map.bricks[next(work.map.bricks)] = nil
   same('one of the rim was not seen', work.prospects:has_seen_all(), false)
end)

case('on the first way round shared sides only rows where a brick is missing are looked at', function()
   local work = work_at_bar({ { 0, 0, 0, colour = 3 }, { 1, 0, 0, colour = 1 }, { 2, 0, 0, colour = 2 },
                              { -1, 0, 0, colour = 1 } }, '+y')
   same('none', work:choose_row(), 'none')
   work.in_vain = 4
   same('later any', work:choose_row(), 'chosen')
end)

case('a robot goes first to a side where it did not find somebody at work', function()
   local SIDES = StructureMap.SIDES
   local work, sides = work_at_bar({ { 0, 0, 0, colour = 3 } }, '+y')
   same('on its way round', work.prospects:likely_side(), SIDES['-x'])
   sides.taken[SIDES['-x']] = false
   same('the other', work.prospects:likely_side(), SIDES['+x'])
   sides.taken[SIDES['+x']] = false
   same('the opposite', work.prospects:likely_side(), SIDES['-y'])
   sides.taken[SIDES['-y']], sides.worked = false, SIDES['-x']
   same('or back where somebody was before the last change', work.prospects:likely_side(), SIDES['+x'])
   -- not twice before it was at all of them
   sides.taken, sides.worked = {}, nil
   for _, side in ipairs { '-x', '+x' } do
      same('one after the other', work.prospects:likely_side(), SIDES[side])
      work.prospects:note_left(SIDES[side])
   end
   same('the last', work.prospects:likely_side(), SIDES['-y'])
   work.prospects:note_left(SIDES['-y'])
   same('none', work.prospects:likely_side(), nil)
   same('and anew', work.prospects:likely_side(), SIDES['-x'])
   work.prospects:note_left(SIDES['-x'])
   work.prospects:forget()
   same('as after every brick', work.prospects:likely_side(), SIDES['-x'])
end)

case('the way to the opposite side leads past that where nobody was found at work', function()
   local _, sides = work_at_bar({ { 0, 0, 0, colour = 3 } }, '+y')
   same('left', sides:way_to(1), 1)
   same('right', sides:way_to(3), -1)
   same('as it goes', sides:way_to(2), 1)
   sides.taken[StructureMap.SIDES['-x']] = false
   same('the other way', sides:way_to(2), -1)
   sides.taken[StructureMap.SIDES['+x']] = false
   same('as it goes, where both are worked at', sides:way_to(2), 1)
end)

case('of fewer robots than sides one leaves a side at which another builds', function()
   local work, sides, map = work_at_bar({ { 0, 0, 0, colour = 3 }, { 1, 0, 0, colour = 1 } }, '+x')
   work:leave_side()
   same('nothing tells', work:is_worked_by_others(map:rows()), false)
   work.record = { tally = function() end }
   work:give_up()
   same('somebody was in the way', work:is_worked_by_others(map:rows()), true)
   same('leaves', work:choose_row(), 'none')
   same('remembered', sides.taken[map.side], false)
   same('to another', sides.wanted ~= nil, true)
   same('at once', work:stays(), false)
   same('forgotten', work.contested, false)
   work.at_home = true
   work:give_up()
   same('who has put a brick stays', work:is_worked_by_others(map:rows()), false)
   local v = next(map:rows())
   work.fronts[v] = map:rows()[v].front
   same('as it was looked at', work:is_worked_by_others(map:rows()), false)
   work.fronts[v] = map:rows()[v].front - 1
   same('a row has grown', work:is_worked_by_others(map:rows()), true)
   sides.robot.params.crew = 4
   same('not where there is a robot for each side', work:is_worked_by_others(map:rows()), false)
end)

case('sides that a robot is bound to', function()
   local task = { sides = ALL, turns = false }
   same('all', SideAllocation.own({}, task), ALL)
   same('bound', table.concat(SideAllocation.own({ sides = '+y -x' }, task), ' '), '+y -x')
   same('none of these', SideAllocation.own({ sides = '' }, task), ALL)
   task.turns = true
   same('counted from its first', SideAllocation.own({ sides = '+y', side = '+y' }, task)[1], '+x')
end)

case('what a column shows', function()
   local task = { transport = 4, sides = ALL, turns = true, levels = 2, asks = { { 1, 0, 0 } } }
   local map, machine = map_of({ { 0, 0, 0 }, { 0, 0, 1, colour = 2 } }, { x = 0.3, y = 0, yaw = 0 }, task)
   map:remember(map:in_memory())
   map:settle()
   local _, row = next(map:rows())
   local column = Column.new(machine.odometry, machine.tracker, machine.sight, map, task, row)
   machine.sight.would_see = function() return true end
   machine.tracker.tracks[1].top_time = -1
   for _ = 1, 2 do column:watch() end
   same('below', column:cell(0, 0, 0), 1)
   same('not often enough', column:cell(1, 0, 0), nil)
   column:watch()
   same('empty', column:cell(1, 0, 0), 'empty')
   same('above', column:cell(0, 0, 2), 'empty')
   local top = column:top()
   same('level', top.level, 1)
   same('colour', top.colour, 2)
   task.decide = function(seen)
      return seen.top_colour == 2 and { what = 'extend', colour = 3, level = 0 } or nil
   end
   local wish, seen = column:decide()
   same('wish', wish.what, 'extend')
   same('foot', wish.feet[1].level, 0)
   same('none below', wish.feet[2], nil)
   same('both', #column:down_from(1), 2)
   same('nobody beside', wish.aside, 0)
   same('seen', seen, true)
   same('told', table.concat(column.told, '; '), 'top Q2, level 1')
   -- one to the left of the site: a little off to the right
   column.bricks['1 1 0'] = { colour = 1 }
   same('aside', select(1, column:decide()).aside, -1)
   -- one to its right that is in memory alone
   local x, y = map.place_of(column.row, 1, -1)
   table.insert(machine.tracker.tracks, { id = 9, x = x, y = y, z = SIDE / 2, yaw = 0, level = 0, colour = 1,
                                          seen = 9, missed = 0, time = -10, top_time = -10 })
   same('both sides', select(1, column:decide()).aside, 0)
   column.bricks = { ['0 0 0'] = column.bricks['0 0 0'], ['0 0 1'] = column.bricks['0 0 1'] }
   same('the other side', select(1, column:decide()).aside, 1)
end)

case('a look at a large structure takes few of the instructions that a call may', function()
   local task = { transport = 4, sides = ALL, turns = true, levels = 2, asks = {}, delay = 1 }
   for du = -1, 1 do
      for dv = -1, 1 do
         for level = 0, 1 do table.insert(task.asks, { du, dv, level }) end
      end
   end
   local frame = { x = 0.34, y = 0, yaw = 0 }
   local built = {}
   for along = 0, 3 do
      for across = -2, 2 do table.insert(built, { along, across, 0 }) end
   end
   local map, machine = map_of(built, frame, task)
   same('known', map:remember(map:in_memory()), true)
   map:settle()
   machine.sight.remembered = function() return map:all_bricks() end
   for along = 0, 19 do
      for across = -10, 9 do
         local x, y = geometry.out_of(frame, SIDE * along, SIDE * across)
         map:note_brick(x, y, 0)
      end
   end
   same('bricks', map:count_bricks(), 400)
   local column = Column.new(machine.odometry, machine.tracker, machine.sight, map, task, map:rows()[0])
   local thousands = 0
   debug.sethook(function() thousands = thousands + 1 end, '', 1000)
   column:watch()
   debug.sethook()
   -- of the million that lib/lua grants
   same('of 1000', thousands < 400, true)
end)

case('what a decision asks for is noted once each, with the answer', function()
   local task = { transport = 4, sides = ALL, turns = true, levels = 2, asks = {} }
   local map, machine = map_of({ { 0, 0, 0 } }, { x = 0.3, y = 0, yaw = 0 }, task)
   map:remember(map:in_memory())
   map:settle()
   local _, row = next(map:rows())
   local column = Column.new(machine.odometry, machine.tracker, machine.sight, map, task, row)
   for _ = 1, 3 do column:count_empty(column:key(1, 0, 0)) end
   local answers = {}
   task.decide = function(seen)
      for _, dv in ipairs({ 0, 1, 0 }) do table.insert(answers, seen.cell(1, dv, 0) or 'nil') end
   end
   same('nothing', column:decide(), nil)
   same('answers', table.concat(answers, ' '), 'empty nil empty')
   same('told', table.concat(column.told, '; '), 'top not seen; 1, 0, 0: empty; 1, 1, 0: not seen')
end)

case('what was decided at a look does not hold once another brick has come that matters to it', function()
   local task = { transport = 4, sides = ALL, turns = true, levels = 2, asks = { { 0, 1, 0 } } }
   local map, machine = map_of({ { 0, 0, 0 } }, { x = 0.4, y = 0, yaw = 0 }, task)
   map:remember(map:in_memory())
   map:settle()
   -- a brick before the column, or one on it where another stands beside that
   task.decide = function(seen)
      if seen.cell(0, 1, 0) == 'empty' then return { what = 'extend', colour = 1 } end
      return { what = 'raise', colour = 1 }
   end
   local column = Column.new(machine.odometry, machine.tracker, machine.sight, map, task, map:rows()[0])
   machine.sight.would_see = function() return true end
   for _ = 1, 3 do column:watch() end
   local wish = column:decide()
   same('wished for', wish.what, 'extend')
   same('nothing has come', column:is_outdated(wish), false)
   local function comes(dv, level, changes)
      local x, y = map.place_of(column.row, 0, dv)
      local brick = { id = 9, x = x, y = y, z = SIDE * (level + 0.5), yaw = 0, turned = 1e-4, level = level, colour = 2, seen = 9,
                      missed = 0, first = 1, time = 1, top_time = 0 }
      for name, value in pairs(changes or {}) do brick[name] = value end
      machine.tracker.tracks[2] = brick
      return column:is_outdated(wish)
   end
   same('in somebody\'s hand', comes(1, 0, { colour = 4 }), false)
   same('hardly seen', comes(1, 0, { seen = 1 }), false)
   same('seen at the look, though not there', comes(1, 0, { time = 0 }), false)
   same('one that no rule asks for', comes(-1, 0), false)
   same('beside the column', comes(1, 0), true)
end)

-- As the front of a row that was known too coarsely before it.
case('a brick in front that is seen in the midst of a look leaves what was seen where it is', function()
   local task = { transport = 4, sides = ALL, turns = true, levels = 1, asks = { { 0, 1, 0 }, { 0, -1, 0 } } }
   local map, machine = map_of({ { 0, 0, 0, colour = 2 }, { 0, 1, 0, colour = 3 }, { 0, -1, 0 } },
                               { x = 0.4, y = 0, yaw = 0 }, task)
   map:remember(map:in_memory())
   map:settle()
   local column = Column.new(machine.odometry, machine.tracker, machine.sight, map, task, map:rows()[0])
   machine.sight.would_see = function() return true end
   for _ = 1, 3 do column:watch() end
   same('beside', column:cell(0, 1, 0), 3)
   table.insert(machine.tracker.tracks, {
      id = 9, x = 0.4 - SIDE, y = 0, z = SIDE / 2, yaw = 0, turned = 1e-4, level = 0, colour = 4, seen = 9,
      missed = 0, time = 0, top_time = 0,
   })
   task.transport = 0
   for _ = 1, 3 do column:watch() end
   same('the row begins with it', column.row.front, 1)
   same('its own colour', column:top().colour, 4)
   same('beside that', column:cell(0, 1, 0), 'empty')
   same('behind, beside', column:cell(-1, 1, 0), 3)
   -- seen empty, and then filled
   column.empty[column:key(-1, 1, 0)] = 3
   same('one or the other', column:cell(-1, 1, 0), nil)
end)

-- From where the camera sees the front of what stands there, and no top.
case('a column of which no top is in the picture', function()
   local task = { transport = 4, sides = ALL, turns = true, levels = 2, asks = {} }
   local machine, fake, run = machine_with { { x = 0.28, y = 0, colour = 1 } }
   run(function() machine.lift:to(0.08) machine.process:wait(1) end)
   local map = StructureMap.new(fake.robot, machine.odometry, machine.tracker, task)
   map:remember(map:in_memory())
   map:settle()
   local _, row = next(map:rows())
   local function top_seen()
      local column = Column.new(machine.odometry, machine.tracker, machine.sight, map, task, row)
      run(function()
         for _ = 1, 4 do
            coroutine.yield()
            for _, known in ipairs(machine.tracker.tracks) do known.top_time = -1 end
            column:watch()
         end
      end)
      return column:top()
   end
   same('a brick on it would be seen', top_seen().level, 0)
   table.insert(fake.blocks, { x = 0.28, y = 0, level = 1, colour = 2 })
   same('and one that is there is', top_seen().level, 1)
   -- its place is out of the picture
   fake.pose.x = fake.pose.x - 0.3
   machine.odometry.pose.x = machine.odometry.pose.x - 0.3
   same('out of sight', top_seen(), nil)
end)

local CHART = {
   first = 'search block',
   ['search block'] = { does = 'search_block', on = { found = 'approach block', none = 'search block' } },
   ['approach block'] = { does = 'approach_block', on = { near = 'pick up', lost = 'search block' } },
   ['pick up'] = { does = 'pick_up', on = { holds = 'search structure', failed = 'search block' } },
   ['search structure'] = { does = 'search_structure',
      on = { found = 'choose row', none = 'search structure', lost = 'search structure', dropped = 'search block' } },
   ['choose row'] = { does = 'choose_row',
      on = { chosen = 'stand before', none = 'next side', lost = 'search structure', dropped = 'search block' } },
   ['next side'] = { does = 'next_side', on = { there = 'choose row', lost = 'search structure' } },
   ['stand before'] = { does = 'stand_before', on = { there = 'look', blocked = 'choose row' } },
   ['look'] = { does = 'look',
      on = { decided = 'approach site', nothing = 'choose row', unseen = 'choose row', dropped = 'search block' } },
   ['approach site'] = { does = 'approach_site',
      on = { near = 'attach', busy = 'choose row', lost = 'search structure', dropped = 'search block' } },
   ['attach'] = { does = 'attach', on = { placed = 'search block', failed = 'search block' } },
}

case('a robot that is off the line of a row joins it before it looks', function()
   local machine, fake, run = machine_with { { x = 0.30, y = 0, colour = 1 } }
   local task = { transport = 4, sides = ALL, turns = true, levels = 1, asks = {},
                  looks = { { distance = 0.140, lift = 0.06 } } }
   run(function() machine.lift:to(0.06) machine.process:wait(1) end)
   local map = StructureMap.new(fake.robot, machine.odometry, machine.tracker, task)
   map:remember(map:in_memory())
   map:settle()
   local work = SiteWork.new(machine, map, nil, nil, nil, task)
   local column = Column.new(machine.odometry, machine.tracker, machine.sight, map, task, map:rows()[0])
   -- where it looks from already, but 12 mm aside and turned by 0.1
   local line = map.line_before(column.row)
   local x, y = geometry.out_of(line, -work:distance_for(task.looks[1]), 0.012)
   fake.pose = { x = x, y = y, yaw = 0.1 }
   machine.odometry.pose = { x = x, y = y, yaw = 0.1 }
   same('nobody in the way', run(function() return work:stand_for(column, task.looks[1]) end), true)
   local along, aside, angle = machine.odometry:on_line(line)
   near('there', along, -work:distance_for(task.looks[1]), 2e-3)
   near('on the line', aside, 0, 0.004)
   near('squarely', angle, 0, 0.03)
end)

case('a robot comes up to no row into which an arm may reach, but for what stands there for good', function()
   local machine, fake, run = machine_with { { x = 0.50, y = 0, colour = 1 } }
   local task = { transport = 4, sides = ALL, turns = true, levels = 1, asks = {}, looks = {} }
   local map = StructureMap.new(fake.robot, machine.odometry, machine.tracker, task)
   local work = SiteWork.new(machine, map, nil, nil, nil, task)
   machine.clearance.explained = function() return false end
   local line = { x = 0.50, y = 0, yaw = 0 }
   local function sees()
      machine.returns.points.seen = { x = 0.35, y = 0.10, time = machine.odometry.time }
   end
   sees()
   same('somebody', run(function() return work:come_up(line, 0.25, 0.08) end, sees), false)
   assert(fake.pose.x > 0.05 and fake.pose.x < 0.15, fake.pose.x)
   same('for good', run(function()
      machine.process:wait(26)
      return work:come_up(line, 0.25, 0.08)
   end, sees), true)
   near('there', fake.pose.x, 0.25, 2e-3)
end)

case('a structure that is lost in a rest is looked for', function()
   local task = { transport = 4, sides = ALL, turns = false }
   local map, machine = map_of({ { 0, 0, 0 } }, { x = -0.3, y = 0, yaw = 0 }, task, { side = '+x' })
   map.cache = { x = 0.2, y = 0 }
   map:remember(map:in_memory())
   map:settle()
   local builder = setmetatable({
      machine = machine, map = map, sides = SideAllocation.new(machine, map, nil, task), supply = {},
      work = { stays = function() map:lose() return false end },
   }, Builder)
   same('event', builder:next_side(), 'lost')
end)

case('what stands at a brick or a cache is explained', function()
   local task = { transport = 4, sides = ALL, turns = false }
   local map = map_of({ { 0, 0, 0 } }, { x = -0.3, y = 0, yaw = 0 }, task, { side = '+x' })
   map.cache = { x = 0.2, y = 0 }
   map:remember(map:in_memory())
   map:settle()
   map.cache = { x = -0.3, y = 0.5 }
   same('a brick', map:explains(-0.3 + 0.03, 0), true)
   same('its cache', map:explains(-0.3, 0.46), true)
   same('the one of a side before', map:explains(0.17, 0.01), true)
   same('nothing known', map:explains(0, 0.2), false)
   map:lose()
   same('nor any more', map:explains(0.17, 0.01), false)
end)

-- A structure that looks otherwise from every side: x, y, level, colour in the end.
local HOOK = { { 0, 0, 0, 3 }, { 1, 0, 0, 1 }, { 2, 0, 0, 2 }, { 2, 1, 0, 1 }, { 0, 0, 1, 2 } }

-- A map of the hook as a robot of the side `side` sees it whose odometry's x axis points to the world's at so many quarter
-- turns; `of`: numbers of the bricks that it sees, `colours`: what some show instead.
local function map_of_hook(side, quarters, of, colours)
   local cells = {}
   for _, i in ipairs(of) do
      local x, y, level, colour = table.unpack(HOOK[i])
      table.insert(cells, { x, y, level, colour = colours and colours[i] or colour })
   end
   local task = { transport = 4, sides = ALL, turns = false, structure = HOOK }
   return map_of(cells, { x = 0.4, y = 0.1, yaw = geometry.wrap(0.1 - quarters * math.pi / 2) }, task, { side = side })
end

case('colours tell the directions of a structure to one that is lost, but for what a single brick says', function()
   for side, index in pairs(StructureMap.SIDES) do
      for quarters = 0, 3 do
         local function heading(of, colours)
            local map = map_of_hook(side, quarters, of, colours)
            map.lost = true
            return map:remember(map:in_memory()) and map.known.yaw
         end
         -- in the world it faces the side from outside
         local right = 0.1 + (index + 2 - quarters) * math.pi / 2
         near('all bricks', geometry.wrap(heading { 1, 2, 3, 4, 5 } - right), 0, 1e-6)
         near('some', geometry.wrap(heading { 1, 2, 3, 4 } - right), 0, 1e-6)
         same('one tells nothing', heading { 1 }, false)
         same('nor where one may be wrong', heading({ 1, 2, 3, 4, 5 }, { [3] = 3 }), false)
         -- with a cache: of two ways in which the bricks are as in the end, that which it tells, or the one nearest to before
         for told, found in pairs { [0] = 0, [-1] = -1, [2] = 0 } do
            local map = map_of_hook(side, quarters, { 3, 4 })
            map.lost, map.directions.before, map.bearing = true, geometry.wrap(right + 0.4), 0
            local at, way = map:in_memory(), right + told * math.pi / 2
            local x, y = at.blocks[1].x + at.blocks[2].x, at.blocks[1].y + at.blocks[2].y
            map.cache = { x = x / 2 + math.cos(way), y = y / 2 + math.sin(way) }
            map:remember(at)
            near('by the cache', geometry.wrap(map.known.yaw - right - found * math.pi / 2), 0, 1e-6)
            same('in doubt', map.directions.doubtful, true)
         end
      end
   end
end)

case('in doubt of its directions a robot does what all that are possible want', function()
   local map, machine = map_of_hook('+x', 0, { 3, 4 })
   local asked = {}
   local task = setmetatable({
      asks = {}, levels = 2,
      decide = function(column)
         table.insert(asked, column.side)
         return map.wishes[column.side]
      end,
   }, { __index = map.task })
   map.directions.facing = function() return geometry.wrap(0.1 + math.pi) end
   map:remember(map:in_memory())
   map:settle()
   local _, row = next(map:rows())
   local column = Column.new(machine.odometry, machine.tracker, machine.sight, map, task, row)
   local function decision(wishes)
      map.wishes, asked = wishes, {}
      column.highest = function() return machine.tracker.tracks[1] end
      return column:decide()
   end
   local here = map:side_name()
   same('is certain', decision { [here] = { what = 'raise', colour = 1 } } ~= nil, true)
   same('asks once', table.concat(asked, ' '), here)
   map.directions.doubtful = true
   local sides = map.directions:possible_sides()
   same('two are possible', #sides, 2)
   same('its own', sides[1], here)
   same('they want something else', decision { [here] = { what = 'raise', colour = 1 } }, nil)
   local function both(one, other)
      return decision { [here] = { what = 'raise', colour = one }, [sides[2]] = { what = 'raise', colour = other } }
   end
   same('of another colour', both(1, 2), nil)
   same('the same', both(1, 1) ~= nil, true)
   map.directions:settle_doubt()
   same('as long as both are possible', map.directions.doubtful, true)
   map.directions.known_off = function() return { [0] = 0, 2, 2, 2 }, 0 end
   map.directions:settle_doubt()
   same('until the others are not', map.directions.doubtful, false)
end)

case('a robot that has been turned notices by the colours of bricks', function()
   for quarters = 0, 3 do
      local function turned(of, colours)
         local map = map_of_hook('+x', 0, of, colours)
         -- it takes the structure to face it otherwise
         map.directions.facing = function() return geometry.wrap(0.1 + math.pi + quarters * math.pi / 2) end
         map:remember(map:in_memory())
         return map.directions:has_turned()
      end
      same('all bricks', turned { 1, 2, 3, 4, 5 }, quarters ~= 0)
      same('one brick', turned { 1 }, false)
      same('one of a wrong colour', turned({ 1, 2, 3, 4, 5 }, { [2] = 3 }), false)
   end
   local builder = map_of_hook('+x', 0, { 1, 2, 3 })
   same('nothing known', builder.directions:has_turned(), false)
end)

case('a structure that is lost in a look is looked for, not built at', function()
   local machine, fake, run = machine_with { { x = 0.30, y = 0, colour = 1 } }
   local task = { transport = 4, sides = ALL, turns = false, levels = 1, asks = {},
                  looks = { { distance = 0.140, lift = 0.06 } } }
   run(function() machine.lift:to(0.06) machine.process:wait(1) end)
   local map = StructureMap.new(fake.robot, machine.odometry, machine.tracker, task)
   map:remember(map:in_memory())
   map:settle()
   local aborted = 0
   local work = SiteWork.new(machine, map, nil, { take_turns = function() end }, nil, task)
   work.record = { tally = function(_, what) if what == 'aborted' then aborted = aborted + 1 end end }
   work.magnets = { holds = function() return true end }
   work.row = map:rows()[0]
   work.look_from = function() map:lose() return true end
   same('looks', run(function() return work:look() end), 'unseen')
   same('wants nothing', work.wish, nil)
   same('told', aborted, 1)
   same('then', run(function() map.in_memory = function() return nil end return work:choose_row() end), 'lost')
end)

case('a place beside a column is come to from above where it is on a brick and nothing stops a block behind it', function()
   local task = { transport = 4, sides = ALL, turns = true, levels = 3, asks = {} }
   local map, machine = map_of({ { 0, 0, 0 }, { 0, 1, 0 } }, { x = 0.3, y = 0, yaw = 0 }, task)
   map:remember(map:in_memory())
   map:settle()
   local work = SiteWork.new(machine, map, nil, nil, nil, task)
   local function stands_free(left, level)
      work.row, work.wish = map:rows()[0], { what = 'beside', left = left, level = level, top = { z = SIDE / 2 } }
      return work:stands_free()
   end
   same('on a brick', stands_free(1, 1), true)
   same('over none', stands_free(-1, 1), false)
   same('two levels up', stands_free(1, 2), false)
   same('on the floor', stands_free(1, 0), false)
   local x, y = map.place_of(work.row, -1, 1)
   map:note_brick(x, y, 1)
   same('with one behind', stands_free(1, 1), false)
end)

case('what comes before the effector on the way in is a robot, where no brick stands behind the place', function()
   local task = { transport = 4, sides = ALL, turns = true, levels = 3, asks = {} }
   -- with a brick on this level behind the place to the right of the column, if any
   local function is_clear(wish, behind)
      local map, machine = map_of({ { 0, 0, 0 }, { 0, 1, 0 } }, { x = 0.3, y = 0, yaw = 0 }, task)
      map:remember(map:in_memory())
      map:settle()
      local work = SiteWork.new(machine, map, nil, nil, nil, task)
      work.row, work.wish = map:rows()[0], wish
      local x, y = map.place_of(work.row, -1, wish.left or 0)
      if behind then map:note_brick(x, y, behind) end
      return work:is_clear()
   end
   local raise = { what = 'raise', clear = true, top = { z = SIDE / 2 } }
   same('a raise as it was seen', is_clear(raise), true)
   same('over an empty cell, as high as the effector', is_clear(raise, 2), false)
   same('likewise', is_clear { what = 'extend', clear = false, top = { z = SIDE / 2 } }, false)
   local beside = { what = 'beside', left = -1, level = 0 }
   same('nothing behind', is_clear(beside), true)
   same('a brick', is_clear(beside, 0), false)
   same('one as high as the effector', is_clear(beside, 1), false)
   same('one over that', is_clear(beside, 2), true)
end)

case('what it has put down is remembered, and counts as a neighbour', function()
   local task = { transport = 4, sides = ALL, turns = true, levels = 3, asks = {} }
   local map, machine = map_of({ { 0, 0, 0 }, { 0, 1, 0 } }, { x = 0.3, y = 0, yaw = 0 }, task)
   map:remember(map:in_memory())
   map:settle()
   local rows = map:rows()
   local work = SiteWork.new(machine, map, nil, nil, nil, task)
   work.row, work.wish = rows[1], { what = 'raise', top = { z = SIDE / 2 } }
   work:note_placed()
   local column = Column.new(machine.odometry, machine.tracker, machine.sight, map, task, rows[0])
   same('to the left of the next', column:stands(0, 1, 1), true)
   same('not to the right', column:stands(0, -1, 1), false)
   local aside, open = column:room_beside { what = 'raise', top = { z = SIDE / 2 } }
   same('aside', aside, -1)
   same('not open', open, false)
   same('open', select(2, column:room_beside { what = 'extend', level = 0 }), true)
   work.row, work.wish = rows[0], { what = 'extend', level = 0 }
   work:note_placed()
   same('in front', column:stands(1, 0, 0), true)
end)

case('what stands in no cell of the final structure is no neighbour of a site', function()
   local task = { transport = 4, sides = ALL, turns = true, delay = 0, levels = 2, asks = {}, starts = { 3 },
                  structure = { { 0, 0, 0, 3 }, { 0, 0, 1, 3 }, { 0, 1, 0, 2 }, { 1, 0, 0, 2 }, { 2, 0, 0, 1 } } }
   local map, machine = map_of({ { 0, 0, 0, colour = 3 }, { 0, 0, 1, colour = 3 } }, { x = 0.3, y = 0, yaw = 0 }, task)
   map:remember(map:in_memory())
   map:settle()
   local column = Column.new(machine.odometry, machine.tracker, machine.sight, map, task, map:rows()[0])
   local site = { what = 'extend', level = 0 }
   local function seen(u, v, colour)
      local x, y = map.place_of(column.row, u, v)
      map:note_brick(x, y, 0, colour)
   end
   same('none is seen', column:room_beside(site), 0)
   -- another robot's block, before it is in its place
   seen(1, 1, 2)
   same('in another hand', column:room_beside(site), 0)
   -- where a misread one lies in memory, too
   seen(-2, 0, 1)
   same('and another', column:room_beside(site), 0)
   task.structure[6] = { 1, 1, 0, 2 }
   map.target = require('mission.target').of(task)
   same('one that may stand there', column:room_beside(site), -1)
end)

case('a neighbour of a site is one from whichever side the robot works', function()
   for side, pose in ipairs { { x = 0.3, y = 0 }, { x = 0, y = 0.3 }, { x = -0.3, y = 0 }, { x = 0, y = -0.3 } } do
      pose.yaw = 0
      local task = { transport = 4, sides = ALL, turns = true, delay = 0, levels = 2, asks = {}, starts = { 3 } }
      local map, machine = map_of({ { 0, 0, 0, colour = 3 }, { 0, 0, 1, colour = 3 } }, pose, task)
      map:remember(map:in_memory())
      map:settle()
      local column = Column.new(machine.odometry, machine.tracker, machine.sight, map, task, map:rows()[0])
      local bricks = { { 0, 0, 0, 3 }, { 0, 0, 1, 3 } }
      -- to the left of the site, and what that stands next to
      for du, colour in pairs { [0] = 1, 2 } do
         local x, y = map.place_of(column.row, du, 1)
         map:note_brick(x, y, 0, colour)
         local u, v = map:cell_of(x, y)
         table.insert(bricks, { u, v, 0, colour })
      end
      map.target = require('mission.target').new(bricks)
      same('side ' .. side, column:room_beside { what = 'extend', level = 0 }, -1)
   end
end)

-- Behind an arm that juts out nothing is seen from before it, and before the row beside it there is no room.
case('a robot that finds nothing to do among others looks beyond the rows that it knows', function()
   local task = {
      transport = 4, sides = ALL, turns = true, levels = 1, asks = {}, delay = 30, decide = function() end,
   }
   local map, machine = map_of({ { 0, 0, 0 }, { 2, -1, 0 } }, { x = 0.5, y = 0, yaw = 0 }, task)
   map:remember(map:in_memory())
   map:settle()
   local function shares() return true end
   local sides = { are_shared = shares, are_manned = shares, are_fewer = function() end, nearest_other = function() end }
   local work = SiteWork.new(machine, map, nil, sides, nil, task)
   work.magnets = { holds = function() return true end }
   local rows = map:rows()
   for v in pairs(rows) do work.tried[v] = true end
   same('not at once', work:choose_row(), 'none')
   work.in_vain = 2
   local seen = {}
   for _ = 1, 2 do
      same('beside', work:choose_row(), 'chosen')
      same('none', rows[work.row.v], nil)
      local outermost = work.row.v > 0 and rows[0] or rows[-1]
      near('where the outermost row begins', work.row.front, outermost.front)
      near('what juts out beside', work.row.juts, outermost.juts)
      seen[work.row.v] = true
   end
   same('to the left', seen[1], true)
   same('to the right', seen[-2], true)
   same('no more', work:choose_row(), 'none')
   task.delay = 0
   work.explored = {}
   same('alone', work:choose_row(), 'none')
end)

-- A robot's supply, and how each of so many blocks one after the other was fetched: 'holds', or how it was laid aside.
local function fetches(blocks, count, task)
   local fake, events = FakeRobot.new(blocks), {}
   task.sides, task.turns, task.transport, task.delay = ALL, true, 4, 0
   local supply = Builder.new(fake.robot, CHART, task).supply
   supply.machine:start(function()
      for i = 1, count do
         while supply:search_block() ~= 'found' do end
         supply:approach_block()
         events[i] = supply:pick_up()
         if events[i] == 'mute' then events[i] = supply:lay_aside() end
      end
   end)
   for _ = 1, 9000 do
      if not supply.machine:step() then break end
      fake:step()
   end
   return events, supply
end

case('a block that does not answer is laid aside, and not taken again', function()
   local blocks = { { x = 0.35, y = 0, mute = true }, { x = 0.30, y = 0.30 } }
   local events, supply = fetches(blocks, 2, { answers = true })
   same('the first', events[1], 'done')
   same('lies farther off than one lets others come', geometry.apart(blocks[1], { x = 0.35, y = 0 }) > 0.36, true)
   same('farther out', blocks[1].x > 0.7, true)
   same('on the floor', blocks[1].level, 0)
   same('the second', events[2], 'holds')
   same('coloured', blocks[2].colour, 4)
   same('one is mute', #supply.mute, 1)
   same('and that is all', supply.silent, 0)
end)

case('a robot with a block turns where it is, unless that would sweep another block or a brick', function()
   local fake = FakeRobot.new { { x = 0.35, y = 0 } }
   local task = { sides = ALL, turns = true, transport = 4, delay = 0 }
   local supply = Builder.new(fake.robot, CHART, task).supply
   same('nothing about', supply:has_room_to_turn(), true)
   supply.tracker.tracks = { { x = 0.1, y = 0.12, z = SIDE / 2, seen = 9 } }
   same('a block', supply:has_room_to_turn(), false)
   supply.tracker.tracks[1].y = 0.25
   same('farther off', supply:has_room_to_turn(), true)
   supply.map.room_about = function() return 0.1 end
   same('a brick', supply:has_room_to_turn(), false)
end)

case('where a side\'s cache is not as expected, a block that was seen on that side is taken', function()
   local fake = FakeRobot.new {}
   local task = { sides = ALL, turns = true, transport = 4, delay = 0 }
   local supply = Builder.new(fake.robot, CHART, task).supply
   local map = supply.map
   same('none while the structure is not known', supply:remembered_here(), nil)
   map.known, map.side = { x = 0.5, y = 0, reach = 0.03, yaw = 0, origin = { x = 0.5, y = 0 } }, 0
   local function lies(x, y)
      supply.tracker.tracks = { {
         id = 1, x = x, y = y, z = SIDE / 2, level = 0, yaw = 0, turned = 0, colour = 0, seen = 9, missed = 0,
         time = supply.process:time(), top_time = -1,
      } }
      return supply:remembered_here() ~= nil
   end
   same('here', lies(0.1, 0.05), true)
   same('on another side', lies(0.5, 0.4), false)
end)

case('of blocks that never answer nothing is expected', function()
   same('taken', fetches({ { x = 0.35, y = 0, mute = true } }, 1, {})[1], 'holds')
end)

case('a robot to which no block answers gives up', function()
   local events = fetches({ { x = 0.35, y = 0, mute = true }, { x = 0.30, y = 0.30, mute = true },
                            { x = 0.30, y = -0.30, mute = true } }, 3, { answers = true })
   same('one', events[1], 'done')
   same('two', events[2], 'done')
   same('three', events[3], 'useless')
end)

case('a robot that can do nothing sleeps out of the others\' way', function()
   local fake = FakeRobot.new {}
   local supply = Builder.new(fake.robot, CHART, { sides = ALL, turns = true, transport = 4, delay = 30 }).supply
   local went, slept
   supply.navigation = { to = function(_, x, y) went = { x = x, y = y } end }
   supply.process = { wait = function(_, time) slept = time end }
   supply.map.known, supply.map.cache = { x = -0.2, y = 0 }, { x = 0.3, y = 0 }
   same('ends', supply:sleep(), 'done')
   assert(slept > 600)
   near('between its cache and the next side\'s', math.atan(went.y, went.x + 0.2), math.pi / 4, 1e-9)
   assert(math.sqrt((went.x + 0.2) ^ 2 + went.y ^ 2) > 0.8, 'farther out than both')
end)

case('a robot finds a cache that it does not see from where it begins straight ahead', function()
   for away, params in pairs { [0.62] = { side = '+x', sides = '+x' }, [0.85] = { side = '+x' } } do
      local fake = FakeRobot.new { { x = away, y = 0.02 } }
      fake.robot.params = params
      local supply = Builder.new(fake.robot, CHART, { sides = { '+x', '-x' }, transport = 4, delay = 30 }).supply
      local machine, found = supply.machine, nil
      machine:start(function() found = supply:search_block() end)
      for _ = 1, 1000 do
         if not machine:step() then break end
         fake:step()
      end
      same('found', found, 'found')
      near('there', supply.block and supply.block.x, away, 0.01)
      same('without a search', machine.process:time() < 10, true)
   end
end)

case('each side has its face, from which places before it are counted', function()
   local task = { transport = 4, sides = ALL, turns = false, delay = 30 }
   -- an arm of four to +x, behind which the middle lies
   local cells = { { 0, 0, 0 } }
   for i = 1, 4 do cells[i + 1] = { i, 0, 0, colour = 2 } end
   local map = map_of(cells, { x = 0.3, y = 0, yaw = 0 }, task)
   map:remember(map:in_memory())
   map.cache = { x = 0, y = 0 }
   map:settle()
   for index, face in pairs { [0] = { 0.3 - SIDE / 2, 0 }, [2] = { 0.3 + 4.5 * SIDE, 0 }, [1] = { 0.3 + 2 * SIDE, -SIDE / 2 } } do
      near('x', map:face_of(index).x, face[1], 1e-3)
      near('y', map:face_of(index).y, face[2], 1e-3)
   end
   near('to the cache', map:room_to_cache(0), 0.3 - SIDE / 2, 1e-3)
   near('where none was found, past the arm', map:room_to_cache(2), 0.36, 1e-3)
   local sides = SideAllocation.new({ odometry = { pose = { x = 0, y = 0, yaw = 0 } } }, map, nil, task)
   near('before the near side', sides:place_before(0, 0.1), 0.3 - SIDE / 2 - 0.1, 1e-3)
   local function held(x, y) return { held_by_others = function() return { { x = x, y = y } } end } end
   sides.clearance = held(0.1, -0.2)
   same('carried where one works', sides:is_carried_near({ x = 0.15, y = 0 }), true)
   sides.clearance = held(0.1, -0.4)
   same('carried elsewhere', sides:is_carried_near({ x = 0.15, y = 0 }), false)
   near('before the far one', sides:place_before(2, 0.1), 0.3 + 4.5 * SIDE + 0.1, 1e-3)
   near('the nearest brick', map:nearest_brick({ x = 0, y = 0.1 }).x, 0.3, 1e-3)
   near('from the other end', map:nearest_brick({ x = 1, y = -0.1 }).x, 0.3 + 4 * SIDE, 1e-3)
   map.bricks = {}
   near('where all are forgotten, as far out', map:face_of(0).x, 0.3 - SIDE / 2, 1e-3)
   near('the middle', map:nearest_brick({ x = 0, y = 0 }).x, 0.3 + 2 * SIDE, 1e-3)
end)

case('a robot that has gone beside its rows withdraws to its own side', function()
   for _, place in ipairs { { x = -0.14, y = 0.02, own = true }, { x = -0.45, y = 0.24, own = false } } do
      local fake = FakeRobot.new()
      fake.robot.params = { side = '+x', sides = '+x' }
      fake.pose = { x = place.x, y = place.y, yaw = math.pi }
      local builder = Builder.new(fake.robot, CHART, { sides = { '+x', '-x' }, transport = 4, delay = 30 })
      local machine, map = builder.machine, builder.map
      machine.odometry.pose = { x = place.x, y = place.y, yaw = math.pi }
      local structure = { x = -0.4, y = 0 }
      map.known = { x = structure.x, y = structure.y, reach = SIDE / 2, yaw = math.pi, origin = structure }
      map.first, map.side = { u = 0, v = 0 }, 0
      local done
      machine:start(function()
         builder.sides:withdraw()
         done = true
      end)
      while not done and machine:step() and machine.process:time() < 120 do fake:step() end
      same('on its side', map:is_on_side(0, machine.odometry.pose), true)
      near('as far', geometry.apart(structure, machine.odometry.pose), SIDE / 2 + 0.28, 0.035)
      near('facing the structure', geometry.wrap(machine.odometry.pose.yaw - math.pi), 0, 0.1)
      same('straight back', math.abs(machine.odometry.pose.y - place.y) < 0.01, place.own)
   end
end)

case('who would look across a side turns back before it drives into another that does', function()
   local across = { x = 0.5, y = 0.6, yaw = math.pi / 2 }
   for _, somebody in ipairs { true, false } do
      local fake, worked = FakeRobot.new {}, nil
      local builder = Builder.new(fake.robot, CHART, { sides = ALL, transport = 4, delay = 30 })
      local machine = builder.machine
      local x, y = geometry.out_of(across, -0.30, 0)
      local finder, nearest = fake.robot.rangefinders['2'], math.huge
      local nothing = finder.proximity
      machine:start(function() worked = builder.sides:is_worked_across(across) end)
      while worked == nil and machine.process:time() < 200 and machine:step() do
         fake:step()
         local ahead, left = geometry.into(fake.pose, x, y)
         -- from the chassis' front to the other's side, as far as it sees
         local range = ahead - 0.045 - 0.06
         local sees = somebody and math.abs(left) < 0.05 and range > 0 and range < 0.2
         finder.proximity = sees and range or nothing
         nearest = math.min(nearest, geometry.apart(machine.odometry:pivot(), { x = x, y = y }))
      end
      same('worked', worked, somebody)
      same('kept off', nearest > 0.2, somebody)
   end
end)

-- A robot that stands by on the side of a cache with a block, for so many seconds or until it has something to do; in
-- each step `meanwhile(fake, time)`. When it went to work, s, what it found then, and the robot.
local function stands_by(number, worked, seconds, meanwhile)
   local right = number % 2 == 1 and -1 or 1
   local fake = FakeRobot.new { { x = -0.06, y = right * 0.32 } }
   fake.robot.params = { side = '+x', sides = '+x', standby = tostring(number) }
   local builder = Builder.new(fake.robot, CHART, { sides = { '+x', '-x' }, transport = 4, delay = 30 })
   local machine, done, found = builder.machine, nil, nil
   if worked then builder.sides.is_worked_across = worked end
   machine:start(function()
      builder.standby:stand_by()
      done = machine.process:time()
      found = builder.supply:search_block()
   end)
   while machine.process:time() < seconds and machine:step() do
      fake:step()
      if meanwhile then meanwhile(fake, machine.process:time()) end
   end
   return done, found, fake
end

case('a robot that stands by goes to work where nobody does', function()
   for number = 1, 2 do
      local done, found = stands_by(number, nil, 900)
      same('after a while', done and done > 150 * number and done < 300 * number + 120, true)
      same('the cache', found, 'found')
   end
end)

case('a robot that stands by goes back where somebody works, and waits longer', function()
   local asked = {}
   local done, _, fake = stands_by(1, function(sides)
      table.insert(asked, sides.odometry.time)
      sides.navigation:to(-0.26, 0.08)
      return true
   end, 1000)
   same('asked', #asked, 2)
   same('twice as late', asked[2] - asked[1] > 300, true)
   same('on and on', done, nil)
   same('back', math.abs(fake.pose.x) < 0.06 and math.abs(fake.pose.y) < 0.06, true)
end)

case('a robot that stands by stays as long as blocks are taken', function()
   local asked = 0
   stands_by(1, function() asked = asked + 1 return true end, 1000, function(fake, time)
      fake.blocks[1] = time % 100 > 20 and { x = -0.06, y = -0.32 } or nil
   end)
   same('asked', asked, 0)
end)

case('a robot that is bound to a side takes blocks from there, as long as there are any', function()
   for _, params in ipairs { { side = '+x', sides = '+x' }, { side = '+x' } } do
      local fake = FakeRobot.new { { x = 0.62, y = 0.02 }, { x = -0.3, y = -0.45 } }
      fake.robot.params = params
      local builder = Builder.new(fake.robot, CHART, { sides = { '+x', '-x' }, transport = 4, delay = 30 })
      local supply, map = builder.supply, builder.map
      local wanted = supply:wanted()
      local function is_wanted(x, y)
         return wanted { x = x, y = y, z = SIDE / 2, level = 0, colour = 0, seen = 20 }
      end
      same('ahead, at first', is_wanted(0.62, 0.02), true)
      same('behind', is_wanted(-0.2, 0.5), not params.sides)
      -- it stands on the right of a structure that it faces from +x with the heading pi
      map.known = { x = -0.3, y = 0, reach = 0.03, yaw = math.pi, origin = { x = -0.3, y = 0 } }
      wanted = supply:wanted()
      same('on its side', is_wanted(0.62, 0.02), true)
      same('on another', is_wanted(-0.3, -0.45), not params.sides)
      supply.in_vain = 2
      wanted = supply:wanted()
      same('where there is none', is_wanted(-0.3, -0.45), true)
   end
end)

case('where its cache has no block, a robot that is bound to no side goes to others\' caches', function()
   local task = { transport = 4, sides = ALL, turns = false, levels = 1, asks = {}, delay = 30 }
   for _, bound in ipairs { false, true } do
      local map = map_of({ { 0, 0, 0 } }, { x = 0.3, y = 0, yaw = 0 }, task)
      local supply, looked = Builder.new(FakeRobot.new().robot, CHART, task).supply, {}
      supply.map, supply.in_vain = map, 1
      supply.machine.robot.params.sides = bound and '+x' or nil
      map:remember(map:in_memory())
      map:settle()
      for index, place in pairs { [0] = { -0.2, 0 }, [1] = { 0.3, -0.6 }, [2] = { 0.8, 0 } } do
         map.caches[index] = { along = place[1] - 0.3, left = place[2] }
      end
      map.cache = map:cache_of(0)
      supply.at_cache = function(_, _, tries)
         table.insert(looked, string.format('%.1f %.1f %d', map.cache.x, map.cache.y, tries))
         return #looked == 2 and 'block' or nil
      end
      local own = map.cache
      same('found', supply:at_others_caches(), not bound and 'block' or nil)
      same('the nearest first', table.concat(looked, ', '), bound and '' or '0.3 -0.6 1, 0.8 0.0 1')
      if bound then same('its own', map.cache, own) end
      supply.in_vain = 0
      same('not before it has looked at its own', supply:at_others_caches(), nil)
   end
end)

case('who is alone looks no more once it knows what to do, others look from everywhere', function()
   for _, delay in ipairs { 0, 30 } do
      local task = { transport = 4, sides = ALL, turns = true, levels = 1, asks = {}, delay = delay,
                     looks = { { distance = 0.2, lift = 0.06 }, { distance = 0.14, lift = 0.06 } },
                     decide = function() return { what = 'extend', colour = 1, level = 0 } end }
      local map, machine = map_of({ { 0, 0, 0 } }, { x = 0.3, y = 0, yaw = 0 }, task)
      map:remember(map:in_memory())
      map:settle()
      local work, looks = SiteWork.new(machine, map, nil, { take_turns = function() end }, nil, task), 0
      work.magnets, work.row = { holds = function() return true end }, map:rows()[0]
      work.record = { tell = function() end }
      work.look_from = function(_, column)
         looks = looks + 1
         column:watch()
         return true
      end
      same('decided', work:look(), 'decided')
      same('looks', looks, delay == 0 and 1 or 2)
   end
end)

case('a block without a colour is in a hand where neither it nor one below was ever seen as a brick', function()
   local map = map_of({ { 0, 0, 0 } }, { x = 0.3, y = 0, yaw = 0 }, { transport = 4, sides = ALL, turns = true })
   local function floats(x, level) return map:floats { x = x, y = 0, z = SIDE * (level + 0.5), colour = 0 } end
   same('nothing is known', floats(0.3, 2), false)
   map:remember(map:in_memory())
   map:settle()
   same('over a place with nothing in it', floats(0.3 - SIDE, 2), true)
   same('on a brick', floats(0.3, 1), false)
   same('higher', floats(0.3, 2), true)
   same('on the floor', floats(0.3 - SIDE, 0), false)
   local machine = machine_with { { x = 0.5, y = 0 } }
   machine.placement.floats = function(block) return block.x < 0.3 end
   for x, said in pairs { [0.25] = true, [0.35] = false } do
      machine.tracker.tracks = { { x = x, y = 0, z = 0.138, colour = 0, time = machine.odometry.time } }
      same('held near at ' .. x, machine.placement:held_near(0.3, 0, 0.1) ~= nil, said)
   end
end)

case('a robot with nothing to do looks beside its rows from the lift\'s top, round after round', function()
   local task = { transport = 4, sides = { '+x' }, turns = true, levels = 1, asks = {}, delay = 30,
                  looks = { { distance = 0.2, lift = 0.06 } }, decide = function() end }
   local map, machine = map_of({ { 0, 0, 0 } }, { x = 0.3, y = 0, yaw = 0 }, task)
   map:remember(map:in_memory())
   map:settle()
   local sides = {
      withdraw = function() end, are_fewer = function() end, are_shared = function() end, nearest_other = function() end, take_turns = function() end,
   }
   local work, lifted = SiteWork.new(machine, map, nil, sides, nil, task), {}
   work.magnets, work.record = { holds = function() return true end }, { tell = function() end }
   work.process, work.rest = { wait = function() end }, function() end
   work.lift.to = function(_, height) table.insert(lifted, height) end
   work.look_from = function() return true end
   local flanks = {}
   for round = 1, 8 do
      while work:choose_row() == 'chosen' do
         lifted = {}
         work.tried[work.row.v] = true
         if work.row.flank then
            table.insert(flanks, round .. ':' .. work.row.v .. (work.row.front < 0 and ' farther in' or ''))
            same('nothing', work:look(), 'nothing')
            near('from the top', lifted[#lifted], work.lift:top(), 1e-9)
         end
      end
      work:stays()
   end
   same('from the third round on', table.concat(flanks, ', '),
        '3:1, 3:-1, 4:1, 4:-1, 5:1, 5:-1, 6:1, 6:-1, 7:3 farther in, 7:-3 farther in, 8:6 farther in, 8:-6 farther in')
end)

case('a robot with nothing to do rests ever longer, until it sees a brick that is new', function()
   local task = { transport = 4, sides = { '+x' }, turns = true, levels = 1, asks = {}, delay = 30 }
   local map, machine = map_of({ { 0, 0, 0 } }, { x = 0.4, y = 0, yaw = 0 }, task)
   map:remember(map:in_memory())
   map:settle()
   local shared, stood = false, 0
   local sides = {
      withdraw = function() end, stand_back = function() stood = stood + 1 end, are_shared = function() return shared end,
      are_manned = function() return shared end,
   }
   local work, waits, begun = SiteWork.new(machine, map, nil, sides, nil, task), {}, nil
   local random, rested, looks = math.random, 0, 0
   math.random = function() return 0.5 end  -- luacheck: ignore 122
   work.lift.to = function() end
   local see_along = work.look_along
   work.look_along = function() looks = looks + 1 end
   work.process = {
      wait = function(_, seconds) rested = rested + seconds end,
      wait_until = function(_, until_, seconds)
         machine.odometry.time, rested, begun = machine.odometry.time + seconds, rested + seconds, until_
         return until_()
      end,
   }
   local function stay()
      rested = 0
      same('stays', work:stays(), true)
      table.insert(waits, rested)
   end
   for _ = 1, 6 do stay() end
   same('seconds', table.concat(waits, ' '), '4.0 16.0 64.0 256.0 1024.0 1024.0')
   same('looks along its rows', looks, 1 + 2 + 5 + 2 * 18)
   same('before the middle', stood, 5)
   shared, waits, work.in_vain = true, {}, 0
   work.task.sides = { '+x' }
   for _ = 1, 8 do stay() end
   same('shorter on a shared side', table.concat(waits, ' '), '4.0 8.0 16.0 32.0 64.0 128.0 256.0 256.0')
   same('where it is', stood, 5)
   work.prospects.is_finished, waits, work.in_vain = function() return true end, {}, 0
   stay()
   same('for long at once where every brick of the side stands', table.concat(waits, ' '), '256.0')
   shared = false
   -- asked for five seconds, as it dozes for four of them
   local function notices()
      local seen, naps = false, 0
      for _ = 1, 50 do
         machine.odometry.time = machine.odometry.time + 0.1
         seen, naps = begun() or seen, naps + (machine.dozes and 1 or 0)
      end
      same('naps', naps, 40)
      return seen
   end
   same('nothing new', notices(), false)
   local turns = {}
   work.path = { turn_to = function(_, yaw) table.insert(turns, yaw) end }
   machine.odometry.pose = { x = 0.3, y = 0, yaw = 0 }
   see_along(work, begun)
   same('to both sides and back', #turns, 4)
   near('as far as it has to', turns[1], -math.atan(SIDE, 0.1) + 0.25, 1e-6)
   near('likewise', turns[3], math.atan(SIDE, 0.1) - 0.25, 1e-6)
   machine.odometry.pose, turns = { x = 0, y = 0, yaw = 0 }, {}
   see_along(work, begun)
   same('what is in the picture', #turns, 0)
   table.insert(machine.tracker.tracks, {
      id = 2, x = 0.4 - SIDE, y = 0, z = SIDE / 2, level = 0, yaw = 0, turned = 1e-4, colour = 2, seen = 9, missed = 0,
      time = 0, top_time = 0,
   })
   same('a new brick', notices(), true)
   waits = {}
   table.remove(machine.tracker.tracks)
   work.map.sees_new_brick = function() return function() return true end end
   for _ = 1, 2 do stay() end
   math.random = random  -- luacheck: ignore 122
   same('ends a rest, and the next is a moment', work.in_vain, 1)
end)

case('a block that is never seen in one picture with another is not beside it', function()
   local supply = Builder.new(FakeRobot.new().robot, CHART, { sides = ALL, transport = 4, delay = 0 }).supply
   local function block(id, y, time)
      return { id = id, x = 0.36, y = y, z = SIDE / 2, level = 0, yaw = 0, turned = 1e-4, colour = 0, seen = 20, missed = 0,
               time = time, top_time = time }
   end
   supply.process = { time = function() return 10 end }
   for _, times in ipairs { { 10, 10, false }, { 10, 9, true }, { 9.8, 10, true }, { 8, 9, false } } do
      local known, other = block(1, 0, times[1]), block(2, 0.054, times[2])
      supply.tracker.tracks = { known, other }
      same('unused', supply:is_unused(known), times[3])
   end
end)

case('a block that looks dark where a brick was ever seen, or right beside one, is not unused', function()
   local task = { transport = 4, sides = ALL, turns = false, levels = 1, asks = {}, delay = 0 }
   local map = map_of({ { 0, 0, 0 }, { 1, 0, 0 } }, { x = 0.4, y = 0, yaw = 0 }, task)
   local supply = Builder.new(FakeRobot.new().robot, CHART, task).supply
   same('known', map:remember(map:in_memory()), true)
   supply.map = map
   supply.tracker.tracks = {}
   for _, case_of in ipairs { { 0, 0, false }, { SIDE, 0, false }, { 2 * SIDE, 0, false }, { 4 * SIDE, 0, true } } do
      local x, y = geometry.out_of({ x = 0.4, y = 0, yaw = 0 }, case_of[1], case_of[2])
      local known = { id = 1, x = x, y = y, z = SIDE / 2, level = 0, yaw = 0, turned = 1e-4, colour = 0, seen = 20, missed = 0,
                      time = 0, top_time = 0 }
      same('unused at ' .. case_of[1], supply:is_unused(known), case_of[3])
   end
end)

case('rows are known by heart, and forgotten where nothing is seen of them again', function()
   local task = { transport = 4, sides = { '+x' }, turns = false, levels = 1, asks = {}, delay = 0 }
   local map, machine = map_of({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 2, 1, 0 }, { 2, 2, 0 } },
                               { x = 0.4, y = 0, yaw = 0 }, task)
   map:remember(map:in_memory())
   map:settle()
   same('seen', map:rows()[2].by_heart, false)
   table.remove(machine.tracker.tracks)
   local row = map:rows()[2]
   same('by heart', row.by_heart, true)
   same('as far off as it was', row.front, map:rows()[1].front)
   map:forget_row(row)
   same('forgotten', map:rows()[2], nil)
   same('others are not', map:count_bricks(), 4)
end)

case('a structure all of whose bricks were forgotten is where it was, and one on no level is none', function()
   local task = { transport = 4, sides = { '+x' }, turns = false, levels = 1, asks = {}, delay = 0 }
   local map, machine = map_of({ { 0, 0, 0 } }, { x = 0.4, y = 0, yaw = 0 }, task)
   map:remember(map:in_memory())
   map:settle()
   map:forget_row(map:rows()[0])
   same('none left', map:count_bricks(), 0)
   same('not lost', map:remember(map:in_memory()), true)
   same('remembered again', map:count_bricks(), 1)
   machine.tracker.tracks[1].level = nil
   same('held, or seen badly', map:in_memory(), nil)
end)

case('of a row the foremost counts that is known, though only what is behind it is seen now', function()
   local task = { transport = 4, sides = { '+x' }, turns = false, levels = 1, asks = {}, delay = 0 }
   local map, machine = map_of({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 2, 1, 0 }, { 1, 1, 0 } },
                               { x = 0.4, y = 0, yaw = 0 }, task)
   map:remember(map:in_memory())
   map:settle()
   local before = map:rows()[1]
   same('seen', before.by_heart, false)
   table.remove(machine.tracker.tracks)
   local row = map:rows()[1]
   same('where it was', row.front, before.front)
   same('by heart', row.by_heart, true)
   map:forget_row(row)
   row = map:rows()[1]
   same('the one behind', row.front, before.front - 1)
   same('which is seen', row.by_heart, false)
end)

case('a robot bound to several sides rests once a way round, and goes on', function()
   local task = { transport = 4, sides = { '+x', '+y' }, turns = false, levels = 1, asks = {}, delay = 30 }
   local map, machine = map_of({ { 0, 0, 0 } }, { x = 0.4, y = 0, yaw = 0 }, task)
   map:remember(map:in_memory())
   map:settle()
   local function no() return false end
   local sides = { withdraw = function() end, are_shared = no, are_manned = no }
   local work, rests = SiteWork.new(machine, map, nil, sides, nil, task), 0
   work.rest = function() rests = rests + 1 end
   for _ = 1, 6 do same('to the next side', work:stays(), false) end
   same('rests', rests, 3)
   same('rounds', work:idle_rounds(), 3)
end)

case('a robot waits longer each time that it meets others, but not for ever', function()
   local builder = Builder.new(FakeRobot.new().robot, CHART, { sides = ALL, transport = 4, delay = 32 })
   local random, waited = math.random, {}
   math.random = function() return 1 end  -- luacheck: ignore 122
   builder.process.wait = function(_, seconds) table.insert(waited, seconds) end
   for met = 0, 5 do
      builder.work.obstructed = met
      same('done', builder:wait(), 'done')
   end
   math.random = random  -- luacheck: ignore 122
   same('seconds', table.concat(waited, ' '), '4.0 8.0 16.0 32 32 32')
   -- who has left a site to another waits for that one's brick, once
   local longest = {}
   builder.process.wait_until = function(_, _, seconds) table.insert(longest, seconds) end
   builder.work.yielded = true
   for _ = 1, 2 do builder:wait() end
   same('once', table.concat(longest, ' '), '15')
   -- robots that would not feel each other at a corner do not all come when they see it
   builder.machine.description.rangefinders.front.range, builder.work.yielded = 0.05, true
   builder:wait()
   same('by chance alone', #longest, 1)
   same('and only then', builder.work.yielded, false)
end)

case('states that take no time follow each other in one step, unless they come again', function()
   local chart = {
      first = 'wait',
      wait = { does = 'wait', on = { done = 'next side' } },
      ['next side'] = { does = 'next_side', on = { there = 'let go' } },
      ['let go'] = { does = 'let_go', on = { done = 'wait' } },
   }
   local fake = FakeRobot.new()
   local builder = Builder.new(fake.robot, chart, { sides = ALL, transport = 4, delay = 0 })
   local done = {}
   builder.wait = function() table.insert(done, 'w') return 'done' end
   builder.next_side = function() table.insert(done, 'n') return 'there' end
   builder.let_go = function() table.insert(done, 'l') return 'done' end
   for _ = 1, 2 do
      builder:step()
      fake:step()
   end
   same('twice round', table.concat(done), 'wnlwnl')
end)

case('a search stands before a block in transport until it is known to lie there', function()
   local fake = FakeRobot.new { { x = 0.32, y = 0.1, colour = 4 } }
   fake.robot.params = {}
   local builder = Builder.new(fake.robot, CHART, { sides = { '+x' }, transport = 4, delay = 0 })
   local machine, supply, found = builder.machine, builder.supply, nil
   local function is_unused(known) return supply:is_unused(known) end
   machine:start(function()
      machine.lift:to(0.08)
      found = machine.search:look_round(function() return machine.tracker:recall(is_unused, 1) end)
   end)
   for _ = 1, 500 do
      if not machine:step() then break end
      fake:step()
   end
   same('found in one turn', found and found.colour, 4)
   same('seen for long', found and found.seen >= 15, true)
end)

case('each state of the chart is something that a part does', function()
   local builder = Builder.new(FakeRobot.new().robot, CHART, { sides = ALL, transport = 4, delay = 0 })
   for does, part in pairs(Builder.BEHAVIOURS) do
      same(does, type(builder[part][does]), 'function')
   end
end)

case('a place on the third level is gone to by a brick that is seen from afar', function()
   local work = Builder.new(FakeRobot.new().robot, CHART, { sides = ALL, transport = 4, delay = 0 }).work
   local feet = {}
   for level = 2, 0, -1 do table.insert(feet, { level = level, z = geometry.SIDE * (level + 0.5) }) end
   local function guide(known, next_to, top)
      return work:guide_of { what = 'extend', feet = known, next_to = next_to or {}, top = top }
   end
   same('level', guide(feet).level, 1)
   table.remove(feet, 1)
   same('level below', guide(feet).level, 1)
   local high = { { z = 0.1375 } }
   same('only the high one is known', guide(high).z, 0.1375)
   same('none is known', guide({}, {}, 'top'), 'top')
   local brick, where, left = guide(high, { { brick = feet[1], left = -1 } })
   same('a brick to the right of the site', brick.level, 1)
   same('beside it', where, 'beside')
   same('to its left', left, geometry.SIDE)
   same('a tower goes by its top', work:guide_of { what = 'raise', feet = feet, top = 'top' }, 'top')
end)

case('a column of two with one in front is built', function()
   local function decide(column)
      if column.top_level == 0 and column.top_colour == 3 then return { what = 'raise', colour = 2, branch = 1 } end
      if column.top_level == 1 then return { what = 'extend', colour = 1, level = 0, branch = 2 } end
   end
   local task = {
      decide = decide, asks = {}, sides = { '+x' }, turns = false, levels = 2, transport = 4, delay = 0,
      looks = { { distance = 0.200, lift = 0.0822 }, { distance = 0.140, lift = 0.1360 } },
   }
   local fake = FakeRobot.new { { x = -0.20, y = 0, colour = 3 }, { x = 0.35, y = 0.02, yaw = 0.4 } }
   local shown = { chart = {}, branch = {}, told = {}, state = {} }
   fake.robot.show = { number = function() end, text = function(name, text) table.insert(shown[name], text) end }
   local builder = Builder.new(fake.robot, CHART, task)
   for _ = 1, 5000 do
      builder:step()
      fake:step()
      -- the cache is filled again
      if fake.held and #fake.blocks == 2 then table.insert(fake.blocks, { x = 0.36, y = -0.01 }) end
      if builder.record.placed == 2 then break end
   end
   same('placed', builder.record.placed, 2)
   same('aborted', builder.record.aborted, 0)
   same('branches', table.concat(shown.branch, ' '), '1 2')
   same('told', table.concat(shown.told, ' '), 'top Q3, level 0 top Q2, level 1')
   same('first in the chart', shown.chart[1], CHART.first)
   -- what follows a brick follows it in the same step
   same('last in the chart', table.concat(shown.chart, ', ', #shown.chart - 1), 'attach, search block')
   local second, third = fake.blocks[2], fake.blocks[3]
   same('level', second.level, 1)
   same('colour', second.colour, 2)
   near('x', second.x, -0.20, 2e-3)
   same('in front', third.level, 0)
   same('its colour', third.colour, 1)
   near('its x', third.x, -0.20 + 0.056, 2e-3)
   near('its y', third.y, 0, 2e-3)
end)

case('one that is alone searches for a block that it has lost, rather than wait for the next', function()
   local fake = FakeRobot.new {}
   local task = { sides = ALL, turns = true, transport = 4, delay = 0 }
   local builder = Builder.new(fake.robot, CHART, task)
   local supply, magnets = builder.supply, builder.machine.magnets
   local waited, searched = 0, 0
   supply.at_cache = function(_, time)
      waited = waited + time
      return nil
   end
   supply.machine.search.look_about = function() return nil end
   supply.machine.search.find = function()
      searched = searched + 1
      return nil
   end
   supply.navigation.straight_to = function() end
   supply.map.cache = { x = 0.4, y = 0 }
   local seen = true
   magnets.ranges = { underneath_within = function() return seen end }
   local function searches()
      waited, searched, supply.in_vain = 0, 0, 0
      builder.machine:start(function() supply:search_block() end)
      for _ = 1, 200 do
         if not builder.machine:step() then break end
         fake:step()
      end
      return searched
   end
   same('lifted', magnets:has_lifted(), true)
   same('waits for the next one', searches(), 0)
   assert(waited > 5, waited)
   seen = false
   same('fallen', magnets:holds(), false)
   same('searches', searches(), 1)
   near('a look at the cache', waited, 1, 1e-9)
   supply.task.delay = 30
   same('not among others', searches(), 0)
   seen = true
   magnets:has_lifted()
   same('found', magnets.lost, false)
end)

case('after a search in vain a robot takes a brick that lies where no structure can be', function()
   local fake = FakeRobot.new {}
   local task = { sides = ALL, turns = true, transport = 4, delay = 0, starts = { 3 } }
   local supply = Builder.new(fake.robot, CHART, task).supply
   local function brick(id, x, y, colour)
      return { id = id, x = x, y = y, z = SIDE / 2, level = 0, yaw = 0, turned = 1e-4, colour = colour, seen = 20, missed = 0,
               first = 0, time = 0, top_time = -1 }
   end
   local lost = brick(1, 0.4, 0, 1)
   local tracks = { lost, brick(2, 0.3, 0.3, 3) }
   supply.tracker.tracks = tracks
   same('not at first', supply:is_lost(lost), false)
   supply.in_vain = 1
   same('then', supply:is_lost(lost), true)
   same('one with which structures begin', supply:is_lost(tracks[2]), false)
   tracks[3] = brick(3, 0.4, 0.07, 2)
   same('one beside another', supply:is_lost(lost), false)
   tracks[3].colour, lost.first = 1, 1
   same('where it was itself before it was pushed', supply:is_lost(lost), true)
   tracks[3].time = 1
   same('beside its like', supply:is_lost(lost), false)
   tracks[3] = nil
   supply.map.room_about = function() return 0.1 end
   same('one near the structure', supply:is_lost(lost), false)
   supply.map.room_about, lost.seen = function() return 0.3 end, 9
   same('one that was hardly seen', supply:is_lost(lost), false)
   same('of rules that do not say how they begin', (function()
      task.starts, lost.seen = nil, 20
      return supply:is_lost(lost)
   end)(), false)
end)

case('a lone brick of a colour that none begins with is no structure where another is seen', function()
   local task = { sides = ALL, turns = true, transport = 4, starts = { 3 } }
   local map, machine = map_of({ { 0, 0, 0, colour = 1 }, { -9, 0, 0, colour = 3 } }, { x = 0.3, y = 0, yaw = 0 }, task)
   local tracks = machine.tracker.tracks
   same('the farther one', map:in_memory().blocks[1].colour, 3)
   same('of the structure', map:is_of_structure(tracks[2]), true)
   same('not of it', map:is_of_structure(tracks[1]), false)
   tracks[2].x = tracks[1].x + SIDE
   same('both', #map:in_memory().blocks, 2)
   same('beside a brick', map:is_of_structure(tracks[1]), true)
   table.remove(tracks)
   same('for want of another', map:in_memory().blocks[1].colour, 1)
end)

-- A robot at a structure of these blocks, before the column of its middle row: work, column, machine.
local function before_column(blocks, task)
   local map, machine = map_of(blocks, { x = 0.3, y = 0, yaw = 0 }, task)
   map:remember(map:in_memory())
   map:settle()
   local work = SiteWork.new(machine, map, nil, nil, nil, task)
   work.placement = { reaches = function() return true end }
   work.row = map:rows()[0]
   return work, Column.new(machine.odometry, machine.tracker, machine.sight, map, task, work.row), machine
end

case('a brick of a wrong colour before the robot is coloured when it has been so for a while', function()
   local task = { transport = 4, sides = ALL, turns = true, delay = 0, levels = 2, asks = {}, starts = { 3 },
                  structure = { { 0, 0, 0, 3 }, { 1, 0, 0, 2 }, { 2, 0, 0, 1 } } }
   local work, column, machine = before_column({ { 0, 0, 0, colour = 4 }, { 1, 0, 0, colour = 2 }, { 2, 0, 0, colour = 3 } }, task)
   for _, known in ipairs(machine.tracker.tracks) do
      known.seen, known.colour = 30, known.id == 1 and 0 or known.colour
      column:note(known)
   end
   local fault = work:fault_seen_at(column)
   same('its colour', fault.right, 1)
   same('the one before the robot', fault.block.id, 1)
   same('not at once', work:see_to_faults(column), nil)
   machine.odometry.time = machine.odometry.time + 20
   same('then', work:see_to_faults(column), 'faulty')
   same('what it is told', work.wish.mends, 1)
   same('it is in no robot\'s hand', work.placement.spared, 1)
   for _ = 1, 3 do
      same('again', work:see_to_faults(column), 'faulty')
      work.placement.recolour_below = function() return true end
      work.record, work.leave = { tally = function() end }, function() end
      work.magnets = { holds = function() return true end }
      same('coloured', work:recolour(), 'done')
      work:see_to_faults(column)
      machine.odometry.time = machine.odometry.time + 20
   end
   same('not for ever', work:see_to_faults(column), nil)
   work.mended = {}
   table.insert(machine.tracker.tracks, { id = 9, x = 0.3, y = SIDE, z = 1.5 * SIDE, level = 1, yaw = 0, turned = 1e-4, colour = 2,
                                          seen = 30, missed = 0, time = 0, top_time = -1 })
   same('not beside a higher one', work:mending_of(column, fault), nil)
end)

case('a brick of a wrong colour under another is coloured by way of that one', function()
   local task = { transport = 4, sides = ALL, turns = true, delay = 0, levels = 2, asks = {}, starts = { 3 },
                  structure = { { 0, 0, 0, 3 }, { 0, 0, 1, 3 }, { 1, 0, 0, 2 }, { 1, 0, 1, 2 }, { 2, 0, 0, 1 } } }
   local work, column, machine = before_column({ { 0, 0, 0, colour = 1 }, { 0, 0, 1, colour = 2 }, { 1, 0, 0, colour = 3 } }, task)
   for _, known in ipairs(machine.tracker.tracks) do
      known.seen = 30
      column:note(known)
   end
   local fault = work:fault_seen_at(column)
   same('the lower one', fault and fault.level, 0)
   same('its colour', fault.right, 2)
   local wish = work:mending_of(column, fault)
   same('over the upper one', wish.top.level, 1)
   work.wish = wish
   local told
   work.placement.recolour_below = function(_, colour, blocks)
      told = colour .. ' ' .. blocks
      return true
   end
   work.record, work.leave = { tally = function() end }, function() end
   work.magnets = { holds = function() return true end }
   same('coloured', work:recolour(), 'done')
   same('two blocks below', told, '2 2')
   column.bricks[column:key(0, 0, 1)] = nil
   machine.tracker.recall = function() return {} end
   same('not where the upper one is out of sight', work:mending_of(column, fault), nil)
end)

case('a fault is seen by what is shown alone where memory has another', function()
   local task = { transport = 4, sides = ALL, turns = true, delay = 0, levels = 2, asks = {}, starts = { 3 },
                  structure = { { 0, 0, 0, 3 }, { 0, 0, 1, 4 }, { 1, 0, 0, 2 }, { 2, 0, 0, 1 }, { 0, 1, 0, 2 } } }
   local map, machine = map_of({ { 0, 0, 0, colour = 3 }, { 0, 0, 1, colour = 4 }, { 1, 0, 0, colour = 2 }, { 2, 0, 0, colour = 3 } },
                               { x = 0.3, y = 0, yaw = 0 }, task)
   map:remember(map:in_memory())
   map:settle()
   local work = SiteWork.new(machine, map, nil, nil, nil, task)
   local shown = {}
   for _, known in ipairs(machine.tracker.tracks) do
      local u, v = map:cell_of(known.x, known.y)
      table.insert(shown, { u = u, v = v, level = known.level, colour = known.colour, block = known })
   end
   local column = { shown = function() return shown end }
   same('one fault', work:fault_seen_at(column).right, 1)
   map.bricks_with = function(_, seen)
      local out = { { u = seen[1].u, v = seen[1].v + 1, level = 0, colour = 4 } }
      return table.move(seen, 1, #seen, 2, out)
   end
   same('with a stale one', work:fault_seen_at(column).right, 1)
end)
