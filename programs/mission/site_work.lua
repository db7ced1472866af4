-- SPDX-License-Identifier: MIT
-- Work at the structure: chooses a row, looks at its column, asks the rules what to do there, and does
-- it. Each behaviour returns the event that it ends with.

local geometry = require 'common.geometry'
local Column = require 'mission.column'
local ColourFaults = require 'mission.colour_faults'
local Navigation = require 'motion.navigation'
local Prospects = require 'mission.prospects'
local RightOfWay = require 'mission.right_of_way'
local Turns = require 'mission.turns'

local SIDE, apart = geometry.SIDE, geometry.apart
local LOOK_TIME = 1.0          -- s, for each look
local LATEST = 0.25            -- part of the last approach in their mean time
local BUSY = 10                -- s, the longest wait where another robot is at a row
local OBSTRUCTED = 6           -- a robot that was obstructed more often goes to another side
local EXPLORES = 3             -- rounds in vain, from which on it looks beyond the rows it knows
local FAR_EXPLORES = 7         -- likewise farther beside them, where another side of the structure may begin
local FAR_BESIDE, FAR_IN = { 3, 6 }, 4  -- cells beside the outermost row, in turn, and in from the foremost brick: as
                               -- near as a robot passes a row that juts out
local NOT_DUE = 1e4            -- more than any order of rows
local STALLED = 90             -- s, at least, and twice that at most, with no change seen, after which one leaves its side
local LOOKS_ALONG, IN_PICTURE = 60, 0.25  -- s, between looks along the rows in a rest; rad, of what is seen without a turn
local AWAKE = 1                -- rounds in vain, after which it rests ever longer:
local RESTS, SHARED_RESTS = { longer = 4, longest = 256 }, { longer = 2, longest = 64 }  -- so many times as long as before, up to
                               -- so many times the first, on a side of its own, and on one that is shared
local WATCHES, NAP, GLANCE = 60, 4, 1  -- s, into a rest, from which on it pauses so long between looks of so long
local FAULT_LASTS = 15         -- s, that a brick was seen to show a colour that it should not, before it is coloured anew
local TELLINGS = 3             -- so often one is told at most: its LEDs may be dead
local STAYS_OFF = 0.012        -- m, of the block from right over it meanwhile: a column behind would draw it off
local TURN_HEIGHT = 0.070      -- of the lift, to turn near the structure
local ASIDE, ASKEW = 0.015, 0.5  -- m and rad off a row's line, beyond which it is driven to anew
local TOO_FAR = 0.20           -- m, likewise, from where it looks
-- m and rad off the line at a look, beyond which what is asked for may be out of the picture: the compiler
-- leaves a margin of 2 % of its width
local LOOKS_ASIDE, LOOKS_ASKEW = 0.004, 0.03
local REJOIN, REJOINS = 0.10, 2  -- m, back and up again, in which the line is joined; so often at most

-- tried: rows of this side that asked for nothing; explored: ways beside its rows that were gone, 1 to the left, -1 to
-- the right. in_vain: how often all rows of a side were tried since the last brick. news: when, s, there were last more
-- bricks, or fewer, than the robot knew, and how many there are. patience: s after that in which it keeps to its side,
-- where sides are shared and manned; twice as long each time. obstructed: how often somebody was in the way, or nothing
-- to be done, since the last brick. row: {v, front, frame, juts}, the one it stands before; unfound: v of the row at which the
-- last approach did not find its brick. column: as it looked at it; wish: what is to be done there (Column:decide).
-- approach_time: mean of the last approaches to a site, s. yielded: it has just left a site to another. fault: a brick of a
-- wrong colour that was seen, and since when (see_to_faults); mended: by cell, how often one was told its colour. fronts: by v,
-- the front of rows of this side as they were looked at since it last came to it. at_home: it has put a brick here since then;
-- contested: it has not, and somebody was in its way.
local SiteWork = {}
SiteWork.__index = SiteWork

-- That of a robot that has just begun, or put a brick: robots that see nothing change at the same time leave one by one.
local function patience_at_first()
   return STALLED * (1 + math.random())
end

function SiteWork.new(machine, map, navigation, sides, record, task)
   local turns = Turns.new(machine, map, sides, task)
   return setmetatable({
      machine = machine, odometry = machine.odometry, process = machine.process, path = machine.path,
      lift = machine.lift, magnets = machine.magnets, clearance = machine.clearance,
      placement = machine.placement, map = map, navigation = navigation, sides = sides,
      record = record, task = task, prospects = Prospects.new(map, sides, task), turns = turns,
      right_of_way = RightOfWay.new(machine, map, sides, turns, task),
      tried = {}, explored = {}, in_vain = 0, news = { time = 0 }, patience = patience_at_first(),
      obstructed = 0, fronts = {}, at_home = true, approach_time = 0, yielded = false, mended = {},
   }, SiteWork)
