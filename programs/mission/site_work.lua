-- SPDX-License-Identifier: MIT
-- Work at the structure: chooses a row, looks at its column, asks the rules what to do there, and does
-- it. Each behaviour returns the event that it ends with.

local geometry = require 'common.geometry'
local Column = require 'mission.column'
local Navigation = require 'motion.navigation'

local SIDE, apart = geometry.SIDE, geometry.apart
local LOOK_TIME = 1.0          -- s, for each look
local PEEK_FROM, PEEK = 0.19, 0.8  -- m from a site, rad to each side
local PEEK_RIM = 0.05          -- m/s, of that turn, at most: a robot stands across several measurements
local PEEK_STOP = 0.2          -- rad, in which it ends
local PEEK_TIME = 0.6          -- s
local AT_SITE = 0.22           -- m, from a site, where others are in the way
local COMES_UP = 0.03          -- m, before the effector, likewise on the way in along a row's line
local OF_ONE, GOES = 0.03, 25  -- m, s: what is seen there again after so long stands for good
local LATEST = 0.25            -- part of the last approach in their mean time
local BUSY = 10                -- s, the longest wait where another robot is at a row
local OBSTRUCTED = 6           -- a robot that was obstructed more often goes to another side
local EXPLORES = 3             -- rounds in vain, from which on it looks beyond the rows it knows
local FAR_EXPLORES = 7         -- likewise farther beside them, where another side of the structure may begin
local FAR_BESIDE, FAR_IN = { 3, 6 }, 4  -- cells beside the outermost row, in turn, and in from the foremost brick: as
                               -- near as a robot passes a row that juts out
local ROUNDS = 3               -- likewise one that found nothing to do so often, before its first brick
local AWAKE, RESTS = 1, 6      -- rounds in vain, after which each rest is twice as long as the one before, so often
local AT_WORK = 0.12           -- m, from the structure, that blocks in others' hands are counted
local NEXT_SITE = 0.20         -- m, likewise from the site that a robot goes to
local PAST_LOOK = 0.11         -- m, and from the nearest brick's edge, nearer than who stands for a look holds his
local QUEUE, QUEUES = 4, 5     -- s, the longest wait after another's work was seen to end; so often at most
local TURN_HEIGHT = 0.070      -- of the lift, to turn near the structure
local ASIDE, ASKEW = 0.015, 0.5  -- m and rad off a row's line, beyond which it is driven to anew
local TOO_FAR = 0.20           -- m, likewise, from where it looks
-- m and rad off the line at a look, beyond which what is asked for may be out of the picture: the compiler
-- leaves a margin of 2 % of its width
local LOOKS_ASIDE, LOOKS_ASKEW = 0.004, 0.03
local REJOIN, REJOINS = 0.10, 2  -- m, back and up again, in which the line is joined; so often at most

-- tried: rows of this side that asked for nothing; explored: ways beside its rows that were gone, 1 to the left, -1 to
-- the right. in_vain: how often all rows of a side were tried since the last brick; rounds: likewise of this side.
-- patience: how often it tries them before it goes elsewhere, of sides that are shared: once, and twice as often each
-- time. obstructed: how often somebody was in the way, or nothing to be done, since the last brick. standing: what
-- stands near sites, and may be robots: {x, y, since}. row: {v, front, frame, juts}, the one it stands before; unfound:
-- v of the row at which the last approach did not find its brick. wish: what is to be done there (Column:decide).
-- approach_time: mean of the last approaches to a site, s.
local SiteWork = {}
SiteWork.__index = SiteWork

function SiteWork.new(machine, map, navigation, sides, record, task)
   return setmetatable({
      machine = machine, odometry = machine.odometry, process = machine.process, path = machine.path,
      lift = machine.lift, magnets = machine.magnets, clearance = machine.clearance,
      placement = machine.placement, map = map, navigation = navigation, sides = sides,
      record = record, task = task,
      tried = {}, explored = {}, in_vain = 0, rounds = 0, patience = ROUNDS, obstructed = 0, standing = {}, approach_time = 0,
   }, SiteWork)
