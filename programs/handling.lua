-- SPDX-License-Identifier: MIT
-- What a robot does: drives along lines, approaches blocks, picks them up and puts them down.
--
-- Behaviours are functions that return when they are done, true or false and a reason. They run
-- in a coroutine, one step of it a control step:
--
--     function init()  handling.start(function() handling.pick_up(...) end)  end
--     function step()  handling.step()  end

local robotics = require 'robotics'
local avoidance = require 'avoidance'
-- transport: colour that a block has on its way in a robot's hand
local handling = { carrying = false, state = '', transport = 4 }

local SIDE = robotics.SIDE
local TIME_OUT = 7.5
local wrap, wrap_quarter, clamp = robotics.wrap, robotics.wrap_quarter, robotics.clamp

-- Lift heights over the floor, for a block on it.
local LOOK = 0.015             -- over a block's top: clear of it, and its magnets are not drawn
local PULSE, LOWER = 0.006, 0.003
local CARRY = 0.058
local CARRY_FAR = 0.080         -- passes over a block without being drawn to it
local CLEAR = 0.014            -- of a carried block over what it passes, more than magnets reach
local DRAW, SHY = 0.025, 0.001 -- from a face: where it begins to draw, and where to stop
local ASIDE = 0.002            -- from a neighbour beside, which draws the block when it is there
local DRAWN_OFF = 0.005        -- ahead in the gripper: neighbours have drawn the block into its place
local ASIDE_LOOK = 0.095       -- height of the lift to see a block beside the way
local ASIDE_ANGLE = 0.17       -- rad, within which such a block is surely in the picture
local REST = 0.0015            -- of a block over what it is let go on, and less than 1 mm more
local LET_GO = 0.030           -- up from a block that was put down
local EFFECTOR_GAP = 0.0015    -- left between the effector and a column before it, at least
local HELD_OFF = 0.010         -- of a carried block's face from a column's, which would draw it off
local SLOW = 0.05              -- m/s, close to blocks
local BEHIND = 0.07            -- m, behind the chassis, which the body sticks out by 0.03, to stop from 0.1 m/s
local SWEPT = 0.09             -- m, beside the chassis, that the effector sweeps when it turns
local FACING = 0.18            -- m, before the effector, where another's may come towards it
local MEETING = 0.17           -- m, before the chassis, of which the effector takes 0.085
local EFFECTOR = 0.095         -- m, the effector before the chassis, and some more
local PATIENCE = 8             -- s, the longest random wait for a robot to go its way
local SHORT = 0.015            -- m, by which a higher column behind may keep the effector off its place
local CARRIED = 0.12           -- m, from a site, where a block in another robot's hand is in the way
local STRAIGHT = 0.04          -- m, in which a line is joined
local LAST_STRAIGHT = 0.025    -- m, likewise on the last, blind 50 to 85 mm of an approach
local STAND_OFF = 0.30         -- m, from a block, where its approach begins
local ATTEMPTS = 4
local SEEN_LATELY = 2          -- s
local SEEN_NOW = 0.7           -- s, in which a tag in sight was seen
local LEG = 0.33               -- m, between two looks round
local NEAR_LOOK = 0.070        -- height of the lift; what it carries passes over a block
local LOW_LOOK = 0.030         -- likewise, of one that carries nothing: for what is 0.2 m away

local behaviour

-- Time ----------------------------------------------------------------------------------------

function handling.yield()
   coroutine.yield()
end

function handling.wait(seconds)
   local start = robotics.time
   while robotics.time - start < seconds - 1e-6 do coroutine.yield() end
end

-- Until `done()`, or false after a time.
local function wait_until(done, seconds)
   local start = robotics.time
   while not done() do
      if robotics.time - start > (seconds or TIME_OUT) then return false end
      coroutine.yield()
   end
   return true
end
handling.wait_until = wait_until

