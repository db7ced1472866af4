-- SPDX-License-Identifier: MIT
-- What sensors of ARGoS's BuilderBot say of blocks in sight or in reach: places, optics and laws are
-- those of its sources. `blocks` is whoever is there: {x, y, z of the middle, yaw, colour}.

local mock = require 'mock_argos'
local senses = { blocks = {} }

local SIDE, HALF = 0.055, 0.0275
local EFFECTOR, UNDER = 0.0980875, 0.055
local CAMERA = 0.075           -- over the effector's underside
local FOCAL, WIDTH, HEIGHT, NEAR, FAR = 313.9, 320, 240, 0.025, 0.625
local WIDEST = math.cos(math.pi / 3)
local TAG, LED = 0.0235 / 2, 0.020
local RANGE = 0.05
local SUPPORT, SUPPORT_FOOT = 0.0549, 0.00575  -- the effector's support: its back, m ahead; its foot over the lift's position
local NAMES = { magenta = 1, orange = 2, green = 3, blue = 4 }

-- Outward normals, and the two axes of the tag's own frame.
local FACES = {
   north = { { 1, 0, 0 }, { 0, 0, -1 }, { 0, 1, 0 } }, east = { { 0, -1, 0 }, { 1, 0, 0 }, { 0, 0, 1 } },
   south = { { -1, 0, 0 }, { 0, 0, 1 }, { 0, 1, 0 } }, west = { { 0, 1, 0 }, { 1, 0, 0 }, { 0, 0, -1 } },
   top = { { 0, 0, 1 }, { 1, 0, 0 }, { 0, 1, 0 } }, bottom = { { 0, 0, -1 }, { 1, 0, 0 }, { 0, -1, 0 } },
}

-- x, y, z of the body that carries them (origin or end effector), and the direction: degrees to the
-- left of ahead, or 'down'.
local FINDERS = {
   ['6'] = { 0.0440, 0.0175, 0.0515, 0 }, ['7'] = { 0.0440, -0.0175, 0.0515, 0 },
   ['5'] = { 0.0323, 0.0522, 0.0515, 45 }, ['8'] = { 0.0323, -0.0522, 0.0515, -45 },
   ['4'] = { -0.0025, 0.0640, 0.0515, 90 }, ['9'] = { -0.0025, -0.0640, 0.0515, -90 },
   ['3'] = { -0.0375, 0.0640, 0.0515, 90 }, ['10'] = { -0.0375, -0.0640, 0.0515, -90 },
   ['2'] = { -0.0722, 0.0523, 0.0515, 135 }, ['11'] = { -0.0722, -0.0523, 0.0515, -135 },
   ['1'] = { -0.0840, 0.0175, 0.0515, 180 }, ['12'] = { -0.0840, -0.0175, 0.0515, 180 },
   left = { -0.0343, 0.016, -0.0288, 0, true }, right = { -0.0343, -0.016, -0.0288, 0, true },
   underneath = { -0.0025, 0, 0.0010, 'down', true }, front = { 0.0244, 0, 0.0086, 0, true },
}
senses.finders = {}
for name in pairs(FINDERS) do table.insert(senses.finders, name) end
table.sort(senses.finders)

local function turned(x, y, yaw)
   local c, s = math.cos(yaw), math.sin(yaw)
   return c * x - s * y, s * x + c * y
end

-- Where a way from a to b enters a block, as a share of it; nil when it misses.
local function enters(block, a, b)
   local ax, ay, az = block.x - a[1], block.y - a[2], block.z - a[3]
   local lx, ly, lz = b[1] - a[1], b[2] - a[2], b[3] - a[3]
   local t = math.max(0, math.min(1, (ax * lx + ay * ly + az * lz) / (lx * lx + ly * ly + lz * lz)))
   ax, ay, az = ax - t * lx, ay - t * ly, az - t * lz
   if ax * ax + ay * ay + az * az > 3 * HALF * HALF then return nil end
   local fx, fy = turned(a[1] - block.x, a[2] - block.y, -block.yaw)
   local wx, wy = turned(b[1] - a[1], b[2] - a[2], -block.yaw)
   local enter, leave = 0, 1
   for _, axis in ipairs { { fx, wx }, { fy, wy }, { a[3] - block.z, b[3] - a[3] } } do
      local from, way = axis[1], axis[2]
      if math.abs(way) < 1e-12 then
         if math.abs(from) >= HALF then return nil end
      else
         local p, q = (-HALF - from) / way, (HALF - from) / way
         enter, leave = math.max(enter, math.min(p, q)), math.min(leave, math.max(p, q))
      end
   end
   return leave - enter > 1e-9 and enter or nil
end

local function hidden(eye, point, own)
   for _, block in ipairs(senses.blocks) do
      if block ~= own and enters(block, eye, point) then return true end
   end
   return false
end

local function on_block(block, p)
   local x, y = turned(p[1], p[2], block.yaw)
   return { block.x + x, block.y + y, block.z + p[3] }
end

local function sum(a, b, s, c, t)
   return { a[1] + s * b[1] + t * c[1], a[2] + s * b[2] + t * c[2], a[3] + s * b[3] + t * c[3] }
end

local function scaled(a, s) return { s * a[1], s * a[2], s * a[3] } end

local function on_robot(robot, x, y, z)
   local px, py = turned(x, y, robot.yaw)
   return { robot.x + px, robot.y + py, z }
end

-- x right, y down, z ahead, each in the world's frame.
local function camera_of(robot)
   local c, s, r = math.cos(robot.yaw), math.sin(robot.yaw), math.sqrt(0.5)
   return on_robot(robot, EFFECTOR, 0, UNDER + robot.lift + CAMERA),
          { { s, -c, 0 }, { -r * c, -r * s, -r }, { r * c, r * s, -r } }
