-- SPDX-License-Identifier: MIT
-- What a robot that builds does: fetches blocks that nobody uses, looks at the structure from
-- one of its sides, asks what to do there, and does it.
--
-- `stigc compile` writes the two things that are not here: a chart, which says what follows what,
-- and a task, which says what the rules want:
--
--     task.decide(column)  what to do before a column: {what, colour, level, left, rule}, or nil
--     task.asks            cells that it asks for: {du, dv, level} about the column
--     task.looks           where to look from: {distance from camera to column, height of the lift}
--     task.sides           sides to work from, '+x' ...; task.turns: the rules hold in every turn
--     task.widest          rad, between a tag's normal and the line to a camera that reads it
--     task.transport       colour of a block on its way (0: dark)
--     task.starts          what bricks show that stand at first
--     task.structure       what stands in the end: {x, y, level, colour} of each brick; empty where that is large
--     task.answers         blocks do, when they are told a colour
--     task.kinds           of brick, where blocks show code words (common/led_code.lua); nil: four colours
--     task.delay           s, the longest random wait before a site is approached; 0: there is but one robot
--
-- A scene may bind a robot to some of the sides: see mission/side_allocation.lua.

local Machine = require 'machine'
local Navigation = require 'motion.navigation'
local BlockSupply = require 'mission.block_supply'
local Record = require 'mission.record'
local SideAllocation = require 'mission.side_allocation'
local SiteWork = require 'mission.site_work'
local Standby = require 'mission.standby'
local StructureMap = require 'mission.structure_map'

local LOOK_TIME = 1.0          -- s
local LEGS = 12                -- of a search for the structure
local FIRST_WAIT = 0.125       -- of the longest wait, since the last brick
local TURNS = 2                -- approaches that the longest wait lasts at least, of those that take long
local OTHERS_WORK = 15         -- s, that another takes from where it was seen at a site until its block is there
local OTHERS_LEAVE = 4         -- s, in which it is out of the way then

local Builder = {}
Builder.__index = Builder

-- What the chart's states do: a method of the builder or of one of its parts.
Builder.BEHAVIOURS = {
   wait = 'builder', search_structure = 'builder', next_side = 'builder', let_go = 'builder',
   search_block = 'supply', approach_block = 'supply', pick_up = 'supply', lay_aside = 'supply',
   sleep = 'supply', find_cache = 'supply',
   choose_row = 'work', stand_before = 'work', look = 'work', approach_site = 'work', attach = 'work',
   recolour = 'work',
}

function Builder.new(robot, chart, task)
   local machine = Machine.new(robot)
   task = setmetatable({ sides = SideAllocation.own(robot.params, task), all_sides = task.sides }, { __index = task })
   local map = StructureMap.new(robot, machine.odometry, machine.tracker, task)
   local navigation = Navigation.new(machine, map)
   local sides = SideAllocation.new(machine, map, navigation, task)
   local record = Record.new(robot)
   local supply = BlockSupply.new(machine, map, navigation, sides, record, task)
   local self = setmetatable({
      machine = machine, process = machine.process, map = map, navigation = navigation, sides = sides,
      record = record, chart = chart, task = task, supply = supply,
      standby = Standby.new(machine, map, navigation, sides, supply),
      work = SiteWork.new(machine, map, navigation, sides, record, task),
   }, Builder)
   self.builder = self
   if self.standby.number > 0 then map.expected = self.standby.structure end
   machine.placement.transport, machine.clearance.transport = task.transport, task.transport
   machine.placement.floats = function(block) return map:floats(block) end
   machine.clearance.room = function(x, y) return map:room_about(x, y) end
   machine.clearance.explained = function(x, y) return map:explains(x, y) end
   machine.clearance.alone = task.delay == 0
   local function bricks() return map:all_bricks() end
   machine.clearance.bricks, machine.sight.remembered = bricks, bricks
   if task.widest then machine.sight:reads_up_to(task.widest) end
   if task.kinds then machine.tracker.detector.kinds = task.kinds end
   machine:start(function() self:follow_chart() end)
   return self