local function enter(state)
   handling.state = state
   if robot.params.verbose then
      local pose = robotics.pose
      log(string.format('%.1f s: %s at %.3f %.3f %.1f', robotics.time, state, pose.x, pose.y,
                        math.deg(pose.yaw)))
   end
   if robot.show then robot.show.text('state', state) end
end
handling.enter = enter

-- Driving -------------------------------------------------------------------------------------

-- The speed, at most `most`, for the next step so that a rim that now runs at `now` can still
-- stop `way` ahead; way, now and the result have the same sign when all is well.
local function speed_for(way, now, most)
   local sign = way < 0 and -1 or 1
   way, now = way * sign, now * sign
   -- far from the end brake gently; on the last millimetres exactly as the ramp does
   local brake = robotics.profile.acceleration * (way > 0.010 and 0.4 or 1)
   local low, high = 0, most
   for _ = 1, 24 do
      local middle = (low + high) / 2
      local needed = robotics.way_of(now, middle, robotics.period) + middle * middle / (2 * brake)
      if needed > way then high = middle else low = middle end
   end
   return sign * low
end

function handling.stop()
   robotics.drive(0, 0)
   wait_until(function()
      return math.abs(robotics.left) < 1e-4 and math.abs(robotics.right) < 1e-4
   end, 1)
end

-- On the spot, to a heading of the odometry frame; `rim` is the speed of the rims.
function handling.turn_to(yaw, rim)
   local radius = robotics.profile.track / 2
   local start = robotics.time
   while robotics.time - start < 20 do
      local way = wrap(yaw - robotics.pose.yaw) * radius
      local now = (robotics.right - robotics.left) / 2
      if math.abs(way) < 1e-5 and math.abs(now) < 1e-3 then break end
      local speed = speed_for(way, now, rim or 0.06)
      robotics.drive_rims(-speed, speed)
      coroutine.yield()
   end
   handling.stop()
   return math.abs(wrap(yaw - robotics.pose.yaw)) < 0.01
end

function handling.turn_by(angle, rim)
   return handling.turn_to(robotics.pose.yaw + angle, rim)
end

-- Place along and beside a line {x, y, yaw}, and the angle to it.
function handling.on_line(line)
   local along, aside = robotics.into(line, robotics.pose.x, robotics.pose.y)
   return along, aside, wrap(robotics.pose.yaw - line.yaw)
end

-- Along a line to its point `to` (0: where the line begins), forward or backward, as the way
-- there asks; joins it within some 4 `straight` (default: STRAIGHT). `line` may be a function that says it anew in each
-- step; nil ends the drive. `each` is called in every step and may end it by returning true.
function handling.follow(line, to, speed, each, straight)
   straight = straight or STRAIGHT
   local start = robotics.time
   while robotics.time - start < 60 do
      local now_line = line
      if type(line) == 'function' then now_line = line() end
      if not now_line then
         handling.stop()
         return false, 'target lost'
      end
      local along, aside, angle = handling.on_line(now_line)
      local way, now = to - along, (robotics.left + robotics.right) / 2
      if (math.abs(way) < 1e-4 and math.abs(now) < 1e-3) or (each and each()) then break end
      local v = speed_for(way, now, speed)
      -- critically damped over the way: e'' = -2 e'/L - e/L²
      local back = way < 0 and -1 or 1
      local bend = -back * aside / straight ^ 2 - 2 * angle / straight
      robotics.drive(v, math.abs(v) * clamp(bend, -15, 15))
      coroutine.yield()
   end
   handling.stop()
   return true
end

-- Straight on by so much; back when negative; `each` as with follow.
function handling.go_by(way, speed, each)
   local pose = robotics.pose
   return handling.follow({ x = pose.x, y = pose.y, yaw = pose.yaw }, way,
                          speed or robotics.profile.cruise, each)
end

