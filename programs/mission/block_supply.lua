-- SPDX-License-Identifier: MIT
-- Where blocks come from: finds one that nobody uses, and fetches it. Each behaviour returns the event
-- that it ends with.

local geometry = require 'common.geometry'

local OFTEN = 3                -- sightings that count
local LOOK_TIME = 1.0          -- s, for each look
local FIRST_LOOK = 2.5         -- s, for one at blocks not seen before
local FURTHER, STEP_OUT = 4, 0.1  -- looks for a side's cache beyond where one was expected, and m between them
local FRESH = 1                -- s, in which a block in sight was seen
local STILL = 15               -- sightings after which a block in transport is one that was dropped
local LEGS = 12                -- of a search, before it begins again where something is known; then more
local LEGS_AHEAD = 2           -- likewise, of a robot that is bound to a side
local AHEAD = 0.55             -- m, that it goes straight on at first: a cache is the farther off, the more is to be built
local SURE_VIEW = 0.28         -- m, from an empty cache, to wait for its next block
local LINKED = 1.25 * geometry.SIDE
local AT_CACHE = 0.15          -- m, from the last block there
local RESTS = 5                -- searches in vain, after which each rest is twice as long as the one before
local SEARCHES = 2             -- likewise, from which on it leaves a cache that is empty
local LEAVES = 1               -- likewise, from which on a robot that is bound to no side goes to the others' caches
local TRIES = 1                -- to come there, and to a cache where none was seen yet
local LAID_ASIDE = 0.36        -- m, from where it was found, of the robot that lays a block down that does not answer: at
                               -- a cache the next one comes when none lies within 0.35
local LAY_BACK = 0.15          -- m, by which it has gone back from there
local MUTE = 0.10              -- m, about where one was laid down
local MUTES = 3                -- so many one after the other that do not answer: its own radio is dead
local ASLEEP = 1800            -- s, of a robot that can do nothing, until it tries again
local ASLEEP_AWAY = 1.7        -- of its cache's distance from the structure, meanwhile
local STEP_BACK = 0.12         -- m, from a block that is none to be taken
local LOST_FROM = 0.165        -- m, from the structure and other blocks, of a brick that somebody lost
local ELSEWHERE = 2            -- searches in vain after which a robot that is bound to a side takes others' blocks

-- block: the one to be fetched. refused: one that could not be come near. last_cache: that of the
-- side before, until a block was seen at this
-- side's. in_vain: searches one after the other that found nothing at a cache. mute: where blocks were laid aside
-- that did not answer; silent: how many, since one did.
local BlockSupply = {}
BlockSupply.__index = BlockSupply

function BlockSupply.new(machine, map, navigation, sides, record, task)
   local self = setmetatable({
      machine = machine, tracker = machine.tracker, process = machine.process, map = map,
      navigation = navigation, sides = sides, record = record, task = task, in_vain = 0, mute = {}, silent = 0,
   }, BlockSupply)
   -- the search would turn away from it before it can be told from one in a robot's hand, or from a brick of the structure
   machine.search.undecided = function(known)
      local in_transport = task.transport > 0 and known.colour == task.transport
      local lost = self.in_vain > 0 and map:is_brick(known) and map:may_be_lost { known }
      return (in_transport or lost) and known.level == 0 and known.seen < STILL
   end
   return self
end

-- Whether a block stands beside another. What is never in one picture with it is the same block again, seen by its
-- side alone and so taken to stand elsewhere.
function BlockSupply:is_beside(other, known)
   local now = self.process:time()
   if (known.time == now or other.time == now) and known.time ~= other.time then return false end
   return geometry.apart(other, known) < LINKED and math.abs(other.z - known.z) < LINKED
end

-- Dark, or dropped by a robot; on the floor, and with nothing beside it, nor a brick that was ever seen there: one
-- that is half hidden shows a tag without its LEDs, and looks dark.
function BlockSupply:is_unused(known)
   local transport = self.task.transport
   local dropped = transport > 0 and known.colour == transport and known.seen >= STILL
   if known.colour ~= 0 and not dropped or known.level ~= 0 or known.seen < 2 * OFTEN then
      return false
   end
   if self.map:room_about(known.x, known.y) < LINKED - geometry.HALF then return false end
   for _, other in ipairs(self.tracker:blocks()) do
      if other ~= known and self:is_beside(other, known) then return false end
   end
   for _, place in ipairs(self.mute) do
      if geometry.apart(place, known) < MUTE then return false end
   end
   return true
end

-- Whether it is a brick that somebody lost, and that lies where a block may come from: a cache drops no other on it. One
-- that stands alone, of a colour that no structure begins with, and that several looks have shown so; nobody takes one as long
-- as a block is found. What of its colour was seen beside it before, and not since it was seen itself, was the same, before it
-- was pushed.
function BlockSupply:is_lost(known)
   if self.in_vain == 0 or known.level ~= 0 or known.seen < STILL or not self.map:is_brick(known) or
      not self.map:may_be_lost { known } or self.map:room_about(known.x, known.y) < LOST_FROM then return false end
   for _, other in ipairs(self.tracker:blocks()) do
      local before = other.colour == known.colour and other.time < known.first
      if other.id ~= known.id and not before and geometry.apart(other, known) < LOST_FROM then return false end
   end
   return true
