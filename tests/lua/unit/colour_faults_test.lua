-- SPDX-License-Identifier: MIT
-- Bricks of a wrong colour: what is found is right, of whatever part of a structure a robot knows.

local ColourFaults = require 'mission.colour_faults'
local Target = require 'mission.target'
local unit = require 'unit'
local case, same = unit.case, unit.same

local STAIRCASE = { { 0, 0, 0, 3 }, { 0, 0, 1, 3 }, { 0, 0, 2, 3 }, { 1, 0, 0, 2 }, { 1, 0, 1, 2 }, { 2, 0, 0, 1 } }
-- its two ends are alike but for one colour
local BAR = { { 0, 0, 0, 1 }, { 1, 0, 0, 2 }, { 2, 0, 0, 2 }, { 3, 0, 0, 3 } }
-- a turn by half a circle shows the same
local EVEN = { { 0, 0, 0, 1 }, { 1, 0, 0, 2 }, { 2, 0, 0, 1 }, { 1, 1, 0, 3 }, { 1, -1, 0, 3 } }

-- A structure's bricks as a robot knows them that stands elsewhere, turned by so many quarters, with those `chosen(i)`.
local function known_of(structure, quarters, chosen)
   local out = {}
   for i, brick in ipairs(structure) do
      local u, v = brick[1], brick[2]
      for _ = 1, quarters do u, v = -v, u end
      if chosen(i) then table.insert(out, { u = u + 7, v = v - 3, level = brick[3], colour = brick[4], right = brick[4] }) end
   end
   return out
end

-- Calls `with(known)` for every part of a structure.
local function for_each_part(structure, with)
   for part = 1, 2 ^ #structure - 1 do
      local function chosen(i) return part // 2 ^ (i - 1) % 2 == 1 end
      for quarters = 0, 3 do with(known_of(structure, quarters, chosen)) end
   end
end

-- How many single faults of known bricks are found, and how many there are; none may be found where none is.
local function faults_found(known, structure)
   local found, all = 0, 0
   for _, brick in ipairs(known) do
      for colour = 0, 4 do
         if colour ~= brick.right then
            brick.colour = colour
            local wrong, right = ColourFaults.find(known, Target.new(structure))
            if wrong then
               same('the brick', wrong, brick)
               same('its colour', right, brick.right)
            end
            found, all = found + (wrong and 1 or 0), all + 1
         end
      end
      brick.colour = brick.right
   end
   return found, all
end

case('every single fault of any part of a structure is found as it is, or not at all', function()
   for _, structure in ipairs { STAIRCASE, BAR, EVEN } do
      local found, all = 0, 0
      for_each_part(structure, function(known)
         local f, a = faults_found(known, structure)
         found, all = found + f, all + a
      end)
      same('some are found', found > all // 4, true)
   end
end)

case('all are found of a whole structure whose bricks cannot be taken for each other', function()
   local whole = known_of(STAIRCASE, 3, function() return true end)
   local found, all = faults_found(whole, STAIRCASE)
   same('found', found, all)
end)

case('nothing is found where no brick is wrong', function()
   for _, structure in ipairs { STAIRCASE, BAR, EVEN } do
      for_each_part(structure, function(known) same('fault', ColourFaults.find(known, Target.new(structure)), nil) end)
   end
   same('of no bricks', ColourFaults.find({}, Target.new(STAIRCASE)), nil)
end)

case('nothing is found where two bricks are wrong, or one is in no cell of the structure', function()
   local known = known_of(STAIRCASE, 0, function() return true end)
   known[1].colour, known[5].colour = 1, 4
   same('two', ColourFaults.find(known, Target.new(STAIRCASE)), nil)
   known = known_of(STAIRCASE, 0, function() return true end)
   known[4].colour = 1
   table.insert(known, { u = 9, v = 9, level = 0, colour = 1 })
   same('elsewhere', ColourFaults.find(known, Target.new(STAIRCASE)), nil)
end)

case('which of two may be wrong is not guessed', function()
   -- either end may be the wrong one: 2 2 3 or 1 2 2
   same('either', ColourFaults.find({ { u = 0, v = 0, level = 0, colour = 2 }, { u = 1, v = 0, level = 0, colour = 2 },
                                      { u = 2, v = 0, level = 0, colour = 2 } }, Target.new(BAR)), nil)
end)