-- To a place of the odometry frame: turns to it, and drives; `each` as with follow.
function handling.go_to(x, y, speed, each)
   local dx, dy = x - robotics.pose.x, y - robotics.pose.y
   if dx * dx + dy * dy < 1e-4 then return true end
   local yaw = math.atan(dy, dx)
   if math.abs(wrap(yaw - robotics.pose.yaw)) > 0.3 then handling.await_room() end
   handling.turn_to(yaw)
   return handling.follow({ x = x, y = y, yaw = yaw }, 0, speed or robotics.profile.cruise, each)
end

-- Whether current flows that makes the magnets hold harder, until their charge has sunk.
local function hold_fast(on)
   robot.electromagnet_system.set_discharge_mode(on and 'constructive' or 'disable')
end

-- The lift -----------------------------------------------------------------------------------

-- It rests within `lift_slack` of where it is sent, on the side that it came from; so it is
-- sent that much further. What it carries would come off in the jolt of starting or stopping: the
-- magnets hold harder meanwhile.
function handling.lift_to(height)
   local slack = 0.8 * robotics.profile.lift_slack
   local position = robot.lift_system.position
   if math.abs(height - position) < slack then return true end
   local sent = height + (height > position and slack or -slack)
   sent = clamp(sent, 0, robotics.profile.lift_top)
   if handling.carrying then
      hold_fast(true)
      coroutine.yield()
   end
   robot.lift_system.set_position(sent)
   coroutine.yield()
   -- there, or held up by something
   local before, still = position, 0
   local reached = wait_until(function()
      local now = robot.lift_system.position
      still = math.abs(now - before) < 1e-4 and still + 1 or 0
      before = now
      return still >= 3 or math.abs(now - sent) <= 1.05 * robotics.profile.lift_slack
   end, 20)
   if handling.carrying then
      coroutine.yield()
      hold_fast(false)
   end
   return reached
end

-- Looking ------------------------------------------------------------------------------------

-- The lift's height at which a mark, `ahead` of the robot at a height, is in the picture's middle.
local function height_for(ahead, height)
   local eye = robotics.profile.anchor
   local at = robot.camera_system.transform.position
   return ahead - (at.x + eye[1]) + height - (at.z + eye[3])
end

-- The least distance ahead of a block at which the tag that it shows is wholly in the picture, at
-- a height of the lift.
local function nearest_in_sight(lift, block)
   local height, before = robotics.mark_of(block)
   local at, anchor = robot.camera_system.transform.position, robotics.profile.anchor
   local half = 0.92 * robot.camera_system.resolution.y / 2 / robotics.profile.focal
   -- the tag's nearer edge, or its lower one
   local edge = before > 0 and 0 or 0.016
   local above = at.z + anchor[3] + lift - height + (before > 0 and 0.014 or 0)
   return at.x + anchor[1] + above * (1 - half) / (1 + half) + edge + before
end

-- How far ahead a block is whose mark is in the picture's middle, at a height of the lift.
local function centred_at(lift, block)
   local height, before = robotics.mark_of(block)
   local at, anchor = robot.camera_system.transform.position, robotics.profile.anchor
   return at.x + anchor[1] + at.z + anchor[3] + lift - height + before
end

-- Moves the lift so that a block on the floor, so far ahead, is in the picture's middle, as near as
-- it can; what is carried passes over blocks.
function handling.look_to(ahead)
   local lowest = handling.carrying and NEAR_LOOK or LOOK
   handling.lift_to(clamp(height_for(ahead, SIDE), lowest, robotics.profile.lift_top - 0.0015))
end

local function lift_for_sight(block, lowest)
   local ahead = robotics.into(robotics.pose, block.x, block.y)
   local mark, before = robotics.mark_of(block)
   local height = clamp(height_for(ahead - before, mark), lowest, robotics.profile.lift_top)
   if math.abs(height - robot.lift_system.position) > 0.003 then
      robot.lift_system.set_position(height)
   end
end

-- Stands and looks until a block was seen `often` more times; the block as it is now, or nil.
local function look_at(block, often)
   local known = robotics.again(block)
   if not known then return nil end
   local before = known.seen
   local function seen()
      known = robotics.again(block)
      return not known or known.seen >= before + often
   end
   if not wait_until(seen, 4) then return nil end
   return known