end

-- Whether a place is on the robot's side. Before it has seen the structure, that is ahead of where it began, since
-- robots begin with their backs to the structure, or where it has watched the cache.
function BlockSupply:is_on_own_side(place)
   local map = self.map
   if map.known then return map:is_on_own_side(place) end
   return place.x > 0 or map.cache ~= nil and geometry.apart(place, map.cache) < AT_CACHE
end

-- Says whether a block is one to be fetched: unused, and on the robot's side if it is bound to one, since the way
-- from elsewhere leads past others at work.
function BlockSupply:wanted()
   local anywhere = not self.machine.robot.params.sides or self.in_vain >= ELSEWHERE
   return function(known)
      return (self:is_unused(known) or self:is_lost(known)) and (anywhere or self:is_on_own_side(known))
   end
end

-- Driven to where a search goes on.
function BlockSupply:wander()
   return function(x, y) return self.navigation:wander(x, y) end
end

-- A block at the cache, as a look there tells, and whether something stood in the way, as Navigation:look_again has it.
function BlockSupply:at_cache(time, tries)
   local is_wanted = self:wanted()
   local function seen()
      for _, known in ipairs(self.tracker:blocks()) do
         if is_wanted(known) and self.process:time() - known.time < FRESH then return true end
      end
   end
   local found, blocked = self.navigation:look_again(self.map.cache, seen, time, tries)
   return found and self.tracker:recall(is_wanted) or nil, blocked
end

-- One that was seen on the side from which the robot works, though not where its cache was expected.
function BlockSupply:remembered_here()
   local map, is_wanted = self.map, self:wanted()
   if not map.known or not map.side then return nil end
   return self.tracker:recall(function(known) return is_wanted(known) and map:is_on_side(map.side, known) end)
end

-- A block at the cache of a side where none was found yet: farther out than the last one's, since a structure that has
-- grown this way has its cache before that end.
function BlockSupply:at_cache_further_out()
   local map = self.map
   if not map.known or not map.side or map.caches[map.side] then return nil end
   local expected, heading = map.cache, map:heading_of(map.side)
   for step = 1, FURTHER do
      local x, y = geometry.out_of({ x = expected.x, y = expected.y, yaw = heading }, -step * STEP_OUT, 0)
      map.cache = { x = x, y = y }
      local block, blocked = self:at_cache(LOOK_TIME, TRIES)
      if block or blocked then return block end
   end
end

-- Of a rest before it searches again, s: ever longer, since what lies nowhere now may not come for long, and looks about
-- and ways cost the robot what it knows of where it is.
function BlockSupply:patience()
   return (5 + 10 * math.random()) * 2 ^ math.min(self.in_vain, RESTS)
end

-- A block at one of the other sides' caches, the nearest first, or nil; of a robot that is bound to no side and found
-- nothing at its own.
function BlockSupply:at_others_caches()
   local map = self.map
   if self.machine.robot.params.sides or self.in_vain < LEAVES or not map.known then return nil end
   local own, ways = map.cache, {}
   for side in pairs(map.caches) do
      local cache = map:cache_of(side)
      if geometry.apart(cache, own) > AT_CACHE then table.insert(ways, cache) end
   end
   local function way(cache) return self.machine.odometry:distance_to(cache) end
   table.sort(ways, function(a, b) return way(a) < way(b) end)
   for _, cache in ipairs(ways) do
      map.cache = cache
      local block = self:at_cache(LOOK_TIME, TRIES)
      if block then return block end
   end
   map.cache = own
end

-- Whether it is to find a block that it has lost, rather than wait for the next: one that is alone, and in nobody's way.
function BlockSupply:searches_for_lost()
   return self.machine.magnets.lost and self.task.delay == 0
end

-- Where the last block came from, about the robot, and there again: an empty cache is filled after a while.
function BlockSupply:look_at_cache()
   local map = self.map
   if not map.cache then return nil end
   local block = self:at_cache(self.last_cache and FIRST_LOOK or LOOK_TIME)
   if not block and self.last_cache then
      block = self:remembered_here() or self:at_cache_further_out()
      if not block then
         map.cache = self.last_cache
         block = self:at_cache()
      end
   end
   self.last_cache = nil
   block = block or self:at_others_caches() or self.machine.search:look_about(self:wanted())
   -- one that fell lies somewhere about, where the cache may drop no other as long as it does
   if block or self:searches_for_lost() then return block end
   -- what lies nearer than it should is below the picture
   local nearer = SURE_VIEW - self.machine.odometry:distance_to(map.cache)
   if nearer > 0 then self.machine.path:back_off(nearer) end
   return self:at_cache(self:patience())
end