end

-- Another robot was in the way.
function SiteWork:give_up()
   self.contested = not self.at_home
   self.obstructed = self.obstructed + 1
   self.record:tally('aborted')
   self.record:tally('busy')
end

-- From a side that the robot has come to, all rows may be tried.
function SiteWork:begin_side()
   self.tried, self.explored, self.unfound = {}, {}, nil
end

-- No more to a row of this side, until all were tried.
function SiteWork:set_aside(v)
   local side = self.map.side
   self.tried[v] = true
   -- the structure may have been lost meanwhile
   if not side then return end
   self.prospects:note_in_vain(side, v)
end

-- Whether the robot goes to another of its sides at once, since a row is due there, and none here.
function SiteWork:leaves_for_due()
   self.sides.wanted = self.prospects:due_at_once(self:keeps_to_side())
   return self.sides.wanted ~= nil
end

-- Whether somebody else builds from this side, where there are fewer robots than sides: somebody was in the way before the
-- robot had put a brick here, or a row has grown since it looked at it. From the edge nobody is seen who is at a row, and
-- two that come at the same time, from both edges, do not see each other.
function SiteWork:is_worked_by_others(rows)
   local others = self.contested
   for v, front in pairs(self.fronts) do others = others or rows[v] and rows[v].front > front end
   return others and self.sides:are_fewer()
end

-- Leaves the side to whoever else builds from it, if there may be work at another.
function SiteWork:leaves_to_others()
   local sides, side = self.sides, self.map.side
   sides.taken[side], sides.worked = false, side
   sides.wanted = self.prospects:likely_side()
   return sides.wanted ~= nil
end

-- Whether a row is worth a look, of those that may be due: on the first way round sides that others build at, too, only where
-- a brick is missing, as far as the robot remembers.
function SiteWork:worth_a_look()
   local unfinished = self:idle_rounds() == 0 and self.sides:are_shared() and self.prospects:unfinished_from(self.map.side)
   return function(v) return not unfinished or unfinished[v] ~= nil end
end

-- The row, of those not tried yet, that is due as far as the robot remembers, or else any; of several the one that juts
-- out furthest, and of these the one straight ahead, which keeps robots apart that work from several sides.
function SiteWork:choose_row()
   if not self.magnets:holds() then return 'dropped' end
   if self.obstructed > OBSTRUCTED and #self.task.sides > 1 then return 'none' end
   local rows = self.map:rows()
   if not rows then return 'lost' end
   self.row = nil
   if self:is_worked_by_others(rows) and self:leaves_to_others() then return 'none' end
   local due, worth, least = self.prospects:due_from(self.map.side), self:worth_a_look(), nil
   for _, of in pairs(rows) do
      if not self.tried[of.v] and (due[of.v] or worth(of.v)) and self.map.room_before(rows, of) then
         local _, aside = self.odometry:on_line(self.map.line_before(of))
         local order = math.abs(aside) - of.front + (due[of.v] and 0 or NOT_DUE)
         if not self.row or order < least then self.row, least = of, order end
      end
   end
   if not (self.row and due[self.row.v]) and self:leaves_for_due() then return 'none' end
   self.row = self.row or self:flank_of(rows)
   return self.row and 'chosen' or 'none'
end

-- Whether the robot tries the rows of one side again and again, before it goes to another.
function SiteWork:keeps_to_side()
   return #self.task.sides == 1 or self.sides:are_manned()
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

-- Turns to where a row would begin beside the outermost on each side, as far as these are out of the picture, until
-- `seen()`.
function SiteWork:look_along(seen)
   local map, odometry = self.map, self.odometry
   local rows, first, last = map:rows(), math.huge, -math.huge
   if not rows then return end
   local heading = map:heading_of(map.side)
   for v in pairs(rows) do first, last = math.min(first, v), math.max(last, v) end
   for _, outer in ipairs { { v = first, beside = -1 }, { v = last, beside = 1 } } do
      local x, y = map.place_of(rows[outer.v], 0, outer.beside)
      local way = geometry.wrap(math.atan(y - odometry.pose.y, x - odometry.pose.x) - heading)
      local turn = math.max(0, math.abs(way) - IN_PICTURE) * (way < 0 and -1 or 1)
      if turn ~= 0 and not seen() and not self.machine.returns:sweeps(turn, self.lift:height()) then
         self.path:turn_to(heading + turn, nil, seen)
         self.process:wait_until(seen, LOOK_TIME)
         self.path:turn_to(heading)
      end
   end
