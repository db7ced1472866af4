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
--     task.delay           s, the longest random wait before a site is approached

local robotics = require 'robotics'
local handling = require 'handling'
local lattice = require 'lattice'
local travel = require 'travel'
local column = require 'column'
local building = {}

local SIDE = robotics.SIDE
local OFTEN = 3                -- sightings that count
local LOOK_TIME = 1.0          -- s, for each look
local STILL = 15               -- sightings after which a block in transport is one that was dropped
local LEGS = 12                -- of a search, before it begins again where something is known; then more
local LINKED = 1.25 * SIDE
local PEEK_FROM, PEEK = 0.20, 0.5  -- m from a column, rad to each side
local BUSY = 10                -- s, the longest wait where another robot is at a row
local STAY = 0.75              -- probability to try a side again before going to the next
local AT_WORK = 0.12           -- m, from the structure, that blocks in others' hands are counted

local task
local in_vain      -- searches for a block, one after the other
local block        -- unused, to be fetched
local tried        -- rows of this side that asked for nothing
local row          -- {v, front, frame}: the one it stands before
local wish         -- what task.decide said

local function note(name, value)
   if robot.show then robot.show.number(name, value) end
end

local function tally(name)
   building[name] = building[name] + 1
   note(name, building[name])
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
      block = travel.look_again(lattice.cache, seen) and handling.recall(is_unused) or
              handling.look_about(is_unused)
      if block then return 'found' end
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
      found = lattice.in_memory()
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

-- A row that was not tried yet, at random.
function does.choose_row()
   if not handling.holds() then return 'dropped' end
   local rows = lattice.rows()
   if not rows then return 'lost' end
   local open = {}
   for _, of in pairs(rows) do
      if not tried[of.v] and lattice.room_before(rows, of) then table.insert(open, of) end
   end
   if #open == 0 then return 'none' end
   row = open[math.random(#open)]
   return 'chosen'
end

-- All rows were tried: to the next side, or after a while again from this one.
function does.next_side()
   tried = {}
   -- others' work may open a row here, and who changes sides is in somebody's way
   if #task.sides == 1 or math.random() < STAY then
      handling.wait(2 + 4 * math.random())
      return 'there'
   end
   local here = 1
   for i, name in ipairs(task.sides) do
      if lattice.SIDES[name] == lattice.side then here = i end
   end
   lattice.side = lattice.SIDES[task.sides[here % #task.sides + 1]]
   local heading, middle = lattice.heading_of(lattice.side), lattice.known
   local away = middle.reach + travel.CLEAR_OF
   travel.to(middle.x - away * math.cos(heading), middle.y - away * math.sin(heading))
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
   tally('aborted')
   tally('busy')
   return 'blocked'
end

function does.stand_before()
   local line = column.line_before(row)
   local away = column.distance_for(task.looks[1])
   local along, aside = handling.on_line(line)
   if math.abs(aside) > 0.015 or along > -away + 0.01 or along < -away - 0.20 or
      math.abs(robotics.wrap(robotics.pose.yaw - line.yaw)) > 0.5 then
      handling.lift_to(math.max(robot.lift_system.position, 0.070))
      if not travel.to(robotics.out_of(line, -away - 0.03, 0)) then
         tally('aborted')
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
         tally('aborted')
         tally('busy')
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
      cell = function(du, dv, level) return column.cell(seen, du, dv, level) end,
   }
   if not wish then
      tried[row.v] = true
      if seen.top then return 'nothing' end
      tally('aborted')
      return 'unseen'
   end
   wish.top = column.highest(seen)
   wish.foot = seen.bricks['0 0 ' .. (wish.level or 0)]
   wish.aside = column.room_beside(seen, wish)
   return 'decided'
end

-- Whether another robot is at work at the structure, as a look to both sides tells: the camera
-- sees what it holds from PEEK_FROM, and nobody sees what comes from beside while it looks ahead.
local function others_at_work()
   local line = column.line_before(row)
   handling.follow(line, -PEEK_FROM, 0.08, handling.backed)
   handling.lift_to(robotics.profile.lift_top - 0.0015)
   local busy = false
   local function held()
      return handling.held_near(lattice.known.x, lattice.known.y, lattice.known.reach + AT_WORK)
   end
   for _, angle in ipairs { -PEEK, PEEK } do
      handling.turn_to(line.yaw + angle)
      busy = busy or handling.wait_until(held, 0.6)
   end
   handling.turn_to(line.yaw)
   return busy
end

function does.approach_site()
   if task.delay > 0 and others_at_work() then
      handling.back_off(0.12)
      tally('aborted')
      tally('busy')
      return 'busy'
   end
   local where, target = wish.what, wish.top
   if where ~= 'raise' then target = wish.foot or wish.top end
   local near, seen = handling.approach_site(target, where, {
      heading = row.frame.yaw, level = wish.level, left = wish.left and wish.left * SIDE,
      aside = wish.aside,
   })
   if near then return 'near' end
   tally('aborted')
   if seen == 'busy' then tally('busy') end
   return seen == 'busy' and 'busy' or seen == 'the block was lost' and 'dropped' or 'lost'
end

function does.attach()
   if not handling.attach(wish.what, wish.colour) then
      tally('aborted')
      return 'failed'
   end
   tried, wish = {}, nil
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
   task = with
   lattice.start(task)
   handling.transport = task.transport
   block, tried, row, wish, in_vain = nil, {}, nil, nil, 0
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