end

-- Whether something is in sight that was not seen often enough to be sure of.
local function glimpse()
   for _, known in ipairs(robotics.tracks) do
      if known.missed == 0 and known.seen < 8 and robotics.time - known.time < 0.1 then
         return true
      end
   end
   return false
end

-- The least of some rangefinders' readings, m; more than any of them reaches where nothing is near.
local function nearest(names)
   local least = 1
   for _, name in ipairs(names) do least = math.min(least, robotics.range(name) or 1) end
   return least
end

-- How far away something stands before the chassis, as far as a carried block does not hide it.
local function before_chassis()
   if handling.carrying and robot.lift_system.position < SIDE then return 1 end
   return nearest(robotics.profile.fan and { '12', '1', '2' } or { '1', '2', '3' })
end

-- Whether something stands within `distance` of the wheels' front (45 mm, if nothing is said), or
-- right before the effector.
local function blocked(distance)
   return before_chassis() < (distance or 0.045) or nearest { 'front' } < 0.05
end
handling.blocked = blocked

-- Whether something stands behind, which would be pushed.
function handling.backed()
   return not robotics.profile.fan and nearest { '7', '8', '9' } < BEHIND
end

-- Back by so much, or as far as there is room.
function handling.back_off(way)
   local pose = robotics.pose
   return handling.follow({ x = pose.x, y = pose.y, yaw = pose.yaw }, -way, 0.1, handling.backed)
end

-- Whether something stands between the robot and a column, `away` from its middle, that it faces;
-- one beside it may jut out by a block.
function handling.between(away)
   if robotics.profile.fan then return false end
   local face = away - robotics.profile.front - SIDE / 2
   return before_chassis() < face - SIDE - 0.02
end

-- Waits a while for those to go whom the effector would sweep in a turn on the spot.
function handling.await_room()
   if robotics.profile.fan then return end
   local beside = { '4', '5', '6', '7', '8', '9', '10', '11', '12' }
   local function room() return nearest(beside) > SWEPT end
   if not room() then wait_until(room, PATIENCE * math.random()) end
end

-- What stands ahead within the effector's reach, at the speed of travel: most likely a robot. With
-- `left` m to go what is beyond does not count.
function handling.meets(left)
   return blocked(math.min(MEETING, (left or 1) + EFFECTOR)) or
          nearest { 'front' } < math.min(FACING, left or 0)
end

-- The nearest of the blocks in memory that is wanted, or nil.
local function recall(wanted, age)
   local best
   for _, block in ipairs(robotics.blocks()) do
      if (not age or robotics.time - block.time < age) and wanted(block) and
         (not best or robotics.distance_to(block) < robotics.distance_to(best)) then
         best = block
      end
   end
   return best
end
handling.recall = recall

-- Once round on the spot, until `found()` is something.
local function look_round(found)
   handling.await_room()
   local rim, turned, before = robotics.profile.search_rim, 0, robotics.pose.yaw
   local block
   while turned < 2 * math.pi and not block do
      -- what is seen for the first time is worth a look
      local turning = glimpse() and 0 or rim
      robotics.drive_rims(-turning, turning)
      coroutine.yield()
      turned = turned + math.abs(wrap(robotics.pose.yaw - before))
      before = robotics.pose.yaw
      block = found()
   end
   handling.stop()
   return block
end

-- Once round with the lift up and then with it lower, since each height sees a ring: a block of
-- which `wanted(block)` is true, or nil.
function handling.look_about(wanted)
   for _, height in ipairs { robotics.profile.lift_top - 0.0015, NEAR_LOOK, LOW_LOOK } do
      if handling.carrying and height == LOW_LOOK then break end
      handling.lift_to(height)
      local block = look_round(function() return recall(wanted, 1) end)
      if block then return block end
   end
   return nil
end

