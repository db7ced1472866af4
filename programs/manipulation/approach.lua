-- SPDX-License-Identifier: MIT
-- Drives until the gripping point is over a target: a block's middle, or a place `ahead` and `left`
-- of it as seen on the way in. From the stand-off on the way is straight; it is watched as long as the
-- camera sees the block, and blind from there.
--
-- It is a state machine. Each state is a method that takes the time that it takes and returns what came
-- of it, and TRANSITIONS says which state, or which end, that leads to.
--
-- A target is {block, heading, ahead, left, lowest, short, stop, free, alone, begin}, all but block and
-- lowest optional: heading, from which to come, of the four that face the block squarely the nearest, if none
-- is said; lowest, the least height of the lift (it is higher where the block is seen only from there);
-- short, by how much to stop before the target; stop(), asked on the last way, ends it before a column;
-- apart, whether the block is none of the structure, and so to be come to from where there is room to turn;
-- brisk, whether nothing can stand ahead on the last way;
-- clear, whether no brick stands ahead of the place, so that what comes before the effector is another robot;
-- free(line, seen) and alone(line), whether the place is free, and nobody else at work there; contested(line), another's
-- block there; goes_before(place), whether that other is to leave; caught(), whether what is carried has caught on
-- something; begin(), called right before the last way.

local geometry = require 'common.geometry'
local structures = require 'perception.structures'

local SIDE = geometry.SIDE
local ATTEMPTS = 4
local STAND_OFF = 0.30         -- m, from a block, where its approach begins
local LOOSE_STAND_OFF = 0.24   -- m, likewise from one that is loose: at 0.30 robots of adjoining sides meet at a corner
local NEARER = 0.02            -- m, by which it begins nearer where there is no room, down to NEAREST_TURN
local RUN_UP = 0.02            -- m, of one from a robot that faces its line already, farther than the nearest that it begins
local FARTHER = 0.02           -- m, by which it begins farther off after each attempt
local RETREAT = 0.10           -- m, back from one that missed its line
local NEAREST_TURN = 0.22      -- m, from a block, out of its reach for a robot that turns
local FACES_IT, ON_LINE = 0.2, 0.02  -- rad, m, of a robot that faces the block already
local PATIENCE = 8             -- s, the longest random wait for a robot to go its way
local FOLLOWED = 0.03          -- rad off the line, that need no turn before it is followed
local THERE = 0.05             -- m, from the stand-off, near enough
local SPEED = 0.12             -- m/s, while it watches the block
local SLOW = 0.05              -- m/s, close to blocks
local BRISK = 0.08             -- m/s, likewise, where nothing can stand ahead
local LAST_STRAIGHT = 0.025    -- m, in which the line is joined on the last, blind 50 to 85 mm
local NEAREST_LOOK = 0.170     -- m, from a target, for the last look
local FIRST_SIGHTINGS, LAST_SIGHTINGS = 3, 6
local LOOSE_SIGHTINGS = 3      -- the last ones of a block that is loose: magnets draw it into line
local SEEN_LONG = 6            -- sightings after which a block in the picture needs no first look
local SETTLE_TIME = 0.6        -- s, before the first look
local BACKS, BACK = 2, 0.02    -- times, m, back from a block that is out of the picture after a turn
local LONGEST_LOOK = 4         -- s
local LEAVES = 5               -- s, in which another that is to leave has backed out
local AT_PLACE = 0.045         -- m, from where a block is to go, of another's that goes there
local OFF, ASKEW = 0.005, 0.12 -- m and rad off the line, beyond which it tries again
local OVER_FOOT = 0.095        -- height of the lift over a block's foot to see it beside the way
local BESIDE = 0.01            -- m, from the block's line, of a place beside it
local ASIDE_ANGLE = 0.19       -- rad, from the pivot, within which such a block is surely in the picture
local ASIDE_RIM = 0.03         -- m/s
local COLUMN_AHEAD = 0.020     -- m, before the effector
local NEXT_CELL = 0.040        -- m, likewise, nearer than a column two cells on
local EFFECTOR_GAP = 0.0010    -- left between the effector and a column before it, at least: with the effector's 8.5 mm
                               -- before the block little less than its magnets reach
local HELD_OFF = 0.012         -- of a carried block's face from a column's, which would draw it off: the effector is 1 mm farther
                               -- from the column's middle then than one of 60 mm before an adjoining face is wide; from
                               -- 14 mm on blocks that are let down are no longer drawn into line