end

-- Until when, s, a robot keeps to its side that may leave it: where nothing has changed for long, as far as it has seen, who
-- works elsewhere may have broken down.
function SiteWork:keeps_until()
   if #self.task.sides == 1 or not self.sides:are_manned() then return math.huge end
   local count = self.map:count_bricks()
   if count ~= self.news.count then self.news = { count = count, time = self.odometry.time } end
   return self.news.time + self.patience
end

-- `seen()`, asked in each step of a rest since a time. In a long rest the robot looks but a moment every few seconds: soon
-- enough for who has rested long, at a fraction of what perception takes.
function SiteWork:glances(seen, since)
   return function()
      local dozed = self.odometry.time - since - WATCHES
      self.machine.dozes = dozed > 0 and dozed % (NAP + GLANCE) < NAP
      return not self.machine.dozes and seen()
   end
end

-- Whether the robot keeps to a side, of several that others work at, too, where every brick stands, as far as it remembers.
function SiteWork:is_done_here()
   return self.sides:are_manned() and self.prospects:is_finished(self.map.side)
end

-- Waits before it tries its rows again: a moment, or, after several rounds in vain, ever longer, until it sees a brick that
-- it had not seen before. On a side of its own it rests before the middle; where others may work, not so long, since it is
-- in their way.
function SiteWork:rest()
   local more, shared = math.max(0, self:idle_rounds() - AWAKE), self.sides:are_shared()
   local rests = shared and SHARED_RESTS or RESTS
   local done, here = self.prospects:has_seen_all(), self:is_done_here()
   local time = (2 + 4 * math.random()) * ((done or here) and rests.longest or math.min(rests.longer ^ more, rests.longest))
   if not (done or here) and more == 0 then return self.process:wait(time) end
   if not shared then self.sides:stand_back() end
   self.lift:to(self.lift:top())
   local seen, over = self.map:sees_new_brick(), self.odometry.time + time
   if not done then over = math.min(over, self:keeps_until()) end
   local glances = self:glances(seen, self.odometry.time)
   while self.odometry.time < over do
      local new = self.process:wait_until(glances, math.min(LOOKS_ALONG, over - self.odometry.time))
      self.machine.dozes = false
      if new then
         self.in_vain = 0
         return
      end
      self:look_along(seen)
   end
end

-- Nothing of what it knew of who works on its side counts from now on.
function SiteWork:leave_side()
   if self.map.side then self.prospects:note_left(self.map.side) end
   self.fronts, self.at_home, self.contested = {}, false, false
end

-- All rows were tried, or somebody was in the way once too often. Whether the robot stays here for a
-- while, since others' work may open a row.
function SiteWork:stays()
   if self.sides.wanted then
      self:begin_side()
      self.sides:withdraw()
      self:leave_side()
      return false
   end
   self.tried, self.explored, self.in_vain = {}, {}, self.in_vain + 1
   self.sides:withdraw()
   if not self:keeps_to_side() then
      -- once a way round; for who is alone nobody opens a row
      if self.task.delay > 0 and self.in_vain % #self.task.sides == 0 then self:rest() end
   elseif #self.task.sides == 1 or self.obstructed <= OBSTRUCTED and self.odometry.time < self:keeps_until() then
      self:rest()
      return true
   end
   if self.sides:are_shared() then self.sides.wanted = self.prospects:likely_side() end
   self.obstructed, self.patience = 0, 2 * self.patience
   self:leave_side()
   return false
end

-- Along the row's line, or what a function says of it in each step, up to a place `away` from its column.
-- Whether nobody is in the way.
function SiteWork:come_up(line, away, speed)
   local in_between = self.right_of_way:in_between(type(line) == 'function' and line() or line)
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
   if self:come_up(line, away, 0.14) then return 'there' end
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
      -- up on the way there
      local arrive = self.lift:is_below(look.lift) and self.lift:set_out(look.lift, self.lift.WORTH)
      local came = self:come_up(attempt > 1 and line or line(), away, 0.12)
      if arrive then arrive() end
      if not came then return false end
      if not arrive then
         if not self.clearance:await_room_below() then return false end
         self.lift:to(look.lift)
      end
      local _, aside, angle = self.odometry:on_line(line())
      if math.abs(aside) < LOOKS_ASIDE and math.abs(angle) < LOOKS_ASKEW then break end
   end
   return true
