-- SPDX-License-Identifier: MIT
-- What a robot knows: where it has driven, which blocks it has seen and where, what structures
-- they make. Written for the interface of the real robot; call `sense()` first in every step.
--
-- Poses are {x, y, yaw} in m and rad. The odometry frame is where the robot stood at `start()`;
-- the robot's frame has x ahead and y left. A block's yaw counts modulo a quarter turn.

local robotics = {}

robotics.SIDE = 0.055
local SIDE, HALF = 0.055, 0.0275
local TAG_TO_MIDDLE = 0.0285      -- from a tag to its block's middle
local TAG_HEIGHT = 0.001          -- of a tag over its face
local MERGE = HALF                -- detections nearer than this are one block
local GATE = 0.050                -- a block moves less than this between two pictures
local LINK = 1.25 * SIDE          -- nearer blocks are of one structure
local ASKEW = 0.2                 -- rad, by which no two blocks of a lattice are off
local SEEN_OFTEN, MISSED_OFTEN = 3, 3
local LEAST_TURN = 0.03           -- of a sighting, in a block's yaw
local MEMORY = 60                 -- s, of a block out of sight
local LED_OFFSET = 0.020
local TAG = 0.024                 -- its side
local PLAIN = 4                   -- px, of depth that a tag shows, to be sure which way it tilts

-- Figures that the interface does not tell. `grip`: the middle of a carried block, ahead of the
-- robot's; `anchor`: the middle of the body that holds the camera, with the lift down; `front`: how far ahead the chassis rangefinders
-- are; `under`: the effector's lower side over the floor with the lift down; `gap`: from the
-- support to a carried block's face; `fan`: the front rangefinders are 12, 1 and 2, a fan; `zero`: the charge at which the magnets' field vanishes.
local PROFILES = {
   ['vertical link'] = {
      name = 'bebot', front = 0.044755, track = 0.07106, acceleration = 1.0, cruise = 0.165, grip = 0.093755,
      under = 0.05575, gap = 0.008455, reach = 0.1298, lift_top = 0.1365, lift_slack = 0.001,
      zero = 165, full = 250,
      anchor = { 0.055755, 0, 0.079 }, focal = 883.961, counts = true, search_rim = 0.050,
   },
   ['end effector'] = {
      name = 'builderbot', track = 0.120, acceleration = 1.0, cruise = 0.10, grip = 0.0980875,
      under = 0.055, gap = 0.0051875, reach = 0.131, lift_top = 0.1365, lift_slack = 0.001,
      zero = 15.1, full = 22.9,
      anchor = { 0.0980875, 0, 0.060 }, focal = 313.9, counts = false, fan = true, search_rim = 0.050,
   },
}

local QUARTER = math.pi / 2

function robotics.wrap(angle)
   return (angle + math.pi) % (2 * math.pi) - math.pi
end

-- The smallest turn that leaves a cube as it is.
function robotics.wrap_quarter(angle)
   return (angle + QUARTER / 2) % QUARTER - QUARTER / 2
end

function robotics.clamp(value, low, high)
   return math.max(low, math.min(high, value))
end

local wrap, wrap_quarter = robotics.wrap, robotics.wrap_quarter

local function round(value)
   return math.floor(value + 0.5)
end

-- From a frame's coordinates to the outside, and back.
function robotics.out_of(frame, x, y)
   local c, s = math.cos(frame.yaw), math.sin(frame.yaw)
   return frame.x + c * x - s * y, frame.y + s * x + c * y
end

function robotics.into(frame, x, y)
   local c, s = math.cos(frame.yaw), math.sin(frame.yaw)
   local dx, dy = x - frame.x, y - frame.y
   return c * dx + s * dy, -s * dx + c * dy
end

function robotics.level_of(z)
   return round((z - HALF) / SIDE)
end

-- Driving -------------------------------------------------------------------------------------

function robotics.drive_rims(left, right)
   -- the right motor is the mirror image of the left one
   robot.differential_drive.set_target_velocity(left, -right)
end

-- v in m/s, turn in rad/s.
function robotics.drive(v, turn)
   local aside = turn * robotics.profile.track / 2
   robotics.drive_rims(v - aside, v + aside)
end

-- How far a rim goes in a step that begins with `before` and ends with `after`, m/s: it ramps,
-- then runs evenly.
function robotics.way_of(before, after, time)
   local change = after - before
   return after * time - change * math.abs(change) / (2 * robotics.profile.acceleration)
end

