-- SPDX-License-Identifier: MIT
-- How a robot that builds gets about: straight on where it can, round the structure, back and aside
-- where something stands in the way.

local robotics = require 'robotics'
local handling = require 'handling'
local lattice = require 'lattice'
local travel = {}

local LOOK_TIME = 1.0          -- s
local DRIVE_LOW = 0.020        -- height of the lift at which the front rangefinder sees columns of two
local CLEAR_OF = 0.26          -- m, from the outermost brick, to go round the structure
local TOO_NEAR = 0.165         -- of a way past a brick
local PAST_CACHE = 0.17        -- m, from a cache, of a way past it
local PATIENCE = 8             -- s, the longest random wait for a robot to go its way
local FAR = 0.9                -- m, from the structure's middle, that a search goes at most
local FAR_LOOK = 0.36          -- m, from a remembered place, to look at it from
local NEAR_LOOK = 0.23         -- m, likewise at least: what is nearer than 0.18 m is below the picture
travel.CLEAR_OF = CLEAR_OF
travel.BEFORE_CACHE = 0.16     -- m, from a cache, for a robot that turns

-- A place so far from the structure's middle.
local function on_ring(angle, radius)
   return lattice.known.x + radius * math.cos(angle), lattice.known.y + radius * math.sin(angle)
end

-- How near the straight way to x, y comes to the structure's middle.
local function way_past(x, y)
   local dx, dy = x - robotics.pose.x, y - robotics.pose.y
   local square = dx * dx + dy * dy
   local t = 0
   if square > 0 then
      t = ((lattice.known.x - robotics.pose.x) * dx + (lattice.known.y - robotics.pose.y) * dy) / square
   end
   t = robotics.clamp(t, 0, 1)
   return lattice.apart({ x = robotics.pose.x + t * dx, y = robotics.pose.y + t * dy }, lattice.known)
end

-- Back, and aside.
local function give_way()
   handling.back_off(0.08)
   handling.await_room()
   local turn = math.random() < 0.5 and 1 or -1
   if lattice.known then
      -- along the structure rather than out: there are the caches
      local out = math.atan(robotics.pose.y - lattice.known.y, robotics.pose.x - lattice.known.x)
      turn = robotics.clamp(robotics.wrap(out + turn - robotics.pose.yaw), -1.5, 1.5)
   end
   handling.turn_by(turn)
   local pose = robotics.pose
   handling.follow({ x = pose.x, y = pose.y, yaw = pose.yaw }, 0.15, 0.1, handling.meets)
end

-- Straight to a place. Where something stands in the way: waits for it to go, then gives way.
function travel.straight_to(x, y)
   if not handling.carrying then handling.lift_to(DRIVE_LOW) end
   for _ = 1, 6 do
      local function left() return lattice.apart(robotics.pose, { x = x, y = y }) end
      local function meets() return handling.meets(left()) end
      handling.go_to(x, y, nil, meets)
      if left() < 0.02 then return true end
      if not handling.wait_until(function() return not meets() end, PATIENCE * math.random()) then
         give_way()
      end
   end
   return false
end

-- To a place, round the structure where it is in the way.
function travel.to(x, y)
   if lattice.known and way_past(x, y) < lattice.known.reach + TOO_NEAR then
      local radius = lattice.known.reach + CLEAR_OF
      local function angle_of(px, py) return math.atan(py - lattice.known.y, px - lattice.known.x) end
      local goal = angle_of(x, y)
      for _ = 1, 8 do
         local at = angle_of(robotics.pose.x, robotics.pose.y)
         local left = robotics.wrap(goal - at)
         local away = lattice.apart(robotics.pose, lattice.known)
         if math.abs(left) < math.pi / 4 or
            (away > radius - 0.03 and way_past(x, y) >= lattice.known.reach + TOO_NEAR) then break end
         local to = at + robotics.clamp(left, -math.pi / 4, math.pi / 4)
         travel.straight_to(on_ring(to, radius))
      end
   end
   travel.past_cache(x, y)
   return travel.straight_to(x, y)
end

-- To a place beside the cache, if that stands in the way.
function travel.past_cache(x, y)
   local cache, pose = lattice.cache, robotics.pose
   if not cache then return end
   local line = { x = pose.x, y = pose.y, yaw = math.atan(y - pose.y, x - pose.x) }
   local far = lattice.apart(pose, { x = x, y = y })
   local along, left = robotics.into(line, cache.x, cache.y)
   if along < 0.05 or along > far - 0.05 or math.abs(left) > PAST_CACHE then return end
   local aside = left < 0 and left + PAST_CACHE or left - PAST_CACHE
   travel.straight_to(robotics.out_of(line, along, aside))
end

-- On a search: what is seen of the structure meanwhile keeps its place known, and it is not come
-- near.
function travel.wander(x, y)
   local structure = lattice.in_memory()
   if lattice.known and structure then lattice.remember(structure) end
   local off = lattice.known and lattice.apart(lattice.known, { x = x, y = y })
   if off then
      local out = robotics.clamp(off, lattice.known.reach + CLEAR_OF, FAR) / math.max(off, 1e-3)
      x, y = lattice.known.x + out * (x - lattice.known.x), lattice.known.y + out * (y - lattice.known.y)
   end
   return travel.to(x, y)
end

-- Where to look at a place from, FAR_LOOK away: on the way there, or else round the place until it
-- is clear of the structure, which may lie on the way.
local function view_of(place)
   local first = math.atan(robotics.pose.y - place.y, robotics.pose.x - place.x)
   for i = 0, 12 do
      local angle = first + (i % 2 == 0 and 1 or -1) * ((i + 1) // 2) * math.pi / 6
      local view = { x = place.x + FAR_LOOK * math.cos(angle), y = place.y + FAR_LOOK * math.sin(angle) }
      if i == 12 or not lattice.known or place == lattice.known or
         lattice.apart(lattice.known, view) > lattice.known.reach + TOO_NEAR then return view end
   end
end

-- Looks at a place in memory from a little away. Whether `found()` says something, soon.
function travel.look_again(place, found, time)
   local away = lattice.apart(place, robotics.pose)
   if away > FAR_LOOK + 0.02 then
      local view = view_of(place)
      travel.to(view.x, view.y)
      away = FAR_LOOK
   end
   handling.look_to(math.max(away, NEAR_LOOK))
   handling.turn_to(math.atan(place.y - robotics.pose.y, place.x - robotics.pose.x))
   if away < NEAR_LOOK - 0.02 then handling.back_off(NEAR_LOOK - away) end
   return handling.wait_until(found, time or LOOK_TIME)
end

return travel
