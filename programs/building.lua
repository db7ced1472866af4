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
--
-- A side's name tells nothing to a robot that has no compass. `params.side` is the side on which it
-- finds itself when it first sees the structure; from then on it knows the lattice's directions
-- by its own turns, put right by a few degrees whenever it sees the structure again.

local robotics = require 'robotics'
local handling = require 'handling'
local building = { placed = 0, aborted = 0, busy = 0 }

local SIDE = robotics.SIDE
local wrap, wrap_quarter = robotics.wrap, robotics.wrap_quarter
local OFTEN = 3                -- sightings that count
local LOOK_TIME = 1.0          -- s, for each look
local LINKED = 1.25 * SIDE
local FAR_LINKED = 2.3 * SIDE
local CLEAR_OF = 0.24          -- m, from the outermost brick, to go round the structure
local TOO_NEAR = 0.135         -- of a way past a brick
local FAR_LOOK = 0.36          -- m, from a remembered place, to look at it from
local SIDES = { ['+x'] = 0, ['+y'] = 1, ['-x'] = 2, ['-y'] = 3 }

local task
local lattice      -- {x, y, reach, yaw, origin}: middle and radius of the structure as last seen,
                   -- the heading that faces it from params.side, and the middle of one cell
local cache        -- {x, y}: where the last block came from
local block        -- unused, to be fetched
local side         -- index of the side that it works from
local tried        -- rows of this side that asked for nothing
local row          -- {v, bricks, front}: the one it stands before
local wish         -- what task.decide said

local function note(name, value)
   if robot.show then robot.show.number(name, value) end
end

local function tally(name)
   building[name] = building[name] + 1
   note(name, building[name])
end

-- The structure ------------------------------------------------------------------------------

local function is_brick(known)
   return known.colour > 0 and known.colour ~= task.transport
end

-- The largest structure of bricks, of what is known. Some of its bricks may be out of sight, and
-- those known not be linked.
local function structure_in_memory()
   local best
   for _, structure in ipairs(robotics.structures(is_brick, FAR_LINKED)) do
      if not best or #structure.blocks > #best.blocks then best = structure end
   end
   return best
end

-- Learns where the structure is, and how the lattice lies.
local function remember(structure)
   local x, y, n = 0, 0, 0
   for _, known in ipairs(structure.blocks) do x, y, n = x + known.x, y + known.y, n + 1 end
   x, y = x / n, y / n
   local yaw = structure.frame.yaw
   if lattice then
      yaw = lattice.yaw + wrap_quarter(yaw - lattice.yaw)
   else
      local there = math.atan(y - robotics.pose.y, x - robotics.pose.x)
      yaw = there + wrap_quarter(yaw - there)
   end
   local reach = 0
   for _, known in ipairs(structure.blocks) do
      reach = math.max(reach, math.sqrt((known.x - x) ^ 2 + (known.y - y) ^ 2))
   end
   -- one cell stays the first for as long as the robot is less than half a cell wrong
   local frame = { x = structure.frame.x, y = structure.frame.y, yaw = yaw }
   local origin = lattice and lattice.origin or frame
   local u, v = robotics.into(frame, origin.x, origin.y)
   local ox, oy = robotics.out_of(frame, SIDE * math.floor(u / SIDE + 0.5),
                                  SIDE * math.floor(v / SIDE + 0.5))
   lattice = { x = x, y = y, yaw = wrap(yaw), reach = reach + SIDE / 2, origin = { x = ox, y = oy } }
end

local function heading_of(index)
   local first = task.turns and 0 or SIDES[robot.params.side or task.sides[1]]
   return wrap(lattice.yaw + (index - first) * math.pi / 2)
end

-- The side among those allowed that the robot is nearest to.
local function nearest_side()
   local there = math.atan(lattice.y - robotics.pose.y, lattice.x - robotics.pose.x)
   local best, least
   for _, name in ipairs(task.sides) do
      local off = math.abs(wrap(heading_of(SIDES[name]) - there))
      if not least or off < least - 1e-6 then best, least = SIDES[name], off end
   end
   return best