-- A block that is wanted: one in memory, or else one that comes in sight. Looks about, and after
-- that in vain moves on, in a square spiral of so many `legs`, each driven by `go(x, y)`. Returns
-- nil when there was none.
function handling.search(wanted, legs, go)
   local block = recall(wanted)
   if block then return block end
   enter('search')
   local heading, run, left = robotics.pose.yaw, 2, 1
   for _ = 1, legs or 25 do
      block = handling.look_about(wanted)
      if block then return block end
      -- legs of 1, 1, 2, 2, 3, 3 ... steps, a quarter turn between them
      if left == 0 then
         run, heading = run + 1, heading + math.pi / 2
         left = run // 2
      end
      left = left - 1
      local pose = robotics.pose
      local x, y = pose.x + LEG * math.cos(heading), pose.y + LEG * math.sin(heading)
      if go then go(x, y) else handling.go_to(x, y, 0.12, blocked) end
   end
   return nil
end

-- Approach -----------------------------------------------------------------------------------

-- Whether a column is just before the effector, which is longer than the block.
local function column_ahead()
   local ahead = robotics.range('front')
   return ahead ~= nil and ahead < 0.020
end

-- Straight on, slowly, as far as that leaves the effector before what is ahead of it, and the
-- block's face `off` it: the effector is longer by a little.
local function creep(way, off, each)
   local ahead = robotics.range('front')
   local longer = robotics.profile.reach - robotics.profile.grip - SIDE / 2
   if ahead then way = math.min(way, ahead - math.max(EFFECTOR_GAP, (off or 0) - longer)) end
   if math.abs(way) > 0.0002 then handling.go_by(way, 0.02, each) end
end

-- The heading, of the four that face a block squarely, that is nearest to the way there.
local function heading_to(block)
   local there = math.atan(block.y - robotics.pose.y, block.x - robotics.pose.x)
   return there + wrap_quarter(block.yaw - there)
end

-- The line to a block, squarely to its face; ends in its middle, or `ahead` and `left` of that.
local function line_to(block, heading, options)
   local square = heading + wrap_quarter(robotics.square_of(block) - heading)
   local line = { x = block.x, y = block.y, yaw = square }
   local ahead, left = options.ahead or 0, options.left or 0
   line.x, line.y = robotics.out_of(line, ahead, left)
   return line
end

-- The line as it would be taken for with an error {x, y, yaw} in its own frame: for tests.
local function misjudge(line, error)
   if not error then return line end
   local x, y = robotics.out_of(line, error.x or 0, error.y or 0)
   return { x = x, y = y, yaw = line.yaw + (error.yaw or 0) }
end

