-- SPDX-License-Identifier: MIT
-- Who goes in where robots meet at a site, or at sites next to each other, and how they notice each other: by blocks in others'
-- hands, and by what rangefinders see.

local geometry = require 'common.geometry'
local DueRows = require 'mission.due_rows'
local StructureMap = require 'mission.structure_map'

local SIDE, apart = geometry.SIDE, geometry.apart
local AT_WORK = 0.12           -- m, from the structure, that blocks in others' hands are counted
local BUSY, QUEUE, QUEUES = 10, 4, 5  -- s, the longest waits while another is seen at work and after that; so often at most
local PEEK_FROM, PEEK = 0.19, 0.8  -- m from a site, rad to each side
local PEEK_RIM = 0.05          -- m/s, of that turn, at most: a robot stands across several measurements
local PEEK_STOP = 0.2          -- rad, in which it ends
local PEEK_TIME = 0.6          -- s
local BACK = 0.10              -- m, from there, where a robot waits
local OTHERS_WORK = 15         -- s, from such a look, that another takes to put its block
local ACROSS, ACROSS_FROM = 0.14, 0.02  -- m aside from a site, at most, and on from it, at least, of the effector of another that
                               -- stands before an adjoining one
local STAYS, STAY = 3, 3       -- looks more from there, and s between two
local GOES_IN = 0.055          -- m, of a block from the nearest brick's edge, nearer than who stands to look to both sides
local ON_LINE = 0.0275         -- m, from a line through a site, square to its cell, of the block in the hand of another that looks
                               -- to both sides before it,
local FELT_AT_SAME = { 0.12, 0.16 }  -- and, at least and at most from the site, of what rangefinders see of its chassis,
local NEAR_EDGE = { 0.015, 0.060 }   -- or, farther off, of its near edge on this side of such a line
local FELT_BEHIND = 0.14       -- m, likewise from a site's line, of the chassis of one that stands before an adjoining site
local PASSES_BY = 0.10         -- m, on from a site, of another's line, square to this one's, that nothing of either robot meets
local AT_SITE = 0.22           -- m, from a site, where others are in the way
local COMES_UP = 0.03          -- m, before the effector, likewise on the way in along a row's line
local OF_ONE, GOES = 0.03, 25  -- m, s: what is seen there again after so long stands for good
local NEXT_SITE = 0.20         -- m, from a site, that blocks in others' hands are counted,
local PAST_LOOK = 0.11         -- m, and from the nearest brick's edge, nearer than who stands for a look holds his

-- standing: what stands near sites, and may be robots: {x, y, since}. across: a place where the last look to both sides found
-- another before an adjoining site, or nil. level: of the site that it goes to.
local RightOfWay = {}
RightOfWay.__index = RightOfWay

function RightOfWay.new(machine, map, sides, turns, task)
   return setmetatable({
      machine = machine, odometry = machine.odometry, process = machine.process, path = machine.path,
      lift = machine.lift, clearance = machine.clearance, placement = machine.placement, map = map, sides = sides,
      turns = turns, task = task, standing = {}, level = 0,
   }, RightOfWay)
end

-- Whether somebody is seen to hold a block near the structure.
function RightOfWay:sees_held()
   local known = self.map.known
   return known ~= nil and self.placement:held_near(known.x, known.y, known.reach + AT_WORK) ~= nil
end

-- Before it looks at a row, stays while somebody is seen at work, and a random while longer: whoever else waits has seen the same.
function RightOfWay:queue()
   for _ = 1, QUEUES do
      if not self.process:wait_until(function() return self:sees_held() end, 0.2) then return end
      self.process:wait_until(function() return not self:sees_held() end, BUSY)
      self.process:wait(QUEUE * math.random())
   end
end

-- Whether a point is no part of what stands there for good: robots leave after a while.
function RightOfWay:comes_and_goes(point)
   for _, known in ipairs(self.standing) do
      if apart(known, point) < OF_ONE then return self.odometry.time - known.since < GOES end
   end
   table.insert(self.standing, { x = point.x, y = point.y, since = self.odometry.time })
   return true
end

