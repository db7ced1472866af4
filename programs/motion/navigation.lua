-- SPDX-License-Identifier: MIT
-- How a robot that builds gets about: straight on where it can, round the structure, back and aside
-- where something stands in the way.

local geometry = require 'common.geometry'

local apart, clamp = geometry.apart, geometry.clamp
local LOOK_TIME = 1.0          -- s
local DRIVE_LOW = 0.030        -- height of the lift at which the front rangefinder sees columns of two, and what others carry
local TOO_NEAR = 0.165         -- m, of a way past a brick
local PAST_CACHE = 0.17        -- m, from a cache, of a way past it
local FAR = 0.9                -- m, from the structure's middle, that a search goes at most
local FAR_LOOK = 0.36          -- m, from a remembered place, to look at it from
local NEAR_LOOK = 0.23         -- m, likewise at least: what is nearer than 0.18 m is below the picture
local OFF = 0.02               -- m, from a place, where it is reached
local ASIDE = 0.15             -- m, out of another's way
local OUT_OF_REACH = 0.08      -- m, back from another that is near
local TRIES = 6                -- to drive straight to a place
local ARCS, ARC = 8, math.pi / 4  -- of a way round the structure
local VIEWS, VIEW_TURN = 12, math.pi / 6  -- of a place, to be chosen from

local Navigation = {}
Navigation.__index = Navigation
Navigation.CLEAR_OF = 0.26     -- m, from the outermost brick, to go round the structure
Navigation.BEFORE_CACHE = 0.16 -- m, from a cache, for a robot that turns

-- `map`: what is known of the structure and the cache (mission/structure_map.lua), or {} where there is
-- none.
function Navigation.new(machine, map)
   return setmetatable({
      odometry = machine.odometry, process = machine.process, camera = machine.camera,
      clearance = machine.clearance, path = machine.path, magnets = machine.magnets,
      lift = machine.lift, map = map,
   }, Navigation)
end

-- A place so far from the structure's middle.
function Navigation:on_ring(angle, radius)
   local known = self.map.known
   return known.x + radius * math.cos(angle), known.y + radius * math.sin(angle)
end

-- How near the straight way to x, y comes to the structure's middle.
function Navigation:way_past(x, y)
   local from, known = self.odometry:pivot(), self.map.known
   local dx, dy = x - from.x, y - from.y
   local square = dx * dx + dy * dy
   local t = 0
   if square > 0 then t = ((known.x - from.x) * dx + (known.y - from.y) * dy) / square end
   t = clamp(t, 0, 1)
   return apart({ x = from.x + t * dx, y = from.y + t * dy }, known)
end

-- Back, and aside.
function Navigation:give_way()
   self.path:back_off(OUT_OF_REACH)
   self.path:clear_round()
   local pose, known = self.odometry.pose, self.map.known
   local turn = math.random() < 0.5 and 1 or -1
   if known then
      -- along the structure rather than out: there are the caches
      local out = math.atan(pose.y - known.y, pose.x - known.x)
      turn = clamp(geometry.wrap(out + turn - pose.yaw), -1.5, 1.5)
   end
   self.path:turn_by(turn)
   local way = math.min(ASIDE, self.clearance:room_ahead())
   self.path:follow(self.odometry:line_ahead(), way, 0.1, function() return self.clearance:meets(0) end)
end

-- Straight to a place. Where something stands in the way: waits for it to go, out of its reach, then gives way, `tries` times at
-- most.
function Navigation:straight_to(x, y, tries)
   if not self.magnets.carrying and (self.lift:is_below(DRIVE_LOW) or self.path:clear_below()) then
      self.lift:to(DRIVE_LOW)
   end
   local place = { x = x, y = y }
   local function left() return apart(self.odometry:pivot(), place) end
   local function meets() return self.clearance:meets(left()) end
   for try = 1, tries or TRIES do
      self.path:go_to(x, y, nil, meets)
      if left() < OFF then return true end
      -- one that goes back or turns would touch who waits right beside it; a wall would not
      if self.clearance.explained and self.clearance:has_company() then self.path:back_off(OUT_OF_REACH) end
      if not self.clearance:await_way(left) and try ~= tries then self:give_way() end
   end
   return false
end