end

-- Getting about ------------------------------------------------------------------------------

-- How near the straight way to x, y comes to the structure's middle.
local function way_past(x, y)
   local dx, dy = x - robotics.pose.x, y - robotics.pose.y
   local square = dx * dx + dy * dy
   local t = 0
   if square > 0 then
      t = ((lattice.x - robotics.pose.x) * dx + (lattice.y - robotics.pose.y) * dy) / square
   end
   t = robotics.clamp(t, 0, 1)
   return math.sqrt((robotics.pose.x + t * dx - lattice.x) ^ 2 +
                    (robotics.pose.y + t * dy - lattice.y) ^ 2)
end

-- Straight to a place; back, aside and on where something stands in the way.
local function straight_to(x, y)
   for _ = 1, 6 do
      handling.go_to(x, y, nil, handling.blocked)
      local dx, dy = x - robotics.pose.x, y - robotics.pose.y
      if dx * dx + dy * dy < 0.02 ^ 2 then return true end
      handling.go_by(-0.08, 0.1)
      handling.wait(math.random() * 4)
      handling.turn_by(math.random() < 0.5 and 1 or -1)
      local pose = robotics.pose
      handling.follow({ x = pose.x, y = pose.y, yaw = pose.yaw }, 0.15, 0.1, handling.blocked)
   end
   return false
end

-- To a place, round the structure where it is in the way.
local function travel(x, y)
   if lattice and way_past(x, y) < lattice.reach + TOO_NEAR then
      local radius = lattice.reach + CLEAR_OF
      local function angle_of(px, py) return math.atan(py - lattice.y, px - lattice.x) end
      local goal = angle_of(x, y)
      for _ = 1, 8 do
         local at = angle_of(robotics.pose.x, robotics.pose.y)
         local left = wrap(goal - at)
         local away = math.sqrt((robotics.pose.x - lattice.x) ^ 2 +
                                (robotics.pose.y - lattice.y) ^ 2)
         if math.abs(left) < 0.3 or
            (away > radius - 0.03 and way_past(x, y) >= lattice.reach + TOO_NEAR) then break end
         local to = at + robotics.clamp(left, -math.pi / 4, math.pi / 4)
         straight_to(lattice.x + radius * math.cos(to), lattice.y + radius * math.sin(to))
      end
   end
   return straight_to(x, y)
end

-- Looks at a place in memory from a little away. Whether `found()` says something.
local function look_again(place, found)
   local dx, dy = place.x - robotics.pose.x, place.y - robotics.pose.y
   local away = math.sqrt(dx * dx + dy * dy)
   if away > FAR_LOOK + 0.02 or away < FAR_LOOK - 0.10 then
      local share = (away - FAR_LOOK) / math.max(away, 1e-6)
      travel(robotics.pose.x + share * dx, robotics.pose.y + share * dy)
   end
   handling.lift_to(robotics.profile.lift_top - 0.0015)
   handling.turn_to(math.atan(place.y - robotics.pose.y, place.x - robotics.pose.x))
   return handling.wait_until(found, LOOK_TIME)
end

-- Blocks -------------------------------------------------------------------------------------

-- Dark, on the floor, and with nothing beside it.
local function is_unused(known)
   if known.colour ~= 0 or known.level ~= 0 or known.seen < 2 * OFTEN then return false end
   for _, other in ipairs(robotics.blocks()) do
      if other ~= known then
         local dx, dy, dz = other.x - known.x, other.y - known.y, other.z - known.z
         if dx * dx + dy * dy + dz * dz < LINKED * LINKED then return false end
      end
   end
   return true
end

local does = {}
building.does = does

function does.wait()
   handling.wait(math.random() * task.delay)
   return 'done'
end

function does.search_block()
   if cache then
      local function there()
         for _, known in ipairs(robotics.blocks()) do
            if is_unused(known) and robotics.time - known.time < 1 then return true end
         end
      end
      if not look_again(cache, there) then cache = nil end
   end
   block = handling.search(is_unused)
   return block and 'found' or 'none'
