-- SPDX-License-Identifier: MIT
-- Blocks that carry the rules of what they become, after Sugawara and Doi 2016: a block that has a
-- place in the shape offers the places beside it by radio and lights the faces where a block may
-- come; one that arrives takes its place from what it hears. The seed is the block whose name is
-- that of the shape. Messages: 'o', shape, i, j: "a block here has place i, j"; 't': "taken".

local SIZE = 4
local SHAPES = {
   -- ahead along the seed's x axis
   line = function(i, j) return { north = i + 1 < SIZE and { i + 1, j } or nil } end,
   -- rows that grow shorter
   triangle = function(i, j)
      local room = i + j + 1 < SIZE
      return { north = j == 0 and room and { i + 1, j } or nil,
               west = room and { i, j + 1 } or nil }
   end,
}
local LETTERS = { l = 'line', t = 'triangle' }
local FACES = { 'north', 'east', 'south', 'west', 'top', 'bottom' }
local OFFER, PART = 'Q2', 'Q3'

local PERIOD = 3   -- steps between offers: who sends does not hear

local shape, offers
local steps = 0

local function light(face, colour)
   for number, name in ipairs(FACES) do
      for led = 4 * number - 3, 4 * number do
         if name == face then robot.directional_leds.set_single_color(led, colour) end
      end
   end
end

local function become(name, i, j)
   shape = name
   offers = SHAPES[name](i, j)
   for _, face in ipairs(FACES) do light(face, offers[face] and OFFER or PART) end
end

local function hear(face, message)
   local kind = string.char(message[1] or 0)
   if kind == 't' and offers and offers[face] then
      offers[face] = nil
      light(face, PART)
   elseif kind == 'o' and #message == 4 then
      local name = LETTERS[string.char(message[2])]
      if not shape and name then become(name, message[3], message[4]) end
      if shape then robot.simple_radios[face].send('t') end
   end
end

function init()
   robot.directional_leds.set_all_colors('off')
   if SHAPES[robot.id] then become(robot.id, 0, 0) end
end

function step()
   for _, face in ipairs(FACES) do
      for _, message in ipairs(robot.simple_radios[face].recv) do hear(face, message) end
   end
   steps = steps + 1
   if steps % PERIOD ~= 0 then return end
   for face, place in pairs(offers or {}) do
      robot.simple_radios[face].send { 111, shape:byte(1), place[1], place[2] }
   end
end