end

function Builder:step()
   self.machine:step()
end

-- For ever: each of the chart's states is something done, which ends with an event, and the chart says
-- which state that leads to.
function Builder:follow_chart()
   if self.standby.number > 0 then self.standby:stand_by() end
   local chart, state = self.chart, self.chart.first
   local begun = {}
   while true do
      -- what takes no time does not take a step either, unless it leads to itself
      if begun[state] == self.process:time() then coroutine.yield() end
      begun[state] = self.process:time()
      self.process:enter(state)
      self.record:tell('chart', state)
      local does = chart[state].does
      local part = self[Builder.BEHAVIOURS[does]]
      local event = part[does](part)
      state = chart[state].on[event] or
              error("the chart says nothing of '" .. event .. "' in '" .. state .. "'")
   end
end

-- For a random while, which is short as long as nobody is met, and twice as long each time that somebody was:
-- robots that came at the same time come one after the other. Where it has left a site to another, only until that one's
-- brick is seen, or might be there, and a short while: all that see it come then, and at corners they have to feel each other.
-- Not at all where robots take turns, as long as nobody is met.
function Builder:wait()
   local longest, share, yielded = self.task.delay, FIRST_WAIT, self.work.yielded
   self.work.yielded = false
   if self.work.obstructed == 0 and self.sides:take_turns() then return 'done' end
   if yielded and self.work.right_of_way:feels_across() then
      if self.process:wait_until(self.map:sees_new_brick(), OTHERS_WORK) then self.process:wait(OTHERS_LEAVE) end
   else
      share = math.min(1, FIRST_WAIT * 2 ^ self.work.obstructed)
      if longest > 0 then longest = math.max(longest, TURNS * self.work.approach_time) end
   end
   self.process:wait(math.random() * share * longest)
   return 'done'
end

-- Where the nearest brick is that it knows, or nil: a look at the middle of a large structure would lead into it.
function Builder:nearest_brick()
   return self.map.known and self.map:nearest_brick(self.machine.odometry:pivot())
end

-- The structure in memory, or after a look where it is known or was at first, or a search.
function Builder:find_structure()
   local map = self.map
   -- what may be a lost brick counts where a search shows nothing else
   local function in_memory()
      local structure = map:in_memory()
      return structure and (map.known or not map:may_be_lost(structure.blocks)) and structure or nil
   end
   local found = in_memory()
   if not found and (map.known or not map.lost) then
      self.navigation:look_again(self:nearest_brick() or map.expected, in_memory)
      if not map.known then self.process:wait(LOOK_TIME) end
      found = in_memory()
   end
   if found then return found end
   local function is_of_structure(block) return map:is_of_structure(block) end
   local function wander(x, y) return self.navigation:wander(x, y) end
   if not self.machine.search:find(is_of_structure, LEGS, wander) then
      self.navigation:straight_to(0, 0)
      return map:in_memory(true)
   end
   self.process:wait(LOOK_TIME)
   return map:in_memory(true)
end

function Builder:search_structure()
   if not self.machine.magnets:holds() then return 'dropped' end
   local found = self:find_structure()
   if not found then return 'none' end
   if not self.map:remember(found) then return 'lost' end
   if self.map:settle() then self.work:begin_side() end
   return 'found'
end

function Builder:next_side()
   if self.work:stays() then return 'there' end
   local map = self.map
   -- what came in sight in a rest may have told that the structure is elsewhere
   if not map.known then return 'lost' end
   local cache = map.cache
   if self.sides:change() then self.supply.last_cache = cache end
   -- what was seen before the turns on the way does not fit what is seen now
   self.machine.tracker:forget_all()
   if self.navigation:look_again(self:nearest_brick(), function() return map:in_memory() end) then return 'there' end
   return 'lost'
end

function Builder:let_go()
   self.machine.gripper:let_go()
   self.machine.path:back_off(0.15)
   return 'done'
end

return Builder