end

function does.approach_block()
   local near, seen = handling.approach_block(block)
   if near then block = seen return 'near' end
   tally('aborted')
   return 'lost'
end

function does.pick_up()
   local place = { x = block.x, y = block.y }
   if handling.grip_block(block, task.transport) then
      cache, side = place, nil
      handling.go_by(-0.10, 0.1)
      return 'holds'
   end
   tally('aborted')
   handling.go_by(-0.12, 0.1)
   return 'failed'
end

-- Sites --------------------------------------------------------------------------------------

function does.search_structure()
   if not handling.holds() then return 'dropped' end
   local found = structure_in_memory()
   if not found and lattice then
      look_again(lattice, structure_in_memory)
      found = structure_in_memory()
      -- it is not where it was left: the robot is lost, and so is its sense of direction
      if not found then lattice, side = nil, nil end
   end
   if not found then
      if not handling.search(is_brick) then return 'none' end
      handling.wait(LOOK_TIME)
      found = structure_in_memory()
   end
   if not found then return 'none' end
   remember(found)
   if not side then side, tried = nearest_side(), {} end
   return 'found'
end

-- Rows of the structure as seen from this side: by v (to the left), the foremost u (towards the
-- robot).
local function rows_of_side()
   local structure = structure_in_memory()
   if not structure then return nil end
   remember(structure)
   local frame = { x = lattice.origin.x, y = lattice.origin.y, yaw = heading_of(side) }
   local rows = {}
   for _, known in ipairs(structure.blocks) do
      local along, left = robotics.into(frame, known.x, known.y)
      local u, v = -math.floor(along / SIDE + 0.5), math.floor(left / SIDE + 0.5)
      rows[v] = rows[v] or { v = v, front = u, frame = frame }
      rows[v].front = math.max(rows[v].front, u)
   end
   return rows
end

-- Place of a cell, du and dv from the foremost of a row.
local function place_of(of, du, dv)
   return robotics.out_of(of.frame, -SIDE * (of.front + du), SIDE * (of.v + dv))
end

-- Whether the body has room before a row: what juts out beside it by two cells is in the way.
local function room_before(rows, of)
   for _, v in ipairs { of.v - 1, of.v + 1 } do
      if rows[v] and rows[v].front >= of.front + 2 then return false end
   end
   return true
end

