-- SPDX-License-Identifier: MIT
-- What a robot sees of the column that it stands before. `seen` gathers it:
--
--     {task, row, bricks = {}, empty = {}, top}
--
-- bricks and empty have a key "du dv level" for each cell: du towards the robot and dv to its left
-- of the column, as rules are compiled.

local robotics = require 'robotics'
local lattice = require 'lattice'
local column = {}

local SIDE = robotics.SIDE
local OFTEN = 3                -- sightings that count

-- The line on which the robot faces a row; its end is the middle of the foremost column.
function column.line_before(of)
   local x, y = lattice.place_of(of, 0, 0)
   return { x = x, y = y, yaw = of.frame.yaw }
end

function column.distance_for(look)
   local camera = robot.camera_system.transform.position.x + robotics.profile.anchor[1]
   return camera + look.distance + SIDE / 2
end

-- What is seen of the column in front, for as long as the robot stands: bricks by colour, cells
-- that are empty since a brick there would be seen.
function column.watch(seen)
   local rows = lattice.rows()
   local row = rows and rows[seen.row.v] or seen.row
   seen.row = row
   for _, known in ipairs(robotics.tracks) do
      if known.time == robotics.time and known.seen >= OFTEN then
         local along, left = robotics.into(row.frame, known.x, known.y)
         local du = -math.floor(along / SIDE + 0.5) - row.front
         local dv = math.floor(left / SIDE + 0.5) - row.v
         local level = robotics.level_of(known.z)
         seen.bricks[du .. ' ' .. dv .. ' ' .. level] = known
         if known.top_time == robotics.time then
            local above = du .. ' ' .. dv .. ' ' .. level + 1
            seen.empty[above] = (seen.empty[above] or 0) + 1
         end
      end
   end
   for _, ask in ipairs(seen.task.asks) do
      local key = table.concat(ask, ' ')
      local x, y = lattice.place_of(row, ask[1], ask[2])
      if not seen.bricks[key] and robotics.would_see(x, y, ask[3], row.frame.yaw) then
         seen.empty[key] = (seen.empty[key] or 0) + 1
      end
   end
end

-- A colour, 'empty', or nil where it is not known.
function column.cell(seen, du, dv, level)
   local key = du .. ' ' .. dv .. ' ' .. level
   local known = seen.bricks[key]
   if known then return lattice.is_brick(known) and known.colour or nil end
   return (seen.empty[key] or 0) >= OFTEN and 'empty' or nil
end

-- The highest brick of the column in front.
function column.top(seen)
   local top
   for level = 0, seen.task.levels do
      local is = column.cell(seen, 0, 0, level)
      if is == 'empty' or (not is and level == seen.task.levels) then return top end
      if not is then return nil end
      top = { level = level, colour = is, known = seen.bricks['0 0 ' .. level] }
   end
   return top
end

-- The highest of its bricks, whatever is below.
function column.highest(seen)
   for level = seen.task.levels, 0, -1 do
      local known = seen.bricks['0 0 ' .. level]
      if known then return known end
   end
end

-- Where a neighbour stands beside the site that is wished for: 1 when to its right, -1 when to
-- its left, so that the block goes in a little off and does not catch on it.
function column.room_beside(seen, wish)
   local du, dv = wish.what == 'extend' and 1 or 0, wish.left or 0
   -- on an overhang there is no brick from the floor up
   local level = wish.level or robotics.level_of(wish.top.z) + 1
   local function stands(at)
      return type(column.cell(seen, du, at, level)) == 'number' or
             du == 0 and at == 0 and seen.bricks['0 0 ' .. level] ~= nil
   end
   return (stands(dv - 1) and 1 or 0) - (stands(dv + 1) and 1 or 0)
end

return column
