-- SPDX-License-Identifier: MIT
-- Looks for blocks: round about with the lift at several heights, since each sees a ring, and then on
-- along a square spiral.

local geometry = require 'common.geometry'

local RIM = 0.050              -- m/s, of a turn to look; faster would turn the camera by its width in two steps
local GLANCE = 1.0             -- s, for one ahead
local LEG = 0.33               -- m, between two looks round
local LEGS = 25
local LEG_SPEED = 0.12         -- m/s
local FRESH = 1                -- s, in which a block in sight was seen
local NEAR_LOOK = 0.070        -- height of the lift; what it carries passes over a block
local LOW_LOOK = 0.030         -- likewise, of one that carries nothing: for what is 0.2 m away


-- undecided: set by who searches: whether a block has to be seen more often before `wanted` can say anything.
local Search = {}
Search.__index = Search

function Search.new(odometry, process, tracker, magnets, lift, clearance, path)
   return setmetatable({
      odometry = odometry, process = process, tracker = tracker, magnets = magnets, lift = lift,
      clearance = clearance, path = path,
   }, Search)
end

-- How far a turn on the spot would reach into blocks that are known, m; negative where none is so near.
function Search:reaches_into_blocks()
   local pivot, most = self.odometry:pivot(), -math.huge
   for _, known in ipairs(self.tracker:blocks()) do
      most = math.max(most, self.clearance.sweep.from_block - geometry.apart(pivot, known))
   end
   return most
end

-- Once round on the spot, until `found()` is something.
function Search:look_round(found)
   local off = self:reaches_into_blocks()
   if off > 0 then self.path:back_off(off) end
   self.path:clear_round()
   local turned, before = 0, self.odometry.pose.yaw
   local block
   while turned < 2 * math.pi and not block do
      -- what is seen for the first time is worth a look
      local rim = self.tracker:glimpse(self.undecided) and 0 or RIM * self.path.pace
      self.path:drive_rims(-rim, rim)
      coroutine.yield()
      turned = turned + math.abs(geometry.wrap(self.odometry.pose.yaw - before))
      before = self.odometry.pose.yaw
      block = found()
   end
   self.path:stop()
   return block
end

-- Once round with the lift up and then with it lower: a block of which `wanted(block)` is true, or
-- nil.
function Search:look_about(wanted)
   for _, height in ipairs { self.lift:top(), NEAR_LOOK, LOW_LOOK } do
      if self.magnets.carrying and height == LOW_LOOK then break end
      if self.lift:is_below(height) or self.path:clear_below() then self.lift:to(height) end
      local block = self:look_round(function() return self.tracker:recall(wanted, FRESH) end)
      if block then return block end
   end
   return nil
end

-- Straight on, as far as `way` m, with the lift up, from where the camera sees farthest: a block that is wanted, or nil.
function Search:look_ahead(wanted, way)
   local function found() return self.tracker:recall(wanted, FRESH) end
   self.process:enter('search')
   self.lift:to(self.lift:top())
   self.process:wait_until(found, GLANCE)
   self.path:follow(self.odometry:line_ahead(), way, LEG_SPEED, function()
      return found() or self.clearance:blocked() or self:reaches_into_blocks() > 0
   end)
   return found()
end

-- A block that is wanted: one in memory, or else one that comes in sight. Looks about, and after
-- that in vain moves on, in a square spiral of so many `legs`, each driven by `go(x, y)`. Returns
-- nil when there was none.
function Search:find(wanted, legs, go)
   local block = self.tracker:recall(wanted)
   if block then return block end
   self.process:enter('search')
   local pose, clearance = self.odometry.pose, self.clearance
   local heading, run, left = pose.yaw, 2, 1
   for _ = 1, legs or LEGS do
      block = self:look_about(wanted)
      if block then return block end
      -- legs of 1, 1, 2, 2, 3, 3 ... steps, a quarter turn between them
      if left == 0 then
         run, heading = run + 1, heading + math.pi / 2
         left = run // 2
      end
      left = left - 1
      local from = self.odometry:pivot()
      local x, y = from.x + LEG * math.cos(heading), from.y + LEG * math.sin(heading)
      if go then
         go(x, y)
      else
         self.path:go_to(x, y, LEG_SPEED, function() return clearance:blocked() end)
      end
   end
   return nil
end

return Search