local LONE_HELD_OFF = 0.010    -- m, likewise of a robot that meets nobody at an adjoining face: the less far a block jumps, the
                               -- less it turns the column's top
local SHORT = 0.015            -- m, by which a higher column behind may keep the effector off its place
local CREEP_SPEED = 0.02       -- m/s
local READINGS, MOST_READINGS = 6, 40  -- of what is ahead, before that, at least and at most
local MEAN_ERROR, FINAL_ERROR = 0.0006, 0.0003  -- m, of their mean, which it takes readings for; and where it ends the way
local UNDER_TOP = 0.0005       -- m, of the lift

local Approach = {}
Approach.__index = Approach

-- What follows what: state, what came of it, the next state or an end.
Approach.TRANSITIONS = {
   travel = { arrived = 'acquire', obstructed = 'give way' },
   acquire = { seen = 'align', unseen = 'retreat', absent = 'absent' },
   align = { seen = 'verify', unseen = 'retreat', obstructed = 'give way' },
   verify = { aligned = 'dock', askew = 'retreat', taken = 'give way' },
   dock = { there = 'docked', obstructed = 'back out', caught = 'come free' },
   retreat = { again = 'travel', exhausted = 'exhausted' },
   ['give way'] = { done = 'busy' },
   ['back out'] = { done = 'busy' },
   ['come free'] = { done = 'caught' },
}
-- How it ends: nothing where it is docked, otherwise why not.
Approach.ENDS = {
   docked = false, absent = 'it is not there', busy = 'busy', exhausted = 'no approach succeeded',
   caught = 'the block has caught',
}

-- parts: description, odometry, process, ranges, camera, tracker, clearance, sweep, path, magnets, lift.
function Approach.new(parts)
   local self = setmetatable({}, Approach)
   for name, part in pairs(parts) do self[name] = part end
   return self
end

-- Whether a target's place is to the side of its block.
local function is_beside(target)
   return math.abs(target.left or 0) > BESIDE
end

-- Parts of it ----------------------------------------------------------------------------------

-- Stands and looks until a block was seen `often` more times; the block as it is now, or nil.
function Approach:look_at(block, often)
   local known = self.tracker:again(block)
   if not known then return nil end
   local before = known.seen
   local function seen()
      known = self.tracker:again(block)
      return not known or known.seen >= before + often
   end
   if not self.process:wait_until(seen, LONGEST_LOOK) then return nil end
   return known
end

-- The block as it is now where it is in the picture, or nil.
function Approach:in_picture(block)
   local known = self.tracker:again(block)
   return known and known.time == self.odometry.time and known or nil
end

-- Whether a block is in the picture where its approach begins: of a high one the lift shows the front
-- only from nearer.
function Approach:begins_in_sight(block)
   return self.camera:farthest_in_sight(self.lift.highest, block) >= STAND_OFF
end

-- With the lift so that the block stays in the picture's middle.
function Approach:watch(block, lowest)
   local mark, before = self.tracker:mark_of(block)
   self.lift:keep_in_sight(self.camera, block, mark, before, lowest)
end

-- Whether a column is just before the effector, which is longer than the block.
function Approach:column_ahead()
   local ahead = self.ranges:range('front')
   return ahead ~= nil and ahead < COLUMN_AHEAD
end

-- Whether something is so near ahead that it would stand in the next cell of a target, as the effector sees from where its
-- way ends.
function Approach:next_cell_filled(target)
   local ahead = self.ranges:range('front')
   return ahead ~= nil and ahead < NEXT_CELL + math.max(0, -(target.short or 0))
end

-- How far what is ahead of the effector is: the mean of as many readings as leave it uncertain by MEAN_ERROR, and less
-- where it is nearer than `near`; nil where nothing is.
function Approach:mean_ahead(near)
   local sum, squares, count = 0, 0, 0
   for reading = 1, MOST_READINGS do
      local ahead = self.ranges:range('front')
      if not ahead then return nil end
      sum, squares, count = sum + ahead, squares + ahead * ahead, reading
      if reading >= READINGS then
         local mean = sum / reading
         local variance = math.max(0, squares / reading - mean * mean) / (reading - 1)
         if variance < (mean < near and FINAL_ERROR or MEAN_ERROR) ^ 2 then break end
      end
      coroutine.yield()
   end
   return sum / count
end