local function odometry()
   local left = robot.differential_drive.encoders.left
   local right = -robot.differential_drive.encoders.right
   local time = robot.system.time - robotics.time
   robotics.time = robot.system.time
   if time > 0 then
      robotics.period = time
      local a = robotics.way_of(robotics.left, left, time)
      local b = robotics.way_of(robotics.right, right, time)
      local ahead, turn = (a + b) / 2, (b - a) / robotics.profile.track
      local pose, middle = robotics.pose, robotics.pose.yaw + turn / 2
      pose.x = pose.x + ahead * math.cos(middle)
      pose.y = pose.y + ahead * math.sin(middle)
      pose.yaw = wrap(pose.yaw + turn)
      robotics.travelled = robotics.travelled + math.abs(ahead)
      -- what is remembered gets less certain as the robot moves
      local doubt = (0.01 * ahead) ^ 2 + (0.002 * turn) ^ 2
      for _, track in ipairs(robotics.tracks) do
         track.variance, track.turned = track.variance + doubt, track.turned + (0.002 * turn) ^ 2
      end
   end
   robotics.left, robotics.right = left, right
end

-- Rangefinders --------------------------------------------------------------------------------

-- Metres, or nil when nothing is within its range. The robot of 2017 counts.
function robotics.range(name)
   local finder = robot.rangefinders and robot.rangefinders[name]
   if not finder then return nil end
   local reading = finder.proximity
   if not robotics.profile.counts then return reading < 0.0499 and reading or nil end
   if reading <= 0 then return nil end
   if not tonumber(name) then
      return math.max(0, math.log(5432.4 / reading) / 87.70362)
   end
   local root = math.sqrt(5493.967 ^ 2 - 4 * 7164.404 * (1253.394 - reading))
   return math.max(0, -math.log((5493.967 + root) / (2 * 7164.404)))
end

-- Seeing --------------------------------------------------------------------------------------

local function camera_pose()
   local transform, anchor = robot.camera_system.transform, robotics.profile.anchor
   local lift = robot.lift_system.position
   return transform.position + vector3(anchor[1], anchor[2], anchor[3] + lift),
          transform.orientation
end

-- The colour that most of the four LEDs about a tag show.
local function colour_about(tag)
   local votes = {}
   for _, place in ipairs { { 1, 0 }, { 0, 1 }, { -1, 0 }, { 0, -1 } } do
      local led = vector3(place[1] * LED_OFFSET, place[2] * LED_OFFSET, -TAG_HEIGHT)
      local colour = robot.camera_system.detect_led(tag.position + led:rotate(tag.orientation))
      votes[colour] = (votes[colour] or 0) + 1
   end
   local best, most = 0, 1
   for colour = 1, 4 do
      if (votes[colour] or 0) > most then best, most = colour, votes[colour] end
   end
   return best
end

-- What a tag says of its block, turned as in the robot's frame. A tag that tilts away from the
-- camera looks nearly as one that tilts towards it: when few pixels tell the two apart, the height
-- does, where either may stand on a level.
local function standing_of(tag, place, eye, turn)
   local orientation = turn * tag.orientation
   local normal, right = vector3(0, 0, 1):rotate(orientation), vector3(1, 0, 0):rotate(orientation)
   local ray = place - eye
   local distance = ray:length()
   ray = vector3(ray.x / distance, ray.y / distance, ray.z / distance)  -- ARGoS has no /
   local slant = vector3(normal):cross(ray):length()
   local first
   for mirrored = 0, robotics.profile.focal * slant * (TAG / distance) ^ 2 < PLAIN and 1 or 0 do
      if mirrored == 1 then
         normal, right = ray * (2 * normal:dot(ray)) - normal, right - ray * (2 * right:dot(ray))
      end
      local top = normal.z > 0.7
      if top or math.abs(normal.z) <= 0.5 then
         local level = robotics.level_of(place.z - (top and TAG_TO_MIDDLE or 0))
         local height = SIDE * level + (top and SIDE + TAG_HEIGHT or HALF)
         local stands = level >= 0 and math.abs(height - place.z) < 0.015
         local standing = { axis = top and right or normal, normal = normal, top = top, height = height,
                            level = stands and eye.z - height > 0.02 and level or nil }
         if stands then return standing end
         first = first or standing
      end
   end
   return first
end