end

-- Sees the column from one place. Whether nobody is in the way.
function SiteWork:look_from(column, look)
   if not self:stand_for(column, look) then return false end
   if self.task.delay > 0 then self.right_of_way:queue() end
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

-- The brick of those that are known whose colour is wrong, {u, v, level, colour, right}, as a look at a column shows, or nil.
-- What is shown says more by itself where one in memory is wrong, too.
function SiteWork:fault_seen_at(column)
   if not self.map.target or not self.map.known then return nil end
   local shown = column:shown()
   for _, known in ipairs { self.map:bricks_with(shown), shown } do
      local wrong, right = ColourFaults.find(known, self.map.target)
      for _, brick in ipairs(shown) do
         if brick == wrong then
            brick.right = right
            return brick
         end
      end
   end
end

-- Whether a fault was seen for a while: what another robot is about to put there shows no colour of its own at first.
function SiteWork:lasts(fault)
   local before, now = self.fault, self.odometry.time
   local same = before and before.u == fault.u and before.v == fault.v and before.level == fault.level and
                before.colour == fault.colour
   self.fault = same and before or fault
   self.fault.since = self.fault.since or now
   -- it may show what blocks in robots' hands do
   self.placement.spared = fault.block.id
   return now - self.fault.since > FAULT_LASTS
end

-- Under which it is counted how often a brick was told its colour.
local function mended_key(fault) return fault.u .. ' ' .. fault.v .. ' ' .. fault.level end

-- What is to be done before a column at which a brick of a wrong colour was seen: {what, top, mends, fault} with feet, next_to,
-- aside, open and clear, as a decision has them, if nothing is in the way to its top from there; or nil. One that is dark counts
-- as none where rows begin, and may stand before the column.
function SiteWork:mending_of(column, fault)
   local du, dv = column:cell_of(fault.block)
   if dv ~= 0 or du < 0 or du > 1 or (self.mended[mended_key(fault)] or 0) >= TELLINGS then return nil end
   local level = fault.level
   while level < self.task.levels and column:stands(du, 0, level + 1) do level = level + 1 end
   local top, over = level == fault.level and fault.block or column:brick(du, 0, level), level + 1
   if not top or not self.placement:reaches(over) or column:stands(du, 0, over + 1) or column:stands(du, 1, over) or
      column:stands(du, -1, over) then return nil end
   return { top = top, what = 'raise', feet = { top }, next_to = {}, aside = 0, open = true,
            clear = column:cell(du - 1, 0, over) == 'empty', mends = fault.right, fault = fault }
end

-- Sees to a brick of a wrong colour that a look has shown: the event with which that ends, or nil where none was seen.
function SiteWork:see_to_faults(column)
   local fault = self:fault_seen_at(column)
   if not fault then return nil end
   self.wish = self:lasts(fault) and self:mending_of(column, fault) or nil
   if self.wish then return 'faulty' end
   -- by a dark one nothing is decided anyway
   if not self.map:is_brick(fault) then return nil end
   self:set_aside(self.row.v)
   self:leave(self.row)
   return 'nothing'
end

-- Sees the column from all places that its decision needs. Whether nobody is in the way.
function SiteWork:look_at(column)
   for _, look in ipairs(self.task.looks) do
      if not self:look_from(column, look) then return false end
      -- whoever is alone knows what stands beside the site without looking
      if self.task.delay == 0 and self.map.known and column:decide() then break end
   end
   return true
end

function SiteWork:look()
   if self.turns:await(self.task.looks[1].lift) then self.process:enter('look') end
   local machine, chosen = self.machine, self.row
   local column = Column.new(self.odometry, machine.tracker, machine.sight, self.map, self.task, self.row)
   self.column = column
   if not self:look_at(column) then
      self.path:back_off(0.10)
      self:set_aside(self.row.v)
      self:give_up()
      return 'unseen'
   end
   self.row = column.row
   self.fronts[column.row.v] = column.row.front
   if not self.magnets:holds() then return 'dropped' end
   -- a structure that was pushed away meanwhile is looked for before anything is put to it
   if self.map.directions:has_turned() then self.map:lose() end
   self.map.directions:settle_doubt()
   if not self.map.known then
      self.record:tally('aborted')
      return 'unseen'
   end
   local faults = not chosen.flank and self.task.answers and self:see_to_faults(column)
   if faults then return faults end
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
   self:set_aside(self.row.v)
   self:leave(self.row)
   if top_seen then return 'nothing' end
   if self.row.by_heart then self.map:forget_row(self.row) end
   self.record:tally('aborted')
   return 'unseen'
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