-- Straight on, slowly, as far as that leaves the effector before what is ahead of it, and the block's
-- face `off` it: the effector is longer by a little.
function Approach:creep(way, off, each)
   local longer = self.description.effector.front - self.description.magnets.ahead - SIDE / 2
   local gap = math.max(EFFECTOR_GAP, (off or 0) - longer)
   local ahead = self:mean_ahead(way + gap)
   if ahead then way = math.min(way, ahead - gap) end
   if math.abs(way) > 0.0002 then self.path:go_by(way, CREEP_SPEED, each) end
end

-- How far before a target an approach begins, where there is room, m: farther each time, but so near to a block high up
-- that it is in the picture with the lift at its top.
function Approach:farthest_beginning(run)
   local farther = FARTHER * (run.attempt - 1)
   if run.target.apart then return LOOSE_STAND_OFF + farther end
   local in_sight = self.camera:farthest_in_sight(self.lift.highest, run.block) + (run.target.ahead or 0)
   return math.max(NEAREST_TURN, math.min(STAND_OFF + farther, in_sight))
end

-- How far back it has room to turn, m, up to `most`; 0 where it has nowhere.
function Approach:way_back_to_turn(most)
   local line = self.odometry:line_ahead()
   for back = most, NEARER, -NEARER do
      if self.clearance.room(self.odometry:pivot_on(line, -back)) >= self.sweep.room then return back end
   end
   return 0
end

-- How far from a block, on a line to it, its approach begins, m, and how much room there is about the robot that
-- turns there, m, or more than it takes.
function Approach:stand_off_on(line, run)
   local farthest = self:farthest_beginning(run)
   local needed, best, most = self.sweep.room, farthest, -math.huge
   for nearer = 0, farthest - NEAREST_TURN + 1e-9, NEARER do
      local room = not run.target.apart and needed or
                   self.clearance.room(self.odometry:pivot_on(line, nearer - farthest))
      if room > most then best, most = farthest - nearer, room end
      if most >= needed then break end
   end
   return best, math.min(most, needed)
end

-- The heading, of the four that face a block squarely, that is nearest to the way there, of those that begin
-- where there is room to turn.
function Approach:heading_to(block, run)
   local pose = self.odometry.pose
   local there = math.atan(block.y - pose.y, block.x - pose.x)
   local first = there + geometry.wrap_quarter(block.yaw - there)
   local side = geometry.wrap(there - first) < 0 and -1 or 1
   local best, most = first, -math.huge
   for _, quarters in ipairs { 0, side, -side } do
      local heading = first + quarters * math.pi / 2
      local _, room = self:stand_off_on({ x = block.x, y = block.y, yaw = heading }, run)
      if room > most + 1e-6 then best, most = heading, room end
   end
   return best
end

-- The line to a run's target, squarely to the block's face; it ends there.
function Approach:line_to(block, run)
   local yaw = structures.square_of(block, self.tracker:blocks())
   local square = run.heading + geometry.wrap_quarter(yaw - run.heading)
   local line = { x = block.x, y = block.y, yaw = square }
   line.x, line.y = geometry.out_of(line, run.target.ahead or 0, run.target.left or 0)
   return line
end

-- Likewise to the block as it is seen by now; nil when it is lost.
function Approach:line_now(run)
   local known = self.tracker:again(run.block)
   if not known then return nil end
   run.block = known
   self:watch(known, run.lowest)
   return self:line_to(known, run)
end

-- The line of the last, blind way.
function Approach.aim(_, run)
   return run.line
end

-- Height of the lift for the last look, and the distance of the block for it.
function Approach:last_look(run)
   local mark, before = self.tracker:mark_of(run.block)
   if not is_beside(run.target) then
      return run.lowest, self.camera:nearest_in_sight(run.lowest, mark, before)
   end
   -- a block to the side leaves the picture sooner
   local height = geometry.clamp(SIDE * (run.block.level or 0) + OVER_FOOT, run.lowest,
                                 self.lift.highest - UNDER_TOP)
   return height, self.camera:centred_at(height, mark, before)
end

-- Looks `often`, turned to the block no more than it takes: odometry takes a small turn for less than it
-- is.
function Approach:look_aside(block, often)
   local ahead, left = geometry.into(self.odometry.pose, block.x, block.y)
   local away = ahead - self.odometry.ahead
   local aside = math.max(self.camera:farthest_aside(self.lift:height(), block, ahead), 0)
   local angle, within = math.atan(left, away), math.min(ASIDE_ANGLE, math.atan(aside, away))
   local turn = angle - geometry.clamp(angle, -within, within)
   if turn ~= 0 then self.path:turn_by(turn, ASIDE_RIM) end
   local seen = self:look_at(block, often)
   if turn ~= 0 then self.path:turn_by(-turn, ASIDE_RIM) end
   return seen