-- After one that could not be come near: another that is remembered, since what stands in the way may stay.
function BlockSupply:another()
   local refused, is_wanted = self.refused, self:wanted()
   self.refused = nil
   return refused and self.tracker:recall(function(known)
      return is_wanted(known) and geometry.apart(known, refused) > LINKED
   end)
end

-- Away from where blocks come from, as far as that is in nobody's way: a block, or nil.
function BlockSupply:search_elsewhere()
   local map, search = self.map, self.machine.search
   if self.machine.robot.params.sides or self.sides:are_shared() and map.cache then
      -- as long as it knows no cache, that may be some way ahead
      local block = not map.cache and search:find(self:wanted(), LEGS_AHEAD, self:wander()) or nil
      if not block and not map.cache then self.process:wait(self:patience()) end
      return block
   end
   if map.cache and self.in_vain < SEARCHES and not self:searches_for_lost() then return nil end
   -- what fell may lie so near that it is in no picture from here
   if self:searches_for_lost() then self.machine.path:back_off(STEP_BACK) end
   local block = search:find(self:wanted(), LEGS * self.in_vain, self:wander())
   local home = map.cache or map.known or { x = 0, y = 0 }
   if not block then self.navigation:straight_to(home.x, home.y) end
   return block
end

-- Where a robot begins, blocks come from ahead.
function BlockSupply:look_ahead_at_first()
   if self.map.cache or self.map.known or self.map.lost or self.in_vain > 0 then return nil end
   return self.tracker:recall(self:wanted()) or self.machine.search:look_ahead(self:wanted(), AHEAD)
end

-- Where the last one came from, then all about.
function BlockSupply:search_block()
   self.block = self:another() or self:look_ahead_at_first() or self:look_at_cache()
   if self.block then return 'found' end
   self.in_vain = self.in_vain + 1
   self.block = self:search_elsewhere()
   return self.block and 'found' or 'none'
end

function BlockSupply:approach_block()
   local near, seen = self.machine.pickup:approach_block(self.block)
   -- from near, others may be seen beside a brick that seemed to be lost
   if near and (seen.colour == 0 or not self.map:is_brick(seen) or self:is_lost(seen)) then
      self.block = seen
      return 'near'
   end
   if near then self.machine.path:back_off(STEP_BACK) end
   self.refused = { x = self.block.x, y = self.block.y }
   self.record:tally('aborted')
   return 'lost'
end

-- Whether neither a block nor a brick is where the robot's turn on the spot would sweep it.
function BlockSupply:has_room_to_turn()
   local machine = self.machine
   local pivot = machine.odometry:pivot()
   return machine.search:reaches_into_blocks() <= 0 and self.map:room_about(pivot.x, pivot.y) > machine.sweep.room
end

function BlockSupply:pick_up()
   local block = self.block
   local place, fresh = { x = block.x, y = block.y }, block.colour == 0 or not self.map.cache
   local holds, answers = self.machine.pickup:grip_block(block, self.task.transport)
   if holds then
      self.map.side, self.in_vain = nil, 0
      if fresh then self.map.cache = place end
      if not self:has_room_to_turn() then self.machine.path:back_off(0.10) end
      self.silent = answers and 0 or self.silent + 1
      return self.task.answers and not answers and 'mute' or 'holds'
   end
   self.record:tally('aborted')
   self.machine.path:back_off(0.12)
   return 'failed'
end

-- The heading from the structure, or where the robot began, out to a place, and where that is.
function BlockSupply:heading_out_to(place)
   local home = self.map.known or { x = 0, y = 0 }
   return math.atan(place.y - home.y, place.x - home.x), home
end

-- One that no radio reaches would be built in without its colour: farther out, where it keeps no other from coming.
function BlockSupply:lay_aside()
   local machine, block = self.machine, self.block
   local out = { x = block.x, y = block.y, yaw = self:heading_out_to(block) }
   self.navigation:straight_to(geometry.out_of(out, LAID_ASIDE, 0))
   machine.placement:release(0, nil, nil, 0)
   local pose = machine.odometry.pose
   local x, y = geometry.out_of(pose, machine.description.magnets.ahead + LAY_BACK, 0)
   table.insert(self.mute, { x = x, y = y })
   return self.silent < MUTES and 'done' or 'useless'
end

-- Out of the others' way, who do the work: between its cache and the next side's, farther out.
function BlockSupply:sleep()
   local cache = self.map.cache
   if cache then
      local heading, home = self:heading_out_to(cache)
      local between = { x = home.x, y = home.y, yaw = heading + math.pi / 4 }
      self.navigation:to(geometry.out_of(between, ASLEEP_AWAY * geometry.apart(home, cache), 0))
   end
   self.process:wait(ASLEEP)
   return 'done'
end

-- Lost: where blocks come from tells the directions.
function BlockSupply:find_cache()
   local function comes_from_there(known) return known.colour == 0 and self:is_unused(known) end
   local known = self.machine.search:find(comes_from_there, LEGS, self:wander())
   if not known then return 'none' end
   self.map.cache = { x = known.x, y = known.y }
   return 'found'
end

return BlockSupply