-- A block from one of its tags, in the robot's frame. Blocks stand upright on floor or blocks, so
-- the height of the tag is known, and the line through its middle says the rest far better than
-- the tag's size.
local function block_of(tag, eye, turn)
   local place = vector3(tag.position):rotate(turn) + eye
   local standing = standing_of(tag, place, eye, turn)
   if not standing then return nil end
   local level, axis = standing.level, standing.axis
   local free = place.z - standing.normal.z * TAG_TO_MIDDLE
   if level then place = eye + (place - eye) * ((standing.height - eye.z) / (place.z - eye.z)) end
   local size = math.sqrt(axis.x ^ 2 + axis.y ^ 2)
   local back = standing.top and 0 or TAG_TO_MIDDLE / size
   local distance = (place - eye):length()
   return {
      x = place.x - axis.x * back, y = place.y - axis.y * back,
      z = level and SIDE * level + HALF or free, level = level,
      yaw = math.atan(axis.y, axis.x), colour = colour_about(tag), top = standing.top,
      variance = (0.0004 * (distance / 0.1) ^ 2) ^ 2, tags = 1,
      -- of the yaw: a tag on top shows it plainly, one in front by how it tilts
      turned = (distance / (robotics.profile.focal * TAG) * (standing.top and 1 or distance / TAG)) ^ 2,
   }
end

local function merge(into, other)
   local share = into.variance / (into.variance + other.variance)
   into.x = into.x + share * (other.x - into.x)
   into.y = into.y + share * (other.y - into.y)
   local turn = into.turned / (into.turned + other.turned)
   into.yaw, into.turned = into.yaw + turn * wrap_quarter(other.yaw - into.yaw), into.turned * (1 - turn)
   if into.colour == 0 then into.colour = other.colour end
   into.top = into.top or other.top
   into.variance = into.variance * (1 - share)
   into.tags = into.tags + 1
end

local function near(a, b, most)
   local dx, dy, dz = a.x - b.x, a.y - b.y, a.z - b.z
   local square = dx * dx + dy * dy + dz * dz
   return square < most * most and square or nil
end

-- Blocks in the picture, in the odometry frame.
local function look()
   local eye, turn = camera_pose()
   local found = {}
   for _, tag in ipairs(robot.camera_system.tags) do
      local block = block_of(tag, eye, turn)
      if block then
         local known
         for _, other in ipairs(found) do
            if near(block, other, MERGE) then known = other break end
         end
         if known then merge(known, block) else table.insert(found, block) end
      end
   end
   for _, block in ipairs(found) do
      block.x, block.y = robotics.out_of(robotics.pose, block.x, block.y)
      block.yaw = block.yaw + robotics.pose.yaw
   end
   return found
end

-- Where a block shows itself: the height of the middle of its upper tag, or of the one in front
-- where another block lies on it, and how far before the block's middle that is.
function robotics.mark_of(block)
   for _, known in ipairs(robotics.tracks) do
      if math.abs(known.z - block.z - SIDE) < HALF and math.abs(known.x - block.x) < HALF and
         math.abs(known.y - block.y) < HALF then
         return block.z, HALF
      end
   end
   return block.z + HALF, 0
end

-- Whether that tag should be in the picture, if nothing hides it.
local function in_picture(block, eye, turn)
   local x, y = robotics.into(robotics.pose, block.x, block.y)
   local height, before = robotics.mark_of(block)
   local p = (vector3(x - before, y, height) - eye):rotate(turn:inverse())
   if p.z < 0.08 or p.z > 0.40 then return false end
   local size, focal = robot.camera_system.resolution, robotics.profile.focal
   local margin = 0.022 * focal / p.z
   return math.abs(focal * p.x / p.z) < size.x / 2 - margin and
          math.abs(focal * p.y / p.z) < size.y / 2 - margin
end

-- Whether the way from `eye` to `p` goes through a block; all in the robot's frame.
local function crosses(eye, p, block)
   local enter, leave = 0, 1
   local c, s = math.cos(block.yaw), math.sin(block.yaw)
   local function turned(x, y) return c * x + s * y, -s * x + c * y end
   local fx, fy = turned(eye.x - block.x, eye.y - block.y)
   local wx, wy = turned(p.x - eye.x, p.y - eye.y)
   for _, axis in ipairs { { fx, wx }, { fy, wy }, { eye.z - block.z, p.z - eye.z } } do
      local from, way = axis[1], axis[2]
      if math.abs(way) < 1e-9 then
         if math.abs(from) >= HALF then return false end
      else
         local a, b = (-HALF - from) / way, (HALF - from) / way
         enter, leave = math.max(enter, math.min(a, b)), math.min(leave, math.max(a, b))
      end
   end
   return leave - enter > 1e-9
end