-- Drives until the gripping point is over the target: the block's middle, or a place `ahead` and
-- `left` of it as seen on the way in. From STAND_OFF on the way is straight; it is watched as long
-- as the camera sees the block, and blind from there. `lowest` is the least height of the lift; it
-- is higher where the block is seen only from there.
local function approach(block, options)
   local grip = robotics.profile.grip
   local lowest = math.max(options.lowest, SIDE * (block.level or 0) + LOOK)
   lowest = math.min(lowest, robotics.profile.lift_top - 0.0005)
   for attempt = 1, ATTEMPTS do
      enter('approach')
      local heading = options.heading or heading_to(block)
      local line = line_to(block, heading, options)
      local along, aside = handling.on_line(line)
      if attempt == 1 and along > -0.22 and math.abs(aside) < 0.02 and
         math.abs(wrap(robotics.pose.yaw - line.yaw)) < 0.2 then
         -- it faces it already, and a turn sweeps more than going back
         handling.follow(line, -STAND_OFF, 0.1, handling.backed)
         along, aside = handling.on_line(line)
      end
      if attempt > 1 or along > -0.22 or math.abs(aside) > 0.02 then
         -- out of reach of the block before turning
         if robotics.distance_to(block) < 0.22 then handling.back_off(0.12) end
         local away = STAND_OFF + 0.02 * (attempt - 1)
         local x, y = robotics.out_of(line, -away, 0)
         for _ = 1, 3 do
            handling.go_to(x, y, nil, handling.meets)
            if not handling.meets() then break end
            handling.wait(PATIENCE * math.random())
         end
         if handling.meets() and (x - robotics.pose.x) ^ 2 + (y - robotics.pose.y) ^ 2 > 0.05 ^ 2 then
            handling.back_off(0.10)
            return false, 'busy'
         end
      end
      handling.turn_to(line.yaw)
      lift_for_sight(block, lowest)
      handling.wait(0.6)
      local seen = look_at(block, 4)
      if not seen and attempt == 1 then
         robotics.forget(block)
         return false, 'it is not there'
      end
      local function now_line()
         local known = robotics.again(block)
         if not known then return nil end
         block = known
         lift_for_sight(known, lowest)
         return line_to(known, heading, options)
      end
      if seen then
         local watch, sight = lowest, nearest_in_sight(lowest, block)
         if math.abs(options.left or 0) > 0.01 then
            -- a block to the side leaves the picture sooner
            watch = clamp(SIDE * (block.level or 0) + ASIDE_LOOK, lowest, robotics.profile.lift_top - 0.0005)
            sight = centred_at(watch, block)
         end
         local near = math.max(sight + (options.ahead or 0), 0.170)
         local function between() return handling.between(robotics.distance_to(block)) end
         local there = handling.follow(now_line, -near, 0.08, between)
         if between() then
            handling.back_off(0.10)
            return false, 'busy'
         end
         if there and options.alone then
            if not options.alone(now_line() or line) then
               handling.back_off(0.10)
               return false, 'busy'
            end
            there = handling.follow(now_line, -near, 0.08, between)
         end
         if there then
            handling.lift_to(watch)
            -- no more of a turn than it takes: odometry takes a small one for less than it is
            local ahead, left = robotics.into(robotics.pose, block.x, block.y)
            local angle = math.atan(left, ahead)
            local turn = angle - clamp(angle, -ASIDE_ANGLE, ASIDE_ANGLE)
            if turn ~= 0 then handling.turn_by(turn, 0.03) end
            seen = look_at(block, 6)
            if turn ~= 0 then handling.turn_by(-turn, 0.03) end
         else
            seen = nil
         end
      end
      if seen then
         line = line_to(seen, heading, options)
         local _, off, angle = handling.on_line(line)
         if options.free and not options.free(line, seen) then
            handling.back_off(0.10)
            return false, 'busy'
         end
         if math.abs(off) < 0.005 and math.abs(angle) < 0.12 then
            enter('reach')
            line = misjudge(line, options.misjudged)
            local to = -grip + (options.short or 0)
            handling.follow(line, to, SLOW, options.stop, LAST_STRAIGHT)
            if options.stop and options.stop() then
               -- the column draws the block, which is held until it has been let down
               hold_fast(true)
               creep(to - handling.on_line(line), HELD_OFF)
               -- so far before its place stands no column, but another robot
               if to - handling.on_line(line) > SHORT then
                  handling.back_off(0.15)
                  hold_fast(false)
                  return false, 'busy'
               end
            end
            return true, seen
         end
         block = seen
      end
      enter('back off')
      handling.back_off(0.10)
      block = robotics.again(block) or block
   end
   return false, 'no approach succeeded'
end
handling.approach = approach

-- Picking up ---------------------------------------------------------------------------------

local function underneath_within(distance)
   local range = robotics.range('underneath')
   return range ~= nil and range <= distance
end

-- How a carried block sits: how far its middle is ahead of where it should be, and its yaw, as
-- the two rangefinders at its back say.
function handling.grip()
   local left, right = robotics.range('left'), robotics.range('right')
   if not left or not right or math.max(left, right) > 0.025 then return 0, 0 end
   local apart = 0.040
   return (left + right) / 2 - robotics.profile.gap, math.atan((right - left) / apart)
end

-- Colours the carried block (or the one at the radio): 1 to 4, 0 for dark.
function handling.colour(colour)
   robot.simple_radios.nfc.send { 48 + colour }
   coroutine.yield()
