-- SPDX-License-Identifier: MIT
-- Tracks: blocks that were detected repeatedly, each with an estimate of its pose in the odometry
-- frame, which is a mean weighted with its and the detection's variance.
--
-- A track is a detection (block_detector.lua) with id, votes (of colours), dark (pictures in turn that showed none), jumped
-- (likewise in which it was elsewhere), seen and missed (how often), first and time (when, at first and last), top_time (when
-- its top was seen last, -1 for never).

local geometry = require 'common.geometry'

local SIDE, HALF, near = geometry.SIDE, geometry.HALF, geometry.near
local GATE = 0.050             -- m: a block moves less than this between two pictures
local SEEN_OFTEN, MISSED_OFTEN = 3, 3
local LEAST_GAIN = 0.1         -- of a detection, in a track's place
local LEAST_TURN = 0.03        -- likewise in its yaw
local MOVED = 0.015            -- m, from its track, of a block that somebody has moved
local SAME = 0.010             -- m, from its track, of a block that stands where it stood
local JUMPS = 2                -- pictures in turn in which a block is elsewhere, to be so: in one a corner may be far off
local FADES = 0.7              -- of the votes for a colour, in each picture
local DARK = 8                 -- pictures in turn without any, of a block that has none
local MEMORY = 60              -- s, of a block out of sight
local NEAREST, FARTHEST = 0.08, 0.40  -- m from the eye, between which a block is not overlooked
local MARGIN = 0.022           -- m about a tag that has to be in the picture too
local NOISE = 0.01             -- of what is remembered: of the way
local SLIP, TURN_SLIP = 1e-5, 5e-5  -- m², rad² for each rad of a turn, in which wheels slip one way all along

local BlockTracker = {}
BlockTracker.__index = BlockTracker

function BlockTracker.new(odometry, camera, detector)
   return setmetatable({
      odometry = odometry, camera = camera, detector = detector, tracks = {}, last_id = 0,
   }, BlockTracker)
end

-- What is remembered gets less certain as the robot moves.
function BlockTracker:add_process_noise(ahead, turn)
   local noise, turned = (NOISE * ahead) ^ 2 + SLIP * math.abs(turn), TURN_SLIP * math.abs(turn)
   for _, track in ipairs(self.tracks) do
      track.variance, track.turned = track.variance + noise, track.turned + turned
   end
end

-- What is dark shows no colour, but with corners off by pixels half of the looks at what is lit find none either.
local function vote(track, colour)
   local votes = track.votes
   for one = 1, #votes do votes[one] = FADES * votes[one] end
   if colour then track.dark = colour == 0 and track.dark + 1 or 0 end
   if (colour or 0) > 0 then votes[colour] = votes[colour] + 1 end
   track.colour = 0
   if track.dark >= DARK then return end
   for one = 1, #votes do
      if votes[one] > (votes[track.colour] or 0) then track.colour = one end
   end
end

function BlockTracker:update(track, block)
   local dx, dy = block.x - track.x, block.y - track.y
   local gain = math.max(LEAST_GAIN, track.variance / (track.variance + block.variance))
   local jumps = dx * dx + dy * dy > MOVED ^ 2 or track.level ~= block.level
   track.jumped = jumps and track.jumped + 1 or 0
   track.seen, track.missed, track.time = track.seen + 1, 0, self.odometry.time
   if jumps and track.jumped < JUMPS then return end
   if jumps then gain = 1 end
   track.x, track.y, track.z, track.level = track.x + gain * dx, track.y + gain * dy,
                                            block.z, block.level
   local turn = gain == 1 and 1 or math.max(LEAST_TURN, track.turned / (track.turned + block.turned))
   track.yaw = track.yaw + turn * geometry.wrap_quarter(block.yaw - track.yaw)
   track.turned = turn == 1 and block.turned or track.turned * (1 - turn)
   track.variance = gain == 1 and block.variance or track.variance * (1 - gain)
   vote(track, block.colour)
   if block.top then track.top_time = self.odometry.time end
end

function BlockTracker:appear(block)
   self.last_id = self.last_id + 1
   block.id = self.last_id
   block.votes, block.dark = {}, 0
   for one = 1, self.detector.kinds do block.votes[one] = 0 end
   vote(block, block.colour)
   block.seen, block.missed, block.jumped, block.first, block.time = 1, 0, 0, self.odometry.time, self.odometry.time
   block.top_time = block.top and self.odometry.time or -1
   table.insert(self.tracks, block)
end

