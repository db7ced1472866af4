-- SPDX-License-Identifier: MIT
-- What a robot knows of the structure that it builds: where it is, how its lattice lies, which
-- sides it has, and what rows of columns are seen from them.
--
-- A side's name tells nothing to a robot that has no compass. `params.side` is the side on which it
-- begins, as it makes out when it first sees the structure; from then on it knows the lattice's directions
-- by its own turns, put right by a few degrees whenever it sees the structure again. Where the
-- structure is far from where it was, the robot is lost. Then the way from the structure to the
-- cache tells the directions, once it has seen a block there again.

local robotics = require 'robotics'

-- known: {x, y, reach, yaw, origin}: middle and radius of the structure as last seen, the heading
-- that faces it from params.side, and the middle of one cell; nil when it is not known.
-- cache: {x, y}, where the last block came from; cache_way: its distance from the structure's
-- middle. side: index of the side that the robot works from.
local lattice = {}

local SIDE = robotics.SIDE
local wrap, wrap_quarter = robotics.wrap, robotics.wrap_quarter
local FAR_LINKED = 2.3 * SIDE
local STRAYED = 0.40           -- m, by which the structure is farther off than odometry errs
local TURNED = 0.35            -- rad, likewise
local SIDES = { ['+x'] = 0, ['+y'] = 1, ['-x'] = 2, ['-y'] = 3 }
lattice.SIDES = SIDES

local task
local bearing      -- of the cache from the structure's middle, against known.yaw; kept when lost
local lost         -- it was known once

function lattice.is_brick(known)
   return known.colour > 0 and known.colour ~= task.transport
end

local function middle_of(structure)
   local x, y, n = 0, 0, #structure.blocks
   for _, known in ipairs(structure.blocks) do x, y = x + known.x / n, y + known.y / n end
   return { x = x, y = y }
end