-- Whether a block with its middle at x, y of the odometry frame, on this level and squarely to
-- `heading`, would be seen now: one of its tags wholly in the picture, less a margin, and no
-- known block before it.
function robotics.would_see(x, y, level, heading)
   local eye, turn = camera_pose()
   local back, size = turn:inverse(), robot.camera_system.resolution
   local focal, margin = robotics.profile.focal, 4
   local own = { yaw = heading - robotics.pose.yaw, z = SIDE * level + HALF }
   own.x, own.y = robotics.into(robotics.pose, x, y)
   local before = {}
   for _, known in ipairs(robotics.tracks) do
      local other = { yaw = known.yaw - robotics.pose.yaw, z = known.z }
      other.x, other.y = robotics.into(robotics.pose, known.x, known.y)
      local dx, dy = other.x - own.x, other.y - own.y
      if dx * dx + dy * dy + (other.z - own.z) ^ 2 > HALF * HALF then
         table.insert(before, other)
      end
   end
   local function visible(p)
      local q = (p - eye):rotate(back)
      if q.z < 0.05 or q.z > 0.48 then return false end
      if math.abs(focal * q.x / q.z) > size.x / 2 - margin or
         math.abs(focal * q.y / q.z) > size.y / 2 - margin then return false end
      for _, other in ipairs(before) do
         if crosses(eye, p, other) then return false end
      end
      return true
   end
   local c, s = math.cos(own.yaw), math.sin(own.yaw)
   local middle = vector3(own.x, own.y, own.z)
   for _, face in ipairs { { -1, 0, 0 }, { 0, 0, 1 }, { 0, 1, 0 }, { 0, -1, 0 } } do
      local function world(a, b, d) return vector3(c * a - s * b, s * a + c * b, d) end
      local normal = world(face[1], face[2], face[3])
      local right = face[3] == 1 and world(0, 1, 0) or world(-face[2], face[1], 0)
      local up = vector3(normal):cross(right)  -- ARGoS changes the first
      local centre = middle + normal * TAG_TO_MIDDLE
      local way = eye - centre
      local all = way:dot(normal) >= way:length() * math.cos(math.rad(70))
      for _, corner in ipairs { { 1, 1 }, { 1, -1 }, { -1, 1 }, { -1, -1 } } do
         all = all and visible(centre + right * (0.012 * corner[1]) + up * (0.012 * corner[2]))
      end
      if all then return true end
   end
   return false
end

-- Remembering ---------------------------------------------------------------------------------

local function update(track, block)
   local dx, dy = block.x - track.x, block.y - track.y
   local share = math.max(0.1, track.variance / (track.variance + block.variance))
   if dx * dx + dy * dy > 0.015 ^ 2 or track.level ~= block.level then share = 1 end
   track.x, track.y, track.z, track.level = track.x + share * dx, track.y + share * dy,
                                            block.z, block.level
   local turn = share == 1 and 1 or math.max(LEAST_TURN, track.turned / (track.turned + block.turned))
   track.yaw = track.yaw + turn * wrap_quarter(block.yaw - track.yaw)
   track.turned = turn == 1 and block.turned or track.turned * (1 - turn)
   track.variance = share == 1 and block.variance or track.variance * (1 - share)
   for colour = 0, 4 do track.votes[colour] = 0.7 * track.votes[colour] end
   track.votes[block.colour] = track.votes[block.colour] + 1
   track.colour = 0
   for colour = 1, 4 do
      if track.votes[colour] > track.votes[track.colour] then track.colour = colour end
   end
   track.seen, track.missed, track.time = track.seen + 1, 0, robotics.time
   if block.top then track.top_time = robotics.time end
end

local function appear(block)
   robotics.last_id = robotics.last_id + 1
   block.id = robotics.last_id
   block.votes = { [0] = 0, 0, 0, 0, 0 }
   block.votes[block.colour] = 1
   block.seen, block.missed, block.time = 1, 0, robotics.time
   block.top_time = block.top and robotics.time or -1
   table.insert(robotics.tracks, block)
end

-- Nearest pairs first; what has no partner appears, or is missed.
local function track()
   local found, pairs_of = look(), {}
   for i, block in ipairs(found) do
      for j, known in ipairs(robotics.tracks) do
         local square = near(block, known, GATE)
         if square then table.insert(pairs_of, { square, i, j }) end
      end
   end
   table.sort(pairs_of, function(a, b) return a[1] < b[1] end)
   local taken, used = {}, {}
   for _, pair in ipairs(pairs_of) do
      local _, i, j = table.unpack(pair)
      if not taken[i] and not used[j] then
         taken[i], used[j] = true, true
         update(robotics.tracks[j], found[i])
      end
   end
   local eye, turn = camera_pose()
   local kept = {}
   for j, known in ipairs(robotics.tracks) do
      if not used[j] and in_picture(known, eye, turn) then known.missed = known.missed + 1 end
      if known.missed < MISSED_OFTEN and robotics.time - known.time < MEMORY then
         table.insert(kept, known)
      end
   end
   robotics.tracks = kept
   for i, block in ipairs(found) do
      if not taken[i] then appear(block) end
   end