-- Says whether another robot stands before the row, on the way in along a line, or beside it so that its arm may be there.
function RightOfWay:in_between(line)
   local function counts(point) return self:comes_and_goes(point) end
   return function()
      return self.clearance:between(-self.odometry:on_line(line)) or self.clearance:meets_arm_ahead(COMES_UP, counts)
   end
end

-- Whether another may be met at a cell {u, v, level}: where not every side has its robot, or rules ask for a brick there from
-- another side, or one that stands next to it in the end, diagonally too, is not known to stand.
function RightOfWay:may_meet(cell)
   local map = self.map
   if not self.sides:take_turns() or not map.target then return true end
   for _, name in ipairs(self.task.all_sides) do
      local side = StructureMap.SIDES[name]
      for _, due in pairs(side ~= map.side and DueRows.of(map, self.task, side) or {}) do
         if DueRows.is_same(due.site, cell) then return true end
      end
   end
   return self:lacks_next_to(cell)
end

-- Whether a brick that stands next to a cell in the end is not known to stand, or known bricks lie in no way as in the end.
function RightOfWay:lacks_next_to(cell)
   local map = self.map
   local fits = map.target:fits(map:bricks_with({}))
   for _, way in ipairs(fits) do
      for _, other in ipairs(map.target:cells_in(way)) do
         local near = math.max(math.abs(other.u - cell.u), math.abs(other.v - cell.v)) == 1
         if near and not map:had_brick_in(other.u, other.v, other.level) then return true end
      end
   end
   return #fits == 0
end

-- Whether another, whose block or chassis is at a place, looks at the same site.
local function wants_site(other, line)
   if other.opposite then return true end
   local ahead, left = geometry.into(line, other.x, other.y)
   if other.z then return math.min(math.abs(ahead), math.abs(left)) < ON_LINE end
   local way = apart(line, other)
   return way > FELT_AT_SAME[1] and (way < FELT_AT_SAME[2] or -ahead > NEAR_EDGE[1] and -ahead < NEAR_EDGE[2])
end

-- Whether another, whose block or chassis is at a place, looks at the same site, and is to leave. Robots at adjoining sites
-- are out of each other's pictures until they go in, so that neither knows when the other does.
function RightOfWay:goes_before(other, line)
   return wants_site(other, line) and self.map:goes_before(other, self.level)
end

-- Whether another is at another site, on a side that adjoins.
function RightOfWay:is_aside(other, line)
   return self.map:is_on_adjoining_side(other) and not wants_site(other, line)
end

-- Whether such another stands where it looks to both sides, for long by the second look, and is to let this robot go in.
function RightOfWay:stands_for(other, line)
   if self.map:waits_at_corner(other) then return false end
   if other.z then return self.map:room_about(other.x, other.y) >= GOES_IN end
   local _, left = geometry.into(line, other.x, other.y)
   return math.abs(left) > FELT_BEHIND
end

-- The block that somebody is seen to hold at work about a place; `first`: except of those that this robot goes before,
-- which have not gone in.
function RightOfWay:held_at_work(line, first)
   return self.placement:held_near(line.x, line.y, NEXT_SITE, function(block)
      local room = self.map:room_about(block.x, block.y)
      if self:is_aside(block, line) and geometry.into(line, block.x, block.y) > PASSES_BY then return false end
      return room < GOES_IN or room < PAST_LOOK and not (first and self:goes_before(block, line))
   end)
end

-- Likewise a place where rangefinders have seen a robot since a time.
function RightOfWay:felt_at_work(line, since, first)
   for _, point in ipairs(self.machine.returns:near(line.x, line.y, AT_SITE, since)) do
      if self:comes_and_goes(point) and not (first and self:goes_before(point, line)) then return point end
   end
end

-- Where the effector's rangefinder sees something, or nil.
function RightOfWay:felt_ahead()
   local ahead = self.machine.ranges:range('front')
   if not ahead then return nil end
   local x, y = geometry.out_of(self.odometry.pose, self.machine.description.effector.front + ahead, 0)
   return { x = x, y = y }
end

