-- SPDX-License-Identifier: MIT
-- What a robot that builds does: fetches blocks that nobody uses, looks at the structure from
-- one of its sides, asks what to do there, and does it.
--
-- `stigc compile` writes the two things that are not here: a chart, which says what follows what,
-- and a task, which says what the rules want:
--
--     task.decide(column)  what to do before a column: {what, colour, level, left, rule}, or nil
--     task.asks            cells that it asks for: {du, dv, level} about the column
--     task.looks           where to look from: {distance from camera to column, height of the lift}
--     task.sides           sides to work from, '+x' ...; task.turns: the rules hold in every turn
--     task.transport       colour of a block on its way (0: dark)
--     task.delay           s, the longest random wait before a site is approached; 0: there is but one robot
--
-- A scene may bind a robot to some of the sides: see `sides`.

local robotics = require 'robotics'
local avoidance = require 'avoidance'
local handling = require 'handling'
local lattice = require 'lattice'
local travel = require 'travel'
local sides = require 'sides'
local column = require 'column'
local building = {}

local SIDE = robotics.SIDE
local OFTEN = 3                -- sightings that count
local LOOK_TIME = 1.0          -- s, for each look
local FIRST_LOOK = 2.5         -- s, for one at blocks not seen before
local STILL = 15               -- sightings after which a block in transport is one that was dropped
local LEGS = 12                -- of a search, before it begins again where something is known; then more
local LINKED = 1.25 * SIDE
local PEEK_FROM, PEEK = 0.17, 0.8  -- m from a site, rad to each side
local PEEK_OVER = 0.035        -- m, of the lift, to see over the column ahead
local AT_SITE = 0.22           -- m, from a site, where others are in the way
local OF_ONE, GOES = 0.03, 25  -- m, s: what is seen there again after so long stands for good
local BUSY = 10                -- s, the longest wait where another robot is at a row
local OBSTRUCTED = 6           -- a robot that was obstructed more often goes to another side
local ROUNDS = 3               -- likewise one that found nothing to do so often, before its first brick
local AT_WORK = 0.12           -- m, from the structure, that blocks in others' hands are counted

local task
local in_vain      -- searches for a block, one after the other
local last_cache   -- that of the side before, until a block was seen at this side's
local block        -- unused, to be fetched
local tried        -- rows of this side that asked for nothing
local rounds       -- how often all rows of this side were tried, likewise
local patience     -- how often it tries them before it goes elsewhere: once, and twice as often each time
local obstructed   -- how often somebody was in the way, or nothing to be done, since the last block
local standing     -- what stands near sites, and may be robots: {x, y, since}
local row          -- {v, front, frame, juts}: the one it stands before
local wish         -- what task.decide said

local function note(name, value)
   if robot.show then robot.show.number(name, value) end
end

local function tally(name)
   building[name] = building[name] + 1
   note(name, building[name])
end

-- Another robot was in the way.
local function give_up()
   obstructed = obstructed + 1
   tally('aborted')
   tally('busy')
end

-- Blocks -------------------------------------------------------------------------------------

-- Dark, or dropped by a robot; on the floor, and with nothing beside it.
local function is_unused(known)
   local dropped = task.transport > 0 and known.colour == task.transport and known.seen >= STILL
   if known.colour ~= 0 and not dropped or known.level ~= 0 or known.seen < 2 * OFTEN then
      return false
   end
   for _, other in ipairs(robotics.blocks()) do
      if other ~= known and lattice.apart(other, known) < LINKED and math.abs(other.z - known.z) < LINKED
      then return false end
   end
   return true
end

local does = {}
building.does = does

function does.wait()
   handling.wait(math.random() * task.delay)
   return 'done'
end

-- Where the last one came from, then all about; an empty cache is filled after a while.
function does.search_block()
   local function seen()
      for _, known in ipairs(robotics.blocks()) do
         if is_unused(known) and robotics.time - known.time < 1 then return true end
      end
   end
   for again = 1, lattice.cache and 3 or 0 do
      if again > 1 then handling.wait(5 + 10 * math.random()) end
      local sure = last_cache and FIRST_LOOK or LOOK_TIME
      block = travel.look_again(lattice.cache, seen, sure) and handling.recall(is_unused)
      if not block and last_cache then
         lattice.cache = last_cache
         block = travel.look_again(lattice.cache, seen) and handling.recall(is_unused)
      end
      last_cache = nil
      block = block or handling.look_about(is_unused)
      if block then return 'found' end
   end
   -- elsewhere it would be in others' way
   if robot.params.sides or sides.are_shared() and lattice.cache then
      block = not lattice.cache and handling.look_about(is_unused) or nil
      if not block then handling.wait(5 + 10 * math.random()) end
      return block and 'found' or 'none'
   end
   in_vain = in_vain + 1
   block = handling.search(is_unused, LEGS * in_vain, travel.wander)
   if block then return 'found' end
   local home = lattice.cache or lattice.known or { x = 0, y = 0 }
   travel.straight_to(home.x, home.y)
   return 'none'