end

-- Blocks that were seen often enough, in the odometry frame: x, y, z, yaw, level, colour (0 dark
-- to 4), id.
function robotics.blocks()
   local out = {}
   for _, known in ipairs(robotics.tracks) do
      if known.seen >= SEEN_OFTEN then table.insert(out, known) end
   end
   return out
end

-- The block of a track that may have come and gone since: by its id, or what lies where it lay.
function robotics.again(block)
   local best, least
   for _, known in ipairs(robotics.tracks) do
      if known.id == block.id then return known end
      local square = near(known, block, HALF)
      if square and (not least or square < least) then best, least = known, square end
   end
   return best
end

function robotics.forget(block)
   for i, known in ipairs(robotics.tracks) do
      if known.id == block.id then
         table.remove(robotics.tracks, i)
         return
      end
   end
end

function robotics.distance_to(block)
   local x, y = block.x - robotics.pose.x, block.y - robotics.pose.y
   return math.sqrt(x * x + y * y)
end

-- Structures ----------------------------------------------------------------------------------

-- The yaw of blocks that stand squarely to each other, modulo a quarter turn.
local function mean_yaw(blocks)
   local c, s = 0, 0
   for _, block in ipairs(blocks) do
      c, s = c + math.cos(4 * block.yaw) / block.turned, s + math.sin(4 * block.yaw) / block.turned
   end
   return math.atan(s, c) / 4
end

local function fit(structure)
   local first = structure.blocks[1]
   local frame = { x = first.x, y = first.y, yaw = mean_yaw(structure.blocks) }
   local x, y = 0, 0
   structure.cells = {}
   for i, block in ipairs(structure.blocks) do
      local u, v = robotics.into(frame, block.x, block.y)
      local cell = { round(u / SIDE), round(v / SIDE), block.level or robotics.level_of(block.z) }
      structure.cells[i] = cell
      x, y = x + u - cell[1] * SIDE, y + v - cell[2] * SIDE
   end
   local n = #structure.blocks
   frame.x, frame.y = robotics.out_of(frame, x / n, y / n)
   structure.frame = frame
   return structure
end

-- Groups of linked blocks, each with a lattice's frame fitted to it: blocks[i] is in cells[i],
-- {along, across, level}, whose middle is out_of(frame, 55 mm * along, 55 mm * across). Of those
-- blocks alone that are `wanted`, if that is given; `link` in m.
function robotics.structures(wanted, link)
   local blocks, group, out = {}, {}, {}
   for _, known in ipairs(robotics.blocks()) do
      if not wanted or wanted(known) then table.insert(blocks, known) end
   end
   for i in ipairs(blocks) do
      if not group[i] then
         local structure, open = { blocks = {} }, { i }
         group[i] = true
         while #open > 0 do
            local at = table.remove(open)
            table.insert(structure.blocks, blocks[at])
            for j, other in ipairs(blocks) do
               if not group[j] and near(blocks[at], other, link or LINK) then
                  group[j] = true
                  table.insert(open, j)
               end
            end
         end
         table.insert(out, fit(structure))
      end
   end
   return out
end

-- A block's yaw, as all that it is linked to and that stands squarely to it says.
function robotics.square_of(block)
   for _, structure in ipairs(robotics.structures()) do
      local own, square = false, {}
      for _, known in ipairs(structure.blocks) do
         own = own or known.id == block.id
         if math.abs(wrap_quarter(known.yaw - block.yaw)) < ASKEW then table.insert(square, known) end
      end
      if own then return mean_yaw(square) end
   end
   return block.yaw
end

-- Life ----------------------------------------------------------------------------------------

-- Call it in init or reset, once readings are there. `figures` replace some of the profile's; a
-- robot that has no profile here takes the rest from the first.
function robotics.start(figures)
   local anchor = robot.camera_system.transform.anchor
   local profile = PROFILES[anchor]
   if not profile then
      if not figures then error('no profile for a robot whose camera is on ' .. anchor) end
      profile = PROFILES['vertical link']
   end
   robotics.profile = setmetatable(figures or {}, { __index = profile })
   robotics.pose = { x = 0, y = 0, yaw = 0 }
   robotics.time, robotics.period = robot.system.time or 0, 0.2
   robotics.left, robotics.right, robotics.travelled = 0, 0, 0
   robotics.tracks, robotics.last_id = {}, 0
   robot.camera_system.enable()
end

function robotics.sense()
   odometry()
   track()
end

return robotics