-- Where somebody stands on the other side of the site: from the lift's top the effector's rangefinder looks over bricks,
-- and sees the other's effector or what carries it. No camera looks so high.
function RightOfWay:opposite()
   self.lift:to(self.lift:top())
   local place = self:felt_ahead()
   if place then place.opposite = true end
   return place
end

-- Whether the effector's rangefinder reaches so far.
function RightOfWay:feels_across()
   local front = self.machine.description.rangefinders.front
   return front ~= nil and front.range > ACROSS
end

-- Where somebody stands before an adjoining site, on another side of the corner: the effector's rangefinder sees that one's
-- in the turns of a look to both sides, while both lifts are at their tops.
function RightOfWay:felt_across(line)
   local place = self:felt_ahead()
   if not place then return nil end
   local ahead, left = geometry.into(line, place.x, place.y)
   return ahead > ACROSS_FROM and math.abs(left) > SIDE and math.abs(left) < ACROSS and place or nil
end

-- A block that somebody holds near the structure, as a look over the column and to both sides tells: with
-- the lift at its top, since the picture's upper edge cuts off what another holds as high and as far away. What
-- is seen on the way counts at once: by the end of a slow turn it would be long ago.
function RightOfWay:sees_others_work(line, first)
   local returns, busy = self.machine.returns, nil
   local function held()
      busy = busy or self:held_at_work(line, first)
      self.across = self.across or self:felt_across(line)
      return busy
   end
   local drive = self.machine.description.drive
   local rim = math.min(PEEK_RIM, math.sqrt(PEEK_STOP * drive.acceleration * drive.track))
   self.lift:to(self.lift:top())
   self.process:wait_until(held, PEEK_TIME)
   for _, angle in ipairs { -PEEK, PEEK } do
      local turn = geometry.wrap(line.yaw + angle - self.odometry.pose.yaw)
      if not held() and not returns:sweeps(turn, self.lift:height()) then
         self.path:swing_to(line.yaw + angle, rim, held)
      end
   end
   self.path:turn_to(line.yaw, rim, function()
      held()
      return false
   end)
   return held()
end

-- Where another robot is seen at work about the end of a line, in a look to both sides, or nil.
-- Who passes here stays nearer than PEEK_FROM until it has put its block down, where the others
-- see it from the places from which they look in their turn: of two robots at work on adjoining
-- sides, the one that looks last sees the other.
function RightOfWay:other_at_work(line, first)
   local ends = self.odometry:on_line(line) < -PEEK_FROM and self:in_between(line) or
                function() return self.clearance:backed() end
   self.path:follow(line, -PEEK_FROM, 0.08, ends)
   local start = self.odometry.time
   self.across = nil
   return self:opposite() or self:sees_others_work(line, first) or self:felt_at_work(line, start, first)
end

-- Whether nobody else is at work at a site on a level, at the end of a line. Of two that look at the same site and see each
-- other the one leaves, and the other looks again after a while, and then goes in, whoever has come meanwhile of those that it
-- goes before. One that sees another at work at an adjoining site waits farther back, until a new brick is in sight. Of two
-- before adjoining sites, whose effectors would meet over the corner, the one waits likewise, once; the other looks once more,
-- as it may not have been noticed.
function RightOfWay:is_alone(line, level)
   self.level = level
   local turn = self.turns:is_own()
   local first, waited, stood = turn, false, false
   for look = 0, STAYS do
      local other = self:other_at_work(line, first)
      local across = not other and self.across
      local aside = other and self:is_aside(other, line)
      local stands = across or aside and self:stands_for(other, line)
      if not other and not across or stood and stands then return true end
      if other then first = turn or self:goes_before(other, line) end
      if look == STAYS or other and not first and not aside then return false end
      stood = stands and (waited or not across or not self.map:waits_at_corner(across))
      if stood or not aside and not across then
         self.process:wait(STAY)
      else
         self.process:enter('await brick')
         -- from farther back, where bricks beside the site are in the picture
         self.path:follow_back(line, -PEEK_FROM - BACK, 0.08)
         self.turns:await_brick(OTHERS_WORK)
         self.process:enter('approach')
         -- the structure may have been lost meanwhile
         if not self.map.side then return false end
         waited = true
      end
   end
end

return RightOfWay