end

local function seen_from(eye, axes, p)
   local d, q = { p[1] - eye[1], p[2] - eye[2], p[3] - eye[3] }, {}
   for i, a in ipairs(axes) do q[i] = d[1] * a[1] + d[2] * a[2] + d[3] * a[3] end
   return q
end

local function pixel(q)
   return FOCAL * q[1] / q[3] + WIDTH / 2, FOCAL * q[2] / q[3] + HEIGHT / 2
end

local function in_picture(q)
   if q[3] < NEAR or q[3] > FAR then return false end
   local u, v = pixel(q)
   return u >= 0 and u <= WIDTH and v >= 0 and v <= HEIGHT
end

local function faces_camera(eye, place, normal)
   local d = { eye[1] - place[1], eye[2] - place[2], eye[3] - place[3] }
   local along = d[1] * normal[1] + d[2] * normal[2] + d[3] * normal[3]
   return along >= WIDEST * math.sqrt(d[1] ^ 2 + d[2] ^ 2 + d[3] ^ 2)
end

-- The rotation whose columns these are.
local function to_quaternion(x, y, z)
   local w = math.sqrt(math.max(0, 1 + x[1] + y[2] + z[3])) / 2
   if w > 0.1 then
      return mock.quat(w, (y[3] - z[2]) / (4 * w), (z[1] - x[3]) / (4 * w), (x[2] - y[1]) / (4 * w))
   end
   -- a half turn: about the longest column of R + 1
   local columns = { { x[1] + 1, x[2], x[3] }, { y[1], y[2] + 1, y[3] }, { z[1], z[2], z[3] + 1 } }
   local best, most = nil, 0
   for _, c in ipairs(columns) do
      local l = math.sqrt(c[1] ^ 2 + c[2] ^ 2 + c[3] ^ 2)
      if l > most then best, most = c, l end
   end
   return mock.quat(w, best[1] / most, best[2] / most, best[3] / most)
end

local function face_of(block, name)
   local face, axes = FACES[name], {}
   for i, a in ipairs(face) do
      local x, y = turned(a[1], a[2], block.yaw)
      axes[i] = { x, y, a[3] }
   end
   local place = on_block(block, scaled(face[1], name == 'top' and 0.51 * SIDE or 0.505 * SIDE))
   return place, axes[1], axes[2], axes[3]
end

function senses.look(robot)
   local tags, leds = {}, {}
   if not robot.watches then return tags, leds end
   local eye, axes = camera_of(robot)
   for _, block in ipairs(senses.blocks) do
      for f, name in ipairs(mock.FACES) do
         local place, normal, along, across = face_of(block, name)
         if faces_camera(eye, place, normal) and in_picture(seen_from(eye, axes, place)) then
            local corners, all = {}, true
            for _, sign in ipairs { { 1, 1 }, { 1, -1 }, { -1, -1 }, { -1, 1 } } do
               local corner = sum(place, along, TAG * sign[1], across, TAG * sign[2])
               local q = seen_from(eye, axes, corner)
               all = all and in_picture(q) and not hidden(eye, corner, block)
               if not all then break end
               table.insert(corners, mock.v2(pixel(q)))
            end
            if all then
               local q = seen_from(eye, axes, place)
               -- in ARGoS a tag's z axis points into the block
               local x, y, z = seen_from({ 0, 0, 0 }, axes, along),
                               seen_from({ 0, 0, 0 }, axes, scaled(across, -1)),
                               seen_from({ 0, 0, 0 }, axes, scaled(normal, -1))
               table.insert(tags, mock.tag(0, mock.v3(q[1], q[2], q[3]), to_quaternion(x, y, z),
                                           mock.v2(pixel(q)), corners))
            end
            if block.colour ~= 'black' then
               for i, o in ipairs { { LED, 0 }, { 0, LED }, { -LED, 0 }, { 0, -LED } } do
                  local at = sum(place, along, o[1], across, o[2])
                  local q = seen_from(eye, axes, at)
                  if in_picture(q) then
                     table.insert(leds, { at = q, place = at, block = block, eye = eye,
                                          colour = block.leds[4 * (f - 1) + i] or block.colour })
                  end
               end
            end
         end
      end
   end
   return tags, leds
end

function senses.detect_led(robot, at)
   local best, least
   for _, led in ipairs(robot.leds) do
      local off = math.sqrt((led.at[1] - at.x) ^ 2 + (led.at[2] - at.y) ^ 2 + (led.at[3] - at.z) ^ 2)
      if (not least or off < least) and not hidden(led.eye, led.place, led.block) then
         best, least = led, off
      end
   end
   return best and least <= 0.005 and NAMES[best.colour] or 0
end

function senses.range(robot, name)
   local finder = FINDERS[name]
   local x, z = finder[1], finder[3]
   if finder[5] then x, z = x + EFFECTOR, z + UNDER + robot.lift end
   local from = on_robot(robot, x, finder[2], z)
   local to
   if finder[4] == 'down' then
      to = { from[1], from[2], from[3] - RANGE }
   else
      local dx, dy = turned(RANGE, 0, robot.yaw + math.rad(finder[4]))
      to = { from[1] + dx, from[2] + dy, from[3] }
   end
   local nearest = 1
   for _, block in ipairs(senses.blocks) do
      nearest = math.min(nearest, enters(block, from, to) or 1)
   end
   if (name == '6' or name == '7') and SUPPORT_FOOT + robot.lift <= z then
      nearest = math.min(nearest, (SUPPORT - x) / RANGE)
   end
   if to[3] < 0 then nearest = math.min(nearest, from[3] / (from[3] - to[3])) end
   return RANGE * nearest
end

senses.turned, senses.on_robot, senses.face_of = turned, on_robot, face_of

return senses