-- What speaks against a detection being a track's block, m²: how far apart they are, and a side more where colours
-- differ, since after a turn a block may be nearer to where its neighbour was.
local function unlikeness(block, known)
   local square = near(block, known, GATE)
   if square and block.colour and block.colour ~= known.colour then return square + SIDE * SIDE end
   return square
end

-- Likest pairs first: which detections are known by now, and which tracks were seen.
function BlockTracker:match(found)
   local couples = {}
   for i, block in ipairs(found) do
      for j, known in ipairs(self.tracks) do
         local against = unlikeness(block, known)
         if against then table.insert(couples, { against, i, j }) end
      end
   end
   table.sort(couples, function(a, b) return a[1] < b[1] end)
   local taken, used = {}, {}
   for _, couple in ipairs(couples) do
      local _, i, j = table.unpack(couple)
      if not taken[i] and not used[j] then
         taken[i], used[j] = true, true
         self:update(self.tracks[j], found[i])
      end
   end
   return taken, used
end

-- Without those that were missed too often, or not seen for too long.
function BlockTracker:drop_stale(used)
   local eye, turn = self.camera:pose()
   local kept = {}
   for j, known in ipairs(self.tracks) do
      if not used[j] and self:in_picture(known, eye, turn) then known.missed = known.missed + 1 end
      if known.missed < MISSED_OFTEN and self.odometry.time - known.time < MEMORY then
         table.insert(kept, known)
      end
   end
   self.tracks = kept
end

-- Whether a block on a level is one that was seen there before.
function BlockTracker:is_known(block)
   for _, known in ipairs(self.tracks) do
      if block.level and known.level == block.level and known.seen >= SEEN_OFTEN and near(known, block, SAME) then return true end
   end
   return false
end

-- Once in each step, after the odometry. What has no partner appears, or is missed.
function BlockTracker:sense()
   local found = self.detector:detect(self.odometry.pose, function(block) return self:is_known(block) end)
   local taken, used = self:match(found)
   self:drop_stale(used)
   for i, block in ipairs(found) do
      if not taken[i] then self:appear(block) end
   end
end

-- Where a block shows itself: the height of the middle of its upper tag, or of the one in front
-- where another block lies on it, and how far before the block's middle that is.
function BlockTracker:mark_of(block)
   for _, known in ipairs(self.tracks) do
      if math.abs(known.z - block.z - SIDE) < HALF and math.abs(known.x - block.x) < HALF and
         math.abs(known.y - block.y) < HALF then
         return block.z, HALF
      end
   end
   return block.z + HALF, 0
end

-- Whether that tag should be in the picture, if nothing hides it.
function BlockTracker:in_picture(block, eye, turn)
   local x, y = geometry.into(self.odometry.pose, block.x, block.y)
   local height, before = self:mark_of(block)
   local p = (vector3(x - before, y, height) - eye):rotate(turn:inverse())
   if p.z < NEAREST or p.z > FARTHEST then return false end
   return self.camera:frames(p, MARGIN * self.camera:focal() / p.z)
end

-- Blocks that were seen often enough.
function BlockTracker:blocks()
   local out = {}
   for _, known in ipairs(self.tracks) do
      if known.seen >= SEEN_OFTEN then table.insert(out, known) end
   end
   return out
end

-- The block of a track that may have come and gone since: by its id, or what lies where it lay.
function BlockTracker:again(block)
   local best, least
   for _, known in ipairs(self.tracks) do
      if known.id == block.id then return known end
      local square = near(known, block, HALF)
      if square and (not least or square < least) then best, least = known, square end
   end
   return best
end

function BlockTracker:forget(block)
   for i, known in ipairs(self.tracks) do
      if known.id == block.id then
         table.remove(self.tracks, i)
         return
      end
   end
end

function BlockTracker:forget_all()
   self.tracks = {}
end

-- The nearest of the blocks in memory that is wanted, seen within the last `age` s if that is given;
-- or nil.
function BlockTracker:recall(wanted, age)
   local best
   for _, block in ipairs(self:blocks()) do
      if (not age or self.odometry.time - block.time < age) and wanted(block) and
         (not best or self.odometry:distance_to(block) < self.odometry:distance_to(best)) then
         best = block
      end
   end
   return best
end

-- Whether something is in sight that was not seen often enough to be sure of: eight times, or until
-- `undecided(block)` is false where that is given.
function BlockTracker:glimpse(undecided)
   for _, known in ipairs(self.tracks) do
      local in_sight = known.missed == 0 and self.odometry.time - known.time < 0.1
      if in_sight and (known.seen < 8 or undecided and undecided(known)) then return true end
   end
   return false
end

return BlockTracker