end

function does.approach_block()
   local near, seen = handling.approach_block(block)
   if near then block = seen return 'near' end
   tally('aborted')
   return 'lost'
end

function does.pick_up()
   local place, fresh = { x = block.x, y = block.y }, block.colour == 0
   if handling.grip_block(block, task.transport) then
      lattice.side, in_vain = nil, 0
      if fresh then lattice.cache = place end
      handling.back_off(0.10)
      return 'holds'
   end
   tally('aborted')
   handling.back_off(0.12)
   return 'failed'
end

-- Sites --------------------------------------------------------------------------------------

function does.search_structure()
   if not handling.holds() then return 'dropped' end
   local found = lattice.in_memory()
   if not found and lattice.known then
      travel.look_again(lattice.known, lattice.in_memory)
      found = lattice.in_memory()
   end
   if not found then
      if not handling.search(lattice.is_brick, LEGS, travel.wander) then
         travel.straight_to(0, 0)
         return 'none'
      end
      handling.wait(LOOK_TIME)
      found = lattice.in_memory(true)
   end
   if not found then return 'none' end
   if not lattice.remember(found) then return 'lost' end
   if lattice.settle() then tried = {} end
   return 'found'
end

-- Lost: where blocks come from tells the directions.
function does.find_cache()
   local function comes_from_there(known) return known.colour == 0 and is_unused(known) end
   local known = handling.search(comes_from_there, LEGS, travel.wander)
   if not known then return 'none' end
   lattice.cache = { x = known.x, y = known.y }
   return 'found'
end

-- The row, of those not tried yet, that juts out furthest; of several the one straight ahead, which
-- keeps robots apart that work from several sides.
function does.choose_row()
   if not handling.holds() then return 'dropped' end
   if obstructed > OBSTRUCTED and #task.sides > 1 then return 'none' end
   local rows = lattice.rows()
   if not rows then return 'lost' end
   row = nil
   local least
   for _, of in pairs(rows) do
      if not tried[of.v] and lattice.room_before(rows, of) then
         local _, aside = handling.on_line(column.line_before(of))
         local order = math.abs(aside) - of.front
         if not row or order < least then row, least = of, order end
      end
   end
   return row and 'chosen' or 'none'
end

-- All rows were tried, or somebody was in the way once too often. Others' work may open a row
-- here after a while.
function does.next_side()
   tried, rounds = {}, rounds + 1
   sides.withdraw()
   if #task.sides == 1 or sides.are_shared() and obstructed <= OBSTRUCTED and rounds < patience then
      handling.wait(2 + 4 * math.random())
      return 'there'
   end
   obstructed, rounds, patience = 0, 0, 2 * patience
   local cache = lattice.cache
   if sides.change() then last_cache = cache end
   -- what was seen before the turns on the way does not fit what is seen now
   robotics.tracks = {}
   if travel.look_again(lattice.known, lattice.in_memory) then return 'there' end
   return 'lost'
end

-- Says whether another robot stands before the row, on the way in along a line.
local function in_between(line)
   return function() return handling.between(-handling.on_line(line)) end
end

-- Another robot is at the row: out of its way, and another try after a while.
local function give_up_row()
   handling.back_off(0.10)
   handling.wait(BUSY * math.random())
   give_up()
   return 'blocked'
end

function does.stand_before()
   local line = column.line_before(row)
   -- where what juts out beside is not swept in a turn
   local away = column.distance_for(task.looks[1]) + row.juts
   local along, aside = handling.on_line(line)
   if math.abs(aside) > 0.015 or along > -away + 0.01 or along < -away - 0.20 or
      math.abs(robotics.wrap(robotics.pose.yaw - line.yaw)) > 0.5 then
      handling.lift_to(math.max(robot.lift_system.position, 0.070))
      local x, y = robotics.out_of(line, -away - 0.03, 0)
      -- where there is room to turn before the cache
      if lattice.cache and lattice.apart(lattice.cache, { x = x, y = y }) < travel.BEFORE_CACHE then
         x, y = robotics.out_of(line, -away, 0)
      end
      if not travel.to(x, y) then
         give_up()
         return 'blocked'
      end
   end
   handling.turn_to(line.yaw)
   handling.follow(line, -away, 0.10, in_between(line))
   if handling.between(-handling.on_line(line)) then return give_up_row() end
   return 'there'
end