end

-- After turns, which leave a robot nearer to a block or farther aside than its wheels tell: goes back, with the
-- lift at a height, until the block is in the picture again. Whether it is.
function Approach:sight_again(run, height)
   -- one to the side is out of the picture until the robot turns to it
   if is_beside(run.target) then return true end
   self.lift:to(height)
   -- by a picture since those turns
   coroutine.yield()
   local function in_sight() return self:in_picture(run.block) ~= nil end
   for _ = 1, BACKS do
      if self.process:wait_until(in_sight, SETTLE_TIME) then return true end
      self.path:back_off(BACK)
   end
   return self.process:wait_until(in_sight, SETTLE_TIME)
end

-- To where the straight way begins. Whether nobody is in the way.
function Approach:go_to_stand_off(run)
   local clearance, odometry = self.clearance, self.odometry
   -- out of reach of the block before turning
   local more = self.sweep.from_block - geometry.apart(odometry:pivot(), run.block)
   if more > 0 then self.path:back_off(more + FARTHER) end
   local x, y = odometry:pivot_on(run.line, -self:stand_off_on(run.line, run))
   local function left() return geometry.apart(odometry:pivot(), { x = x, y = y }) end
   local function meets() return clearance:meets(left()) end
   for _ = 1, 3 do
      self.path:go_to(x, y, nil, meets)
      if not meets() then break end
      self.process:wait(PATIENCE * math.random())
   end
   return not meets() or left() <= THERE
end

-- States ---------------------------------------------------------------------------------------

local states = {}
Approach.states = states

-- How near the block an approach may begin: out of its reach, and, where it is beside the way and below, so far off
-- that it is in the picture.
function Approach:nearest_beginning(run)
   if not is_beside(run.target) then return NEAREST_TURN end
   local in_sight = self.camera:nearest_in_sight(run.lowest, self.tracker:mark_of(run.block))
   return math.max(NEAREST_TURN, math.min(self:farthest_beginning(run), in_sight))
end

function states.travel(self, run)
   self.process:enter('approach')
   run.heading = run.target.heading or self:heading_to(run.block, run)
   run.line = self:line_to(run.block, run)
   local along, aside, angle = self.odometry:on_line(run.line)
   local first, least = run.attempt == 1, self:nearest_beginning(run)
   if first and along > -least and math.abs(aside) < ON_LINE and math.abs(angle) < FACES_IT then
      -- it faces it already, and a turn sweeps more than going back
      self.path:follow_back(run.line, -math.min(self:stand_off_on(run.line, run), least + RUN_UP), 0.1)
   end
   along, aside = self.odometry:turned_onto(run.line)
   if first and along <= -least and math.abs(aside) <= ON_LINE then return 'arrived' end
   return self:go_to_stand_off(run) and 'arrived' or 'obstructed'
end

-- Whether a block is in the picture, and was for a while.
function Approach:is_in_view(block)
   local known = self:in_picture(block)
   return known ~= nil and known.seen >= SEEN_LONG
end

function states.acquire(self, run)
   if math.abs(geometry.wrap(run.line.yaw - self.odometry.pose.yaw)) > FOLLOWED then self.path:turn_to(run.line.yaw) end
   self:watch(run.block, run.lowest)
   if self:is_in_view(run.block) then return 'seen' end
   self.process:wait_until(function() return self:in_picture(run.block) ~= nil end, SETTLE_TIME)
   if self:is_in_view(run.block) or self:look_aside(run.block, FIRST_SIGHTINGS) then return 'seen' end
   if run.attempt > 1 then return 'unseen' end
   self.tracker:forget(run.block)
   return 'absent'
end

function states.align(self, run)
   local height, distance = self:last_look(run)
   local to = -math.max(distance + (run.target.ahead or 0), NEAREST_LOOK)
   local function line() return self:line_now(run) end
   local function between() return self.clearance:between(self.odometry:distance_to(run.block)) end
   local there = self.path:follow(line, to, SPEED, between)
   if between() then return 'obstructed' end
   if there and run.target.alone then
      if not run.target.alone(line() or run.line) then return 'obstructed' end
      there = self:sight_again(run, height) and self.path:follow(line, to, SPEED, between)
   end
   if not there then return 'unseen' end
   self.lift:to(height)
   run.seen = self:look_aside(run.block, run.target.apart and LOOSE_SIGHTINGS or LAST_SIGHTINGS)
   return run.seen and 'seen' or 'unseen'