-- Whether another may be met at the site.
function SiteWork:may_meet()
   local x, y, level = self:place_of_wish()
   local u, v = self.map:cell_of(x, y)
   return self.task.delay > 0 and self.right_of_way:may_meet { u = u, v = v, level = level }
end

function SiteWork:approach_site()
   local wish, start = self.wish, self.odometry.time
   local _, _, level = self:place_of_wish()
   local guide, where, left = self:guide_of(wish)
   local near, problem = self.placement:approach_site(guide, where, {
      heading = self.row.frame.yaw, level = wish.level, left = left,
      over = wish.what == 'beside' and self:stands_free(),
      before = wish.mends and STAYS_OFF, aside = wish.aside, open = wish.open, colour = wish.colour,
      brisk = self.task.delay == 0 and self:is_clear(), clear = self.task.delay > 0 and self:is_clear(),
      alone = self:may_meet() and function(line) return self.right_of_way:is_alone(line, level) end or nil,
      goes_before = function(place) return self.map:goes_before(place, level) end,
      outdated = function() return self.column:is_outdated(wish) end,
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
      self.yielded = true
      return 'busy'
   end
   self.record:tally('aborted')
   if problem == 'the block was lost' then return 'dropped' end
   -- what was not found twice is looked for from elsewhere
   if self.unfound == self.row.v then self:set_aside(self.row.v) end
   self.unfound = self.row.v
   return 'lost'
end

-- Where the block goes, and on which level.
function SiteWork:place_of_wish()
   local wish = self.wish
   local x, y = self.map.place_for(self.row, wish)
   return x, y, wish.level or geometry.level_of(wish.top.z) + 1
end

-- Whether a brick was ever seen behind the place on or beside a column, on a level.
function SiteWork:had_behind(level)
   local x, y = self.map.place_of(self.row, -1, self.wish.left or 0)
   return self.map:had_brick(x, y, level)
end

-- Whether the place beside a column is on a brick, with none behind it that would stop a block on its way in.
function SiteWork:stands_free()
   local x, y, level = self:place_of_wish()
   return level > 0 and self.map:had_brick(x, y, level - 1) and not self:had_behind(level)
end

-- Whether what comes before the effector on the last way is another robot, since no brick stands behind the place: the
-- effector is over the block.
function SiteWork:is_clear()
   local wish = self.wish
   local _, _, level = self:place_of_wish()
   local free = wish.clear
   if wish.what == 'beside' then free = not self:had_behind(level) end
   return free and not self:had_behind(level + 1)
end

-- The map has what the robot has put down, though no look may show it.
function SiteWork:note_placed()
   if not self.map.known then return end
   local x, y, level = self:place_of_wish()
   self.map:note_brick(x, y, level, self.wish.colour)
end

-- Gives the brick below the carried block the colour that it should have.
function SiteWork:recolour()
   local _, _, level = self:place_of_wish()
   local answered = self.placement:recolour_below(self.wish.mends, level - self.wish.fault.level)
   self.record:tally(answered and 'recoloured' or 'aborted')
   local key = mended_key(self.wish.fault)
   self.mended[key] = (self.mended[key] or 0) + 1
   self:leave(self.row)
   self.wish, self.fault, self.placement.spared, self.tried = nil, nil, false, {}
   self.prospects:forget()
   return self.magnets:holds() and 'done' or 'dropped'
end

function SiteWork:attach()
   local drawn = self.map:draws_aside(self:place_of_wish())
   if not self.placement:attach(self.wish.colour, drawn) then
      self.record:tally('aborted')
      return 'failed'
   end
   self:leave(self.row)
   self.turns:place(function() self:note_placed() end)
   -- of the row that it is in, and of that of the brick
   self.fronts[self.row.v], self.fronts[self.row.v + (self.wish.left or 0)] = nil, nil
   if self.wish.what == 'extend' then self.fronts[self.row.v] = self.row.front + 1 end
   self.at_home, self.contested = true, false
   self.tried, self.wish = {}, nil
   self.prospects:forget()
   self.obstructed, self.in_vain, self.patience = 0, 0, patience_at_first()
   self.record:tally('placed')
   return 'placed'
end

return SiteWork