function does.look()
   local seen = { task = task, row = row, bricks = {}, empty = {} }
   for _, look in ipairs(task.looks) do
      local line = column.line_before(seen.row)
      handling.follow(line, -column.distance_for(look), 0.08, in_between(line))
      if handling.between(-handling.on_line(line)) then
         handling.back_off(0.10)
         tried[row.v] = true
         give_up()
         return 'unseen'
      end
      handling.lift_to(look.lift)
      local start = robotics.time
      while robotics.time - start < LOOK_TIME do
         coroutine.yield()
         column.watch(seen)
      end
   end
   row, seen.top = seen.row, column.top(seen)
   if not handling.holds() then return 'dropped' end
   wish = task.decide {
      top_colour = seen.top and seen.top.colour, top_level = seen.top and seen.top.level,
      side = lattice.side_name(),
      cell = function(du, dv, level) return column.cell(seen, du, dv, level) end,
   }
   if not wish then
      tried[row.v] = true
      if row.juts > 0 then handling.back_off(row.juts) end
      if seen.top then return 'nothing' end
      tally('aborted')
      return 'unseen'
   end
   wish.top = column.highest(seen)
   wish.foot = seen.bricks['0 0 ' .. (wish.level or 0)]
   wish.aside = column.room_beside(seen, wish)
   return 'decided'
end

-- Whether a point is no part of what stands there for good: robots leave after a while.
local function comes_and_goes(point)
   for _, known in ipairs(standing) do
      if lattice.apart(known, point) < OF_ONE then return robotics.time - known.since < GOES end
   end
   table.insert(standing, { x = point.x, y = point.y, since = robotics.time })
   return true
end

-- Whether no other robot is at work about the end of a line, as a look to both sides tells.
-- Who passes here stays nearer than PEEK_FROM until it has put its block down, where the others
-- see it from the places from which they look in their turn: of two robots at work on adjoining
-- sides, the one that looks last sees the other. On the far side one hides behind the column: what
-- it holds is seen over that.
local function is_alone(line)
   handling.follow(line, -PEEK_FROM, 0.08, handling.backed)
   local start, before = robotics.time, robot.lift_system.position
   local function held()
      return handling.held_near(lattice.known.x, lattice.known.y, lattice.known.reach + AT_WORK)
   end
   handling.lift_to(robotics.clamp(before + PEEK_OVER, 0, robotics.profile.lift_top - 0.0015))
   local busy = handling.wait_until(held, 0.6)
   for _, angle in ipairs { -PEEK, PEEK, 0 } do
      local turn = robotics.wrap(line.yaw + angle - robotics.pose.yaw)
      if not busy and not avoidance.sweeps(turn) then handling.turn_to(line.yaw + angle, avoidance.LOOK_RIM) end
      busy = busy or held()
   end
   handling.turn_to(line.yaw)
   for _, point in ipairs(avoidance.strangers(line.x, line.y, AT_SITE, start)) do
      busy = busy or comes_and_goes(point)
   end
   return not busy
end

function does.approach_site()
   local where, target = wish.what, wish.top
   if where ~= 'raise' then target = wish.foot or wish.top end
   local near, seen = handling.approach_site(target, where, {
      heading = row.frame.yaw, level = wish.level, left = wish.left and wish.left * SIDE,
      aside = wish.aside, alone = task.delay > 0 and is_alone or nil,
   })
   if near then return 'near' end
   if seen == 'busy' then
      sides.withdraw()
      give_up()
      return 'busy'
   end
   tally('aborted')
   return seen == 'the block was lost' and 'dropped' or 'lost'
end

function does.attach()
   if not handling.attach(wish.what, wish.colour) then
      tally('aborted')
      return 'failed'
   end
   if row.juts > 0 then handling.back_off(row.juts) end
   tried, wish, obstructed, rounds, patience = {}, nil, 0, 0, 1
   tally('placed')
   return 'placed'
end

function does.let_go()
   handling.let_go()
   handling.back_off(0.15)
   return 'done'
end

-- Life ----------------------------------------------------------------------------------------

-- Follows the chart for ever: each of its states is something done, which ends with an event, and
-- the chart says which state that leads to.
function building.start(chart, with)
   task = setmetatable({ sides = sides.own(with) }, { __index = with })
   lattice.start(task)
   sides.start(task)
   handling.transport = task.transport
   block, tried, row, wish, standing = nil, {}, nil, nil, {}
   in_vain, obstructed, rounds, patience, last_cache = 0, 0, 0, ROUNDS, nil
   building.placed, building.aborted, building.busy = 0, 0, 0
   note('placed', 0)
   handling.start(function()
      local state = chart.first
      while true do
         handling.enter(state)
         local event = does[chart[state].does]()
         state = chart[state].on[event] or
                 error("the chart says nothing of '" .. event .. "' in '" .. state .. "'")
         coroutine.yield()
      end
   end, task.profile)
end

function building.step()
   handling.step()
end

return building