-- The largest structure of bricks, of what is in memory; of two alike the one nearer to where the
-- structure is known, or the robot began. Some of its bricks may be out of sight, and those in memory
-- not be linked. Where the structure is known, a brick far from there is one that somebody lost,
-- unless `anywhere` is true.
function lattice.in_memory(anywhere)
   local home = lattice.known or { x = 0, y = 0 }
   local best, least
   for _, structure in ipairs(robotics.structures(lattice.is_brick, FAR_LINKED)) do
      local away = lattice.apart(home, middle_of(structure))
      local far = lattice.known and not anywhere and away > STRAYED
      if not far and (not best or #structure.blocks > #best.blocks or
                      #structure.blocks == #best.blocks and away < least) then
         best, least = structure, away
      end
   end
   return best
end

local function angle_to(from, to)
   return math.atan(to.y - from.y, to.x - from.x)
end

-- Of the four headings that a lattice's yaw may mean, the one nearest to an angle.
local function nearest_to(angle, yaw)
   return angle + wrap_quarter(yaw - angle)
end

-- The heading that faces a structure, seen for the first time, from the side on which the robot
-- began: what two of three say. It began there, most likely with its back to the structure, and
-- it will not have gone far; each alone may be wrong after a search, or in a crowd.
local function facing_at_first(middle, yaw)
   local here = nearest_to(angle_to(robotics.pose, middle), yaw)
   local there = nearest_to(angle_to({ x = 0, y = 0 }, middle), yaw)
   local behind = nearest_to(math.pi, yaw)
   return math.abs(wrap(there - behind)) < 0.1 and there or here
end

-- The heading that faces the structure from params.side; nil where the robot cannot know.
local function orientation(structure, middle)
   local yaw = structure.frame.yaw
   if lattice.known then return nearest_to(lattice.known.yaw, yaw) end
   if lost and not task.turns then
      return lattice.cache and bearing and nearest_to(angle_to(middle, lattice.cache) - bearing, yaw)
   end
   return facing_at_first(middle, yaw)
end

function lattice.apart(a, b)
   return math.sqrt((a.x - b.x) ^ 2 + (a.y - b.y) ^ 2)
end

function lattice.lose()
   lattice.known, lattice.side, lost, lattice.cache = nil, nil, true, nil
end

-- Learns where the structure is, and how the lattice lies. False where the latter is not known.
function lattice.remember(structure)
   local middle = middle_of(structure)
   local x, y = middle.x, middle.y
   local before = lattice.known
   if before and not task.turns and
      (lattice.apart(before, middle) > STRAYED or
       math.abs(wrap_quarter(structure.frame.yaw - before.yaw)) > TURNED) then lattice.lose() end
   local yaw = orientation(structure, middle)
   if not yaw then return false end
   local reach = 0
   for _, known in ipairs(structure.blocks) do
      reach = math.max(reach, math.sqrt((known.x - x) ^ 2 + (known.y - y) ^ 2))
   end
   -- one cell stays the first for as long as the robot is less than half a cell wrong
   local frame = { x = structure.frame.x, y = structure.frame.y, yaw = yaw }
   local origin = lattice.known and lattice.known.origin or frame
   local u, v = robotics.into(frame, origin.x, origin.y)
   local ox, oy = robotics.out_of(frame, SIDE * math.floor(u / SIDE + 0.5),
                                  SIDE * math.floor(v / SIDE + 0.5))
   lattice.known = { x = x, y = y, yaw = wrap(yaw), reach = reach + SIDE / 2,
                     origin = { x = ox, y = oy } }
   return true
end

function lattice.heading_of(index)
   local first = task.turns and 0 or SIDES[robot.params.side or task.sides[1]]
   return wrap(lattice.known.yaw + (index - first) * math.pi / 2)
end

-- '+x' ..., of the side that the robot works from.
function lattice.side_name()
   for name, index in pairs(SIDES) do
      if index == lattice.side then return name end
   end
end

-- The side among those allowed that the robot is nearest to.
function lattice.nearest_side()
   local there = math.atan(lattice.known.y - robotics.pose.y, lattice.known.x - robotics.pose.x)
   local best, least
   for _, name in ipairs(task.sides) do
      local off = math.abs(wrap(lattice.heading_of(SIDES[name]) - there))
      if not least or off < least - 1e-6 then best, least = SIDES[name], off end
   end
   return best
end

-- By how much, m, columns beside a row stand before it where the effector would sweep them.
local function juts_beside(rows, of)
   local most = of.front
   for dv = -2, 2 do most = math.max(most, rows[of.v + dv] and rows[of.v + dv].front or most) end
   return SIDE * (most - of.front)
end

-- Rows of the structure as seen from this side: by v (to the left), the foremost u (towards the
-- robot).
function lattice.rows()
   local structure = lattice.in_memory()
   if not structure or not lattice.remember(structure) then return nil end
   local frame = { x = lattice.known.origin.x, y = lattice.known.origin.y, yaw = lattice.heading_of(lattice.side) }
   local rows = {}
   for _, known in ipairs(structure.blocks) do
      local along, left = robotics.into(frame, known.x, known.y)
      local u, v = -math.floor(along / SIDE + 0.5), math.floor(left / SIDE + 0.5)
      rows[v] = rows[v] or { v = v, front = u, frame = frame }
      rows[v].front = math.max(rows[v].front, u)
   end
   for _, of in pairs(rows) do of.juts = juts_beside(rows, of) end
   return rows
end

-- Place of a cell, du and dv from the foremost of a row.
function lattice.place_of(of, du, dv)
   return robotics.out_of(of.frame, -SIDE * (of.front + du), SIDE * (of.v + dv))
end

-- Whether the body has room before a row: what juts out beside it by two cells is in the way.
function lattice.room_before(rows, of)
   for _, v in ipairs { of.v - 1, of.v + 1 } do
      if rows[v] and rows[v].front >= of.front + 2 then return false end
   end
   return true
end

-- Found and known: which side is the nearest, and where the cache is from here.
function lattice.settle()
   lost = false
   if lattice.cache then
      bearing = wrap(angle_to(lattice.known, lattice.cache) - lattice.known.yaw)
      lattice.cache_way = lattice.apart(lattice.known, lattice.cache)
   end
   if lattice.side then return false end
   lattice.side = lattice.nearest_side()
   return true
end

-- Knows nothing yet; of the task, `transport`, `sides` and `turns` count here.
function lattice.start(with)
   task = with
   bearing, lost = nil, false
   lattice.known, lattice.cache, lattice.side, lattice.cache_way = nil, nil, nil, nil
end

return lattice