-- In arcs round the structure, until the rest of the way is clear of it.
function Navigation:round_structure(x, y)
   local map = self.map
   local radius = map.known.reach + Navigation.CLEAR_OF
   local function angle_of(px, py) return math.atan(py - map.known.y, px - map.known.x) end
   local goal = angle_of(x, y)
   for _ = 1, ARCS do
      local pivot = self.odometry:pivot()
      local at = angle_of(pivot.x, pivot.y)
      local left = geometry.wrap(goal - at)
      local away = apart(pivot, map.known)
      if math.abs(left) < ARC or
         (away > radius - 0.03 and self:way_past(x, y) >= map.known.reach + TOO_NEAR) then break end
      self:straight_to(self:on_ring(at + clamp(left, -ARC, ARC), radius))
   end
end

-- To where the straight way to a place is free of the structure and the cache.
function Navigation:round(x, y)
   local known = self.map.known
   if known and self:way_past(x, y) < known.reach + TOO_NEAR then self:round_structure(x, y) end
   self:past_cache(x, y)
end

-- To a place, round the structure where it is in the way.
function Navigation:to(x, y, tries)
   self:round(x, y)
   return self:straight_to(x, y, tries)
end

-- Likewise to so far before it at most, where the robot turns to it.
function Navigation:to_before(x, y, away)
   self:round(x, y)
   local pivot = self.odometry:pivot()
   local share = math.min(1, away / apart(pivot, { x = x, y = y }))
   local there = self:straight_to(x + share * (pivot.x - x), y + share * (pivot.y - y))
   pivot = self.odometry:pivot()
   self.path:turn_to(math.atan(y - pivot.y, x - pivot.x))
   return there
end

-- To a place beside the cache, if that stands in the way.
function Navigation:past_cache(x, y)
   local cache, from = self.map.cache, self.odometry:pivot()
   if not cache then return end
   local line = { x = from.x, y = from.y, yaw = math.atan(y - from.y, x - from.x) }
   local far = apart(from, { x = x, y = y })
   local along, left = geometry.into(line, cache.x, cache.y)
   if along < 0.05 or along > far - 0.05 or math.abs(left) > PAST_CACHE then return end
   local aside = left < 0 and left + PAST_CACHE or left - PAST_CACHE
   self:straight_to(geometry.out_of(line, along, aside))
end

-- On a search: what is seen of the structure meanwhile keeps its place known, and it is not come near.
function Navigation:wander(x, y)
   local map = self.map
   local structure = map:in_memory()
   if map.known and structure then map:remember(structure) end
   local known = map.known
   if known then
      local off = apart(known, { x = x, y = y })
      local out = clamp(off, known.reach + Navigation.CLEAR_OF, FAR) / math.max(off, 1e-3)
      x, y = known.x + out * (x - known.x), known.y + out * (y - known.y)
   end
   return self:to(x, y)
end

-- Where to look at a place from, FAR_LOOK away: on the way there, or else round the place until it is
-- clear of the structure, which may lie on the way.
function Navigation:view_of(place)
   local from, known = self.odometry:pivot(), self.map.known
   local first = math.atan(from.y - place.y, from.x - place.x)
   for i = 0, VIEWS do
      local angle = first + (i % 2 == 0 and 1 or -1) * ((i + 1) // 2) * VIEW_TURN
      local away = FAR_LOOK - self.odometry.ahead
      local view = { x = place.x + away * math.cos(angle), y = place.y + away * math.sin(angle) }
      if i == VIEWS or not known or self.map:room_about(view.x, view.y) > TOO_NEAR then return view end
   end
end

-- Looks at a place in memory from a little away. Whether `found()` says something, soon. With `tries`, to come there:
-- nil and true where something stands in the way.
function Navigation:look_again(place, found, time, tries)
   local odometry = self.odometry
   -- of the middle, once the robot faces it
   local function distance() return apart(place, odometry:pivot()) + odometry.ahead end
   local away = distance()
   if away > FAR_LOOK + 0.02 then
      local view = self:view_of(place)
      if not self:to(view.x, view.y, tries) and tries then return nil, true end
      away = FAR_LOOK
   end
   local pivot = odometry:pivot()
   local arrive = self.path:clear_below() and self.lift:look_to(self.camera, math.max(away, NEAR_LOOK))
   self.path:turn_to(math.atan(place.y - pivot.y, place.x - pivot.x))
   if arrive then arrive() end
   if away < NEAR_LOOK - 0.02 then self.path:back_off(NEAR_LOOK - away) end
   return self.process:wait_until(found, time or LOOK_TIME)
end

return Navigation