-- A row that was not tried yet, at random.
function does.choose_row()
   if not handling.holds() then return 'dropped' end
   local rows = rows_of_side()
   if not rows then return 'lost' end
   local open = {}
   for _, of in pairs(rows) do
      if not tried[of.v] and room_before(rows, of) then table.insert(open, of) end
   end
   if #open == 0 then return 'none' end
   row = open[math.random(#open)]
   return 'chosen'
end

-- All rows were tried: to the next side, or after a while again from this one.
function does.next_side()
   tried = {}
   if #task.sides == 1 then
      handling.wait(2 + 4 * math.random())
      return 'there'
   end
   local here = 1
   for i, name in ipairs(task.sides) do
      if SIDES[name] == side then here = i end
   end
   side = SIDES[task.sides[here % #task.sides + 1]]
   local heading = heading_of(side)
   local away = lattice.reach + CLEAR_OF
   travel(lattice.x - away * math.cos(heading), lattice.y - away * math.sin(heading))
   if look_again(lattice, structure_in_memory) then return 'there' end
   return 'lost'
end

-- The line on which the robot faces a row; its end is the middle of the foremost column.
local function line_before(of)
   local x, y = place_of(of, 0, 0)
   return { x = x, y = y, yaw = of.frame.yaw }
end

local function distance_for(look)
   local camera = robot.camera_system.transform.position.x + robotics.profile.anchor[1]
   return camera + look.distance + SIDE / 2
end

function does.stand_before()
   local line = line_before(row)
   local away = distance_for(task.looks[1])
   local along, aside = handling.on_line(line)
   if math.abs(aside) > 0.015 or along > -away + 0.01 or along < -away - 0.20 or
      math.abs(wrap(robotics.pose.yaw - line.yaw)) > 0.5 then
      handling.lift_to(math.max(robot.lift_system.position, 0.070))
      if not travel(robotics.out_of(line, -away - 0.03, 0)) then
         tally('aborted')
         return 'blocked'
      end
   end
   handling.turn_to(line.yaw)
   handling.follow(line, -away, 0.10)
   return 'there'
end

-- What is seen of the column in front, for as long as the robot stands: bricks by colour, cells
-- that are empty since a brick there would be seen.
local function watch(seen)
   local rows = rows_of_side()
   local of = rows and rows[row.v]
   if of then row = of end
   for _, known in ipairs(robotics.tracks) do
      if known.time == robotics.time and known.seen >= OFTEN then
         local along, left = robotics.into(row.frame, known.x, known.y)
         local du = -math.floor(along / SIDE + 0.5) - row.front
         local dv = math.floor(left / SIDE + 0.5) - row.v
         local level = robotics.level_of(known.z)
         seen.bricks[du .. ' ' .. dv .. ' ' .. level] = known
         if known.top_time == robotics.time then
            local above = du .. ' ' .. dv .. ' ' .. level + 1
            seen.empty[above] = (seen.empty[above] or 0) + 1
         end
      end
   end
   for _, ask in ipairs(task.asks) do
      local key = table.concat(ask, ' ')
      local x, y = place_of(row, ask[1], ask[2])
      if not seen.bricks[key] and robotics.would_see(x, y, ask[3], row.frame.yaw) then
         seen.empty[key] = (seen.empty[key] or 0) + 1
      end
   end
end

-- A colour, 'empty', or nil where it is not known.
local function cell_of(seen, du, dv, level)
   local key = du .. ' ' .. dv .. ' ' .. level
   local known = seen.bricks[key]
   if known then return is_brick(known) and known.colour or nil end
   return (seen.empty[key] or 0) >= OFTEN and 'empty' or nil
end

-- The highest brick of the column in front.
local function top_of(seen)
   local top
   for level = 0, task.levels do
      local is = cell_of(seen, 0, 0, level)
      if is == 'empty' or (not is and level == task.levels) then return top end
      if not is then return nil end
      top = { level = level, colour = is, known = seen.bricks['0 0 ' .. level] }
   end
   return top
end

function does.look()
   local seen = { bricks = {}, empty = {} }
   local column = { cell = function(du, dv, level) return cell_of(seen, du, dv, level) end }
   for _, look in ipairs(task.looks) do
      handling.follow(line_before(row), -distance_for(look), 0.08)
      handling.lift_to(look.lift)
      local start = robotics.time
      while robotics.time - start < LOOK_TIME do
         coroutine.yield()
         watch(seen)
      end
      local top = top_of(seen)
      if top then column.top_colour, column.top_level = top.colour, top.level end
   end
   if not handling.holds() then return 'dropped' end
   if not column.top_level then
      tried[row.v] = true
      tally('aborted')
      return 'unseen'
   end
   wish = task.decide(column)
   if not wish then
      tried[row.v] = true
      return 'nothing'
   end
   wish.top = seen.bricks['0 0 ' .. column.top_level]
   wish.foot = seen.bricks['0 0 ' .. (wish.level or column.top_level)]
   return 'decided'
end

function does.approach_site()
   local where, target = wish.what, wish.top
   if where ~= 'raise' then target = wish.foot or wish.top end
   local near, seen = handling.approach_site(target, where, {
      heading = row.frame.yaw, level = wish.level, left = wish.left and wish.left * SIDE,
   })
   if near then wish.near = seen return 'near' end
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
   handling.go_by(-0.15, 0.1)
   return 'done'
end

-- Life ----------------------------------------------------------------------------------------

-- Follows the chart for ever: each of its states is something done, which ends with an event, and
-- the chart says which state that leads to.
function building.start(chart, with)
   task = with
   lattice, cache, block, side, tried, row, wish = nil, nil, nil, nil, nil, nil, nil
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