end

local function pull()
   local magnets = robot.electromagnet_system
   enter('pull')
   handling.lift_to(PULSE)
   magnets.set_discharge_mode('constructive')
   handling.wait(0.5)
   handling.lift_to(LOWER)
   handling.wait(1)
   handling.carrying = true
   handling.lift_to(CARRY)
   magnets.set_discharge_mode('disable')
   handling.wait(0.4)
   handling.carrying = underneath_within(0.005)
   if handling.carrying then handling.lift_to(CARRY_FAR) end
   return handling.carrying
end

-- Whether the carried block is still there.
function handling.holds()
   handling.carrying = handling.carrying and underneath_within(0.010)
   return handling.carrying
end

-- Lets the current flow against the magnets' own field until the two cancel, and goes up before
-- it turns over: a block's free magnets would follow.
local function let_go()
   local magnets, profile = robot.electromagnet_system, robotics.profile
   local ready = 1.12 * profile.zero
   wait_until(function() return magnets.voltage >= ready end, 8)
   magnets.set_discharge_mode('destructive')
   wait_until(function() return magnets.voltage <= 1.06 * profile.zero end, 6)
   handling.carrying = false
   local height = math.min(robot.lift_system.position + LET_GO, profile.lift_top)
   handling.lift_to(height)
   magnets.set_discharge_mode('disable')
   return not underneath_within(0.010)
end
handling.let_go = let_go