end

-- Another robot was in the way.
function SiteWork:give_up()
   self.obstructed = self.obstructed + 1
   self.record:tally('aborted')
   self.record:tally('busy')
end

-- From a side that the robot has come to, all rows may be tried.
function SiteWork:begin_side()
   self.tried, self.explored, self.unfound = {}, {}, nil
end

-- The row, of those not tried yet, that juts out furthest; of several the one straight ahead, which
-- keeps robots apart that work from several sides.
function SiteWork:choose_row()
   if not self.magnets:holds() then return 'dropped' end
   if self.obstructed > OBSTRUCTED and #self.task.sides > 1 then return 'none' end
   local rows = self.map:rows()
   if not rows then return 'lost' end
   self.row = nil
   local least
   for _, of in pairs(rows) do
      if not self.tried[of.v] and self.map.room_before(rows, of) then
         local _, aside = self.odometry:on_line(self.map.line_before(of))
         local order = math.abs(aside) - of.front
         if not self.row or order < least then self.row, least = of, order end
      end
   end
   self.row = self.row or self:flank_of(rows)
   return self.row and 'chosen' or 'none'
end

-- Whether the robot tries the rows of one side again and again, before it goes to another.
function SiteWork:keeps_to_side()
   return #self.task.sides == 1 or self.sides:are_shared()
end

-- How often all rows of all its sides were tried, or of the one that it keeps to, since the last brick.
function SiteWork:idle_rounds()
   return self.in_vain // (self:keeps_to_side() and 1 or #self.task.sides)
end