end

function states.verify(self, run)
   run.line = self:line_to(run.seen, run)
   local _, off, angle = self.odometry:on_line(run.line)
   if run.target.free and not run.target.free(run.line, run.seen) then return 'taken' end
   if math.abs(off) < OFF and math.abs(angle) < ASKEW then return 'aligned' end
   run.block = run.seen
   return 'askew'
end

-- Where another robot is met on the last way: ahead, in the cell behind the place, or with its block about the place.
function Approach:met_at(run, line)
   local target = run.target
   if target.clear and self:next_cell_filled(target) then
      local x, y = geometry.out_of(line, SIDE, 0)
      return { x = x, y = y }
   end
   return target.contested and target.contested(line)
end

-- Whether another that was met on the last way leaves, soon, rather than puts its block down where this one's is to go: its
-- block was not last seen there, nor did the rangefinder lose its effector at once, as where the lift goes down.
function Approach:await_leaving(run, line, met)
   local target, ahead = run.target, nil
   local felt = target.clear and self:next_cell_filled(target)
   local left = self.process:wait_until(function()
      local other = self:met_at(run, line)
      met, ahead = other or met, self.ranges:range('front')
      return not other
   end, LEAVES)
   if felt then return left and ahead ~= nil end
   return left and geometry.apart(met, line) > AT_PLACE
end

-- Along the last way: there, obstructed or caught; and whether a column ahead has ended it before. Where another is met who
-- is to leave, it waits for that, once.
function Approach:follow_last(run, line, to)
   local target, met, caught, stopped = run.target, nil, false, false
   local speed = target.brisk and BRISK or SLOW
   local function ends()
      met, caught = self:met_at(run, line), target.caught and target.caught() or false
      -- told once: of what is as far as that, every other reading says that it is farther
      stopped = stopped or target.stop and target.stop()
      return met or caught or stopped
   end
   self.path:follow(line, to, speed, ends, LAST_STRAIGHT)
   if met and not caught and target.goes_before and target.goes_before(met) and
      self:await_leaving(run, line, met) then
      stopped = false
      self.path:follow(line, to, speed, ends, LAST_STRAIGHT)
   end
   return caught and 'caught' or met and 'obstructed' or 'there', stopped
end

function states.dock(self, run)
   self.process:enter('reach')
   local line = self:aim(run)
   if run.target.begin then run.target.begin() end
   local to = -self.description.magnets.ahead + (run.target.short or 0)
   local came, stopped = self:follow_last(run, line, to)
   if came ~= 'there' or not stopped then return came end
   -- the column draws the block, which is held until it has been let down
   self.magnets:hold_fast(true)
   self:creep(to - self.odometry:on_line(line), run.target.alone and HELD_OFF or LONE_HELD_OFF)
   -- so far before its place stands no column, but another robot
   return to - self.odometry:on_line(line) > SHORT and 'obstructed' or 'there'
end

function states.retreat(self, run)
   self.process:enter('back off')
   self.path:back_off(run.target.apart and self:way_back_to_turn(RETREAT) or RETREAT)
   run.block = self.tracker:again(run.block) or run.block
   run.attempt = run.attempt + 1
   return run.attempt <= ATTEMPTS and 'again' or 'exhausted'
end

states['give way'] = function(self)
   self.path:back_off(0.10)
   return 'done'
end

states['back out'] = function(self)
   self.path:back_off(0.15)
   self.magnets:hold_fast(false)
   return 'done'
end

states['come free'] = states['back out']

-- True and the block as it was last seen, or false and why not.
function Approach:to(target)
   local lowest = math.max(target.lowest, SIDE * (target.block.level or 0) + self.lift.OVER_BLOCK)
   local run = {
      target = target, block = target.block, attempt = 1,
      lowest = math.min(lowest, self.lift.highest - UNDER_TOP),
   }
   local state = 'travel'
   while states[state] do
      state = Approach.TRANSITIONS[state][states[state](self, run)]
   end
   local problem = Approach.ENDS[state]
   return not problem, problem or run.seen
end

return Approach