-- Drives up to a block of level 0 until it lies below the magnets: true and the block as it was
-- last seen. options: heading, misjudged (an error on purpose, {x, y, yaw} of the line's frame).
function handling.approach_block(block, options)
   options = options or {}
   local near, seen = approach(block, { heading = options.heading, lowest = LOOK,
                                        misjudged = options.misjudged })
   if not near then return false, seen end
   -- what odometry and camera left over along the way, by touch
   enter('contact')
   local ahead = handling.grip()
   if math.abs(ahead) > 0.0003 and math.abs(ahead) < 0.010 then handling.go_by(ahead, 0.02) end
   return true, seen
end

-- Lifts the block that lies below the magnets, and colours it (default Q4, in transport).
function handling.grip_block(block, colour)
   if pull() then
      robotics.forget(block)
      handling.colour(colour or 4)
      return true
   end
   let_go()
   return false, 'it does not hold'
end

-- Picks a block of level 0 up. options: those of approach_block, and colour.
function handling.pick_up(block, options)
   options = options or {}
   for _ = 1, ATTEMPTS do
      local near, seen = handling.approach_block(block, options)
      if not near then return false, seen end
      block = seen
      if handling.grip_block(block, options.colour) then return true end
      enter('back off')
      handling.back_off(0.12)
      options.misjudged = nil
   end
   return false, 'it does not hold'
end

-- Putting down -------------------------------------------------------------------------------

-- Puts the carried block down on `level`, over the gripping point; `colour` is set before.
function handling.release(level, colour)
   enter('release')
   -- first the colour: near its place magnets draw the block away from the radio
   if colour then handling.colour(colour) end
   handling.lift_to(SIDE * level + REST)
   handling.wait(0.4)
   for _ = 1, 3 do
      if let_go() then
         enter('reverse')
         handling.go_by(-0.15, 0.08)
         return true
      end
      handling.lift_to(SIDE * level + REST)
   end
   return false, 'it does not let go'
end

-- From DRAW before a place, where the magnets of its neighbours begin to draw the carried block,
-- down to the level and on to it, or as far as the effector goes.
local function slide_in(level)
   enter('slide in')
   local function drawn_off()
      local left, right = robotics.range('left'), robotics.range('right')
      return not left or not right or (left + right) / 2 - robotics.profile.gap > DRAWN_OFF
   end
   local watched = not drawn_off()
   local pose = robotics.pose
   local line = { x = pose.x, y = pose.y, yaw = pose.yaw }
   handling.lift_to(SIDE * level + REST)
   -- what goes on would push a block that is in its place already
   if watched and drawn_off() then return end
   hold_fast(true)
   -- the neighbours draw the robot too
   creep(DRAW - SHY - handling.on_line(line), nil, watched and drawn_off or nil)
   hold_fast(false)
end

-- Whether another robot is seen to hold a block over a place, `within` m of it beside.
function handling.held_near(x, y, within)
   for _, known in ipairs(robotics.tracks) do
      local dx, dy = known.x - x, known.y - y
      if known.colour == handling.transport and known.z > SIDE and
         robotics.time - known.time < SEEN_LATELY and dx * dx + dy * dy < within * within
      then return true end
   end
   return false
end

-- Whether a place that is to be filled is free as far as the camera has seen.
local function is_free(x, y, level)
   if handling.held_near(x, y, CARRIED) then return false end
   for _, known in ipairs(robotics.tracks) do
      local dx, dy, dz = known.x - x, known.y - y, known.z - SIDE * (level + 0.5)
      if known.missed == 0 and dx * dx + dy * dy + dz * dz < (0.6 * SIDE) ^ 2 then return false end
   end
   return true
end

-- Brings the carried block before its place next to `block`: where = 'raise': on top of it;
-- 'extend': in front of it, on the robot's side; 'beside': to the left of it by `left`. True, or
-- false and why not. options: heading, misjudged, left, level (of the place; default: over the
-- block, or on the floor), aside (1 or -1: a little to the left or right, since a neighbour stands
-- on the other side), alone(line): asked on the way in, whether nobody else is at work there.
function handling.approach_site(block, where, options)
   options = options or {}
   if not handling.holds() then return false, 'the block was lost' end
   local raise = where == 'raise'
   local level = options.level or (raise and (block.level or 0) + 1 or 0)
   local ahead = where == 'extend' and -SIDE or 0
   local left = (options.left or 0) + ASIDE * (options.aside or 0)
   local back, yaw = handling.grip()
   local lowest = math.min(SIDE * level + CLEAR, robotics.profile.lift_top - 0.0005)
   local near, seen = approach(block, {
      heading = options.heading, lowest = lowest, short = (raise and 0 or -DRAW) - back,
      misjudged = options.misjudged, ahead = ahead, left = left,
      stop = raise and column_ahead or nil,
      -- a block that another robot is putting there hides the top
      free = function(line, top)
         return is_free(line.x, line.y, level) and
                (not raise or robotics.time - top.top_time < SEEN_NOW)
      end,
      alone = options.alone,
   })
   if not near then return false, seen end
   if not handling.holds() then
      -- a turn would sweep the structure
      hold_fast(false)
      handling.back_off(0.15)
      return false, 'the block was lost'
   end
   if math.abs(yaw) > 0.004 then handling.turn_by(-yaw, 0.01) end
   handling.site_level = level
   return true, seen
end

-- Puts the carried block down where approach_site has brought it.
function handling.attach(where, colour)
   if where ~= 'raise' then
      if colour then handling.colour(colour) end
      slide_in(handling.site_level)
      colour = nil
   end
   return handling.release(handling.site_level, colour)
end

-- Both. options: those of approach_site, and colour.
function handling.place(block, where, options)
   options = options or {}
   local near, problem = handling.approach_site(block, where, options)
   if not near then return false, problem end
   return handling.attach(where, options.colour)
end

-- Life ----------------------------------------------------------------------------------------

-- Runs `main` from now on, a step of it in each `step()`. `figures`: as robotics.start has them.
function handling.start(main, figures)
   robotics.start(figures)
   avoidance.start()
   handling.carrying = false
   behaviour = coroutine.create(main)
end

-- Senses, and goes on with the behaviour. False when it has ended.
function handling.step()
   robotics.sense()
   avoidance.sense()
   if coroutine.status(behaviour) == 'dead' then return false end
   local good, problem = coroutine.resume(behaviour)
   if not good then error(problem, 0) end
   return true
end

return handling