-- A place beside the outermost rows that are known, as if a row began there, or nil: others may have built
-- where no look at a known row shows it. Whoever is alone has seen what it built. The row begins where the outermost one
-- does; in far looks, as far behind the foremost as a robot passes it.
function SiteWork:flank_of(rows)
   local round = self:idle_rounds() + 1
   if self.task.delay == 0 or round < EXPLORES then return nil end
   local far = round >= FAR_EXPLORES and FAR_BESIDE[(round - FAR_EXPLORES) % #FAR_BESIDE + 1]
   local first, last, front = math.huge, -math.huge, -math.huge
   for v, of in pairs(rows) do
      first, last, front = math.min(first, v), math.max(last, v), math.max(front, of.front)
   end
   for way = 1, -1, -2 do
      if not self.explored[way] then
         self.explored[way] = true
         local outer = rows[way > 0 and last or first]
         local row = { v = outer.v + way * (far or 1), frame = outer.frame, flank = true }
         row.front = far and front - FAR_IN or outer.front
         row.juts = far and 0 or self.map.juts_beside(rows, row)
         return row
      end
   end
end

-- Waits before it tries its rows again: a moment, or, after several rounds in vain, ever longer, until it sees a brick
-- that it had not seen before.
function SiteWork:rest()
   local map, more = self.map, geometry.clamp(self:idle_rounds() - AWAKE, 0, RESTS)
   local time = (2 + 4 * math.random()) * 2 ^ more
   if more == 0 then return self.process:wait(time) end
   self.lift:to(self.lift:top())
   local before = map:count_bricks()
   self.process:wait_until(function() return map:rows() ~= nil and map:count_bricks() > before end, time)
end

-- All rows were tried, or somebody was in the way once too often. Whether the robot stays here for a
-- while, since others' work may open a row.
function SiteWork:stays()
   self.tried, self.explored, self.rounds, self.in_vain = {}, {}, self.rounds + 1, self.in_vain + 1
   self.sides:withdraw()
   if not self:keeps_to_side() then
      -- once a way round; for who is alone nobody opens a row
      if self.task.delay > 0 and self.in_vain % #self.task.sides == 0 then self:rest() end
   elseif #self.task.sides == 1 or self.obstructed <= OBSTRUCTED and self.rounds < self.patience then
      self:rest()
      return true
   end
   self.obstructed, self.rounds, self.patience = 0, 0, 2 * self.patience
   return false
end

-- Says whether another robot stands before the row, on the way in along a line, or beside it so that its arm may be there.
function SiteWork:in_between(line)
   local function counts(point) return self:comes_and_goes(point) end
   return function()
      return self.clearance:between(-self.odometry:on_line(line)) or self.clearance:meets_arm_ahead(COMES_UP, counts)
   end
end

-- Along the row's line, or what a function says of it in each step, up to a place `away` from its column.
-- Whether nobody is in the way.
function SiteWork:come_up(line, away, speed)
   local in_between = self:in_between(type(line) == 'function' and line() or line)
   self.path:follow(line, -away, speed, in_between)
   return not in_between()
end

-- Distance of the robot's middle from a column, for a look.
function SiteWork:distance_for(look)
   return self.machine.camera:place_when_down() + look.distance + SIDE / 2
end

-- Whether the robot is too far off a row's line to come up along it, once it has turned.
function SiteWork:is_off(line, away)
   local _, _, angle = self.odometry:on_line(line)
   local along, aside = self.odometry:turned_onto(line)
   return math.abs(aside) > ASIDE or along > -away + 0.01 or along < -away - TOO_FAR or
          math.abs(angle) > ASKEW
end

-- To where a row's line is come up along. Whether it is reached.
function SiteWork:go_before(line, away)
   self.lift:to(math.max(self.lift:height(), TURN_HEIGHT))
   local x, y = self.odometry:pivot_on(line, -away - 0.03)
   -- where there is room to turn before the cache
   local cache = self.map.cache
   if cache and apart(cache, { x = x, y = y }) < Navigation.BEFORE_CACHE then
      x, y = self.odometry:pivot_on(line, -away)
   end
   return self.navigation:to(x, y)
end

function SiteWork:stand_before()
   local line = self.map.line_before(self.row)
   -- where what juts out beside is not swept in a turn
   local away = self:distance_for(self.task.looks[1]) + self.row.juts
   if self:is_off(line, away) and not self:go_before(line, away) then
      self:give_up()
      return 'blocked'
   end
   self.path:turn_to(line.yaw)
   if self:come_up(line, away, 0.10) then return 'there' end
   -- another robot is at the row: out of its way, and another try after a while
   self.path:back_off(0.10)
   self.process:wait(BUSY * math.random())
   self:give_up()
   return 'blocked'
end

-- To where a look is from, on the row's line as the structure is seen by now: once more where the way
-- there was too short to join it, or the structure was known too coarsely before. Whether nobody is in the
-- way.
function SiteWork:stand_for(column, look)
   local away = self:distance_for(look)
   local function line()
      local rows = self.map:rows()
      return self.map.line_before(rows and rows[column.row.v] or column.row)
   end
   for attempt = 1, REJOINS + 1 do
      if attempt > 1 then self.path:follow_back(line(), -away - REJOIN, 0.08) end
      if not self:come_up(attempt > 1 and line or line(), away, 0.08) then return false end
      if not self.lift:is_below(look.lift) and not self.clearance:await_room_below() then return false end
      self.lift:to(look.lift)
      local _, aside, angle = self.odometry:on_line(line())
      if math.abs(aside) < LOOKS_ASIDE and math.abs(angle) < LOOKS_ASKEW then break end
   end
   return true
end

-- Whether somebody is seen to hold a block near the structure.
function SiteWork:sees_held()
   local known = self.map.known
   return known ~= nil and self.placement:held_near(known.x, known.y, known.reach + AT_WORK)
end

-- Stays while somebody is seen at work, and a random while longer: whoever else waits has seen the same.
function SiteWork:queue()
   for _ = 1, QUEUES do
      if not self.process:wait_until(function() return self:sees_held() end, 0.2) then return end
      self.process:wait_until(function() return not self:sees_held() end, BUSY)
      self.process:wait(QUEUE * math.random())
   end
end

-- Sees the column from one place. Whether nobody is in the way.
function SiteWork:look_from(column, look)
   if not self:stand_for(column, look) then return false end
   if self.task.delay > 0 then self:queue() end
   local start = self.odometry.time
   while self.odometry.time - start < LOOK_TIME do
      coroutine.yield()
      column:watch()
   end
   return true
end

-- From the lift's top, from which bricks are seen that are farther off than those that a row's decision needs.
function SiteWork:survey()
   self.lift:to(self.lift:top())
   self.process:wait(LOOK_TIME)
   self.map:rows()
end

-- Back from a row beside which others jut out, to where a turn does not sweep them.
function SiteWork:leave(row)
   if row.juts > 0 then self.path:back_off(row.juts) end
end

function SiteWork:look()
   local machine, chosen = self.machine, self.row
   local column = Column.new(self.odometry, machine.tracker, machine.sight, self.map, self.task, self.row)
   for _, look in ipairs(self.task.looks) do
      if not self:look_from(column, look) then
         self.path:back_off(0.10)
         self.tried[self.row.v] = true
         self:give_up()
         return 'unseen'
      end
      -- whoever is alone knows what stands beside the site without looking
      if self.task.delay == 0 and self.map.known and column:decide() then break end
   end
   self.row = column.row
   if not self.magnets:holds() then return 'dropped' end
   -- a structure that was pushed away meanwhile is looked for before anything is put to it
   if not self.map.known then
      self.record:tally('aborted')
      return 'unseen'
   end
   local wish, top_seen = column:decide()
   self.record:tell('branch', tostring(wish and wish.branch or 'none'))
   self.record:tell('told', table.concat(column.told, '; '))
   self.wish = wish
   if wish then return 'decided' end
   if chosen.flank then
      self:survey()
      self:leave(chosen)
      return 'nothing'
   end
   self.tried[self.row.v] = true
   self:leave(self.row)
   if top_seen then return 'nothing' end
   if self.row.by_heart then self.map:forget_row(self.row) end
   self.record:tally('aborted')
   return 'unseen'
end

-- Whether a point is no part of what stands there for good: robots leave after a while.
function SiteWork:comes_and_goes(point)
   for _, known in ipairs(self.standing) do
      if apart(known, point) < OF_ONE then return self.odometry.time - known.since < GOES end
   end
   table.insert(self.standing, { x = point.x, y = point.y, since = self.odometry.time })
   return true
end

-- Whether somebody holds a block near the structure, as a look over the column and to both sides tells: with
-- the lift at its top, since the picture's upper edge cuts off what another holds as high and as far away. What
-- is seen on the way counts at once: by the end of a slow turn it would be long ago.
function SiteWork:sees_others_work(line)
   local returns = self.machine.returns
   local function is_at_work(block) return self.map:room_about(block.x, block.y) < PAST_LOOK end
   local function held() return self.placement:held_near(line.x, line.y, NEXT_SITE, is_at_work) end
   local drive = self.machine.description.drive
   local rim = math.min(PEEK_RIM, math.sqrt(PEEK_STOP * drive.acceleration * drive.track))
   self.lift:to(self.lift:top())
   local busy = self.process:wait_until(held, PEEK_TIME)
   for _, angle in ipairs { -PEEK, PEEK } do
      local turn = geometry.wrap(line.yaw + angle - self.odometry.pose.yaw)
      if not busy and not returns:sweeps(turn, self.lift:height()) then
         self.path:swing_to(line.yaw + angle, rim, held)
      end
      busy = busy or held()
   end
   self.path:turn_to(line.yaw, rim, function()
      busy = busy or held()
      return false
   end)
   return busy
end

-- Whether no other robot is at work about the end of a line, as a look to both sides tells.
-- Who passes here stays nearer than PEEK_FROM until it has put its block down, where the others
-- see it from the places from which they look in their turn: of two robots at work on adjoining
-- sides, the one that looks last sees the other. On the far side one hides behind the column: what
-- it holds is seen over that.
function SiteWork:is_alone(line)
   self.path:follow_back(line, -PEEK_FROM, 0.08)
   local start = self.odometry.time
   local busy = self:sees_others_work(line)
   for _, point in ipairs(self.machine.returns:near(line.x, line.y, AT_SITE, start)) do
      busy = busy or self:comes_and_goes(point)
   end
   return not busy
end

-- What leads to the site: a brick, how the site lies from it, and how far that is to its left, m. The highest of the
-- column that is in the picture from where an approach begins; before one that hangs over, with none such below it, a
-- brick next to the site.
function SiteWork:guide_of(wish)
   if wish.what == 'raise' then return wish.top, 'raise', 0 end
   local left, approach = (wish.left or 0) * SIDE, self.machine.approach
   for _, brick in ipairs(wish.feet) do
      if approach:begins_in_sight(brick) then return brick, wish.what, left end
   end
   for _, next_to in ipairs(wish.next_to) do
      if approach:begins_in_sight(next_to.brick) then return next_to.brick, 'beside', -next_to.left * SIDE end
   end
   return wish.feet[1] or wish.top, wish.what, left
end

function SiteWork:approach_site()
   local wish, start = self.wish, self.odometry.time
   local guide, where, left = self:guide_of(wish)
   local near, problem = self.placement:approach_site(guide, where, {
      heading = self.row.frame.yaw, level = wish.level, left = left,
      over = wish.what == 'beside' and self:stands_free(),
      aside = wish.aside, open = wish.open, colour = wish.colour, clear = wish.clear and self.task.delay > 0,
      alone = self.task.delay > 0 and function(line) return self:is_alone(line) end or nil,
   })
   local mean, took = self.approach_time, self.odometry.time - start
   self.approach_time = mean == 0 and took or mean + LATEST * (took - mean)
   if near then
      self.unfound = nil
      return 'near'
   end
   if problem == 'busy' then
      self.sides:withdraw()
      self:give_up()
      return 'busy'
   end
   self.record:tally('aborted')
   if problem == 'the block was lost' then return 'dropped' end
   -- what was not found twice is looked for from elsewhere
   if self.unfound == self.row.v then self.tried[self.row.v] = true end
   self.unfound = self.row.v
   return 'lost'
end

-- Where the block goes, and on which level.
function SiteWork:place_of_wish()
   local wish = self.wish
   local x, y = self.map.place_of(self.row, wish.what == 'extend' and 1 or 0, wish.left or 0)
   return x, y, wish.level or geometry.level_of(wish.top.z) + 1
end

-- Whether the place beside a column is on a brick, with none behind it that would stop a block on its way in.
function SiteWork:stands_free()
   local x, y, level = self:place_of_wish()
   local behind_x, behind_y = self.map.place_of(self.row, -1, self.wish.left)
   return level > 0 and self.map:had_brick(x, y, level - 1) and not self.map:had_brick(behind_x, behind_y, level)
end

-- The map has what the robot has put down, though no look may show it.
function SiteWork:note_placed()
   if self.map.known then self.map:note_brick(self:place_of_wish()) end
end

function SiteWork:attach()
   local drawn = self.map:draws_aside(self:place_of_wish())
   if not self.placement:attach(self.wish.colour, drawn) then
      self.record:tally('aborted')
      return 'failed'
   end
   self:leave(self.row)
   self:note_placed()
   self.tried, self.wish, self.obstructed, self.patience = {}, nil, 0, 1
   self.rounds, self.in_vain = 0, 0
   self.record:tally('placed')
   return 'placed'
end

return SiteWork
