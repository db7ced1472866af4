-- SPDX-License-Identifier: MIT
-- Looks for an unlit block, drives up to it, picks it up with the electromagnets, marks it as in
-- transport and carries it a while. Written for the BuilderBot's interface; the steps and figures
-- are those that Allwright et al. 2017 describe. Lengths in metres, times in seconds.
-- Parameters, all optional: turn, speed, search_height, contact (reading of the rangefinder
-- 'underneath' that means contact), face (of 'left' and 'right' that means that the block is
-- where it is to be picked up), counts (true when readings grow as things come near).

local BLOCK_SIDE = 0.055
local IN_TRANSPORT = '4'
local LED_OFFSETS = {
   vector3(0.02, 0, 0), vector3(-0.02, 0, 0), vector3(0, 0.02, 0), vector3(0, -0.02, 0),
}

local state, since, holding

local function drive(left, right)
   robot.differential_drive.set_target_velocity(left, -right)
end

local function enter(name)
   state = name
   since = robot.system.time
   robot.logger:log_info('state', name)
end

local function elapsed()
   return robot.system.time - since
end

-- The colour of the block that a tag is on: of the four LEDs round the tag, the first lit one.
local function colour_of(tag)
   for _, offset in ipairs(LED_OFFSETS) do
      local led = vector3(offset):rotate(tag.orientation) + tag.position
      local colour = robot.camera_system.detect_led(led)
      if colour ~= 0 then return colour end
   end
   return 0
end

-- The nearest unlit block in sight, as the tag that shows it.
local function find_block()
   local best, best_distance
   for _, tag in ipairs(robot.camera_system.tags) do
      local far = tag.position:length()
      if colour_of(tag) == 0 and (not best or far < best_distance) then
         best, best_distance = tag, far
      end
   end
   return best
end

local function touches()
   local finder = robot.rangefinders.underneath
   if not finder then return false end
   local contact = robot.params.contact or (robot.params.counts and 2260 or 0.010)
   if robot.params.counts then return finder.proximity >= contact end
   return finder.proximity > 0 and finder.proximity <= contact
end

-- The block is wholly under the effector when its face is near what holds the effector.
local function at_face()
   for _, name in ipairs { 'left', 'right' } do
      local finder = robot.rangefinders[name]
      if finder then
         local face = robot.params.face or (robot.params.counts and 2490 or 0.006)
         local near = finder.proximity > 0 and finder.proximity <= face
         if robot.params.counts then near = finder.proximity >= face end
         if near then return true end
      end
   end
   return not robot.rangefinders.left and not robot.rangefinders.right
end

local states = {}

function states.search()
   drive(-robot.params.turn, robot.params.turn)
   if find_block() then enter('approach') end
end

-- Steers on the tag's place in the image; the lift keeps the tag in sight until it is down.
function states.approach()
   local tag = find_block()
   if not tag then
      -- lost: over the bottom edge of the image with the lift down it is just ahead
      if robot.lift_system.position < 0.002 then enter('reach')
      elseif elapsed() > 7.5 then enter('search') end
      return
   end
   since = robot.system.time
   local width, height = robot.camera_system.resolution.x, robot.camera_system.resolution.y
   local aside = (tag.center.x - width / 2) / (width / 2)        -- positive: to the right
   local low = (tag.center.y - height / 2) / (height / 2)        -- positive: below the middle
   -- slower near the image's edges, so that neither wheels nor lift lose the tag
   local speed = robot.params.speed * (1 - 0.5 * math.abs(aside)) *
                 (1 - math.max(0, math.min(0.8, low)))
   drive(speed + aside * robot.params.speed, speed - aside * robot.params.speed)
   local wanted = robot.lift_system.position - 0.02 * low
   robot.lift_system.set_position(math.max(0, math.min(0.135, wanted)))
   robot.show.arrow(vector3(), vector3(tag.position.z, -tag.position.x, 0), 'orange')
end

-- A little higher, so that the magnets do not catch the block by its near edge.
function states.reach()
   robot.lift_system.set_position(0.009)
   drive(0.5 * robot.params.speed, 0.5 * robot.params.speed)
   if touches() and at_face() then enter('pull') elseif elapsed() > 7.5 then enter('back') end
end

function states.back()
   drive(-robot.params.speed, -robot.params.speed)
   robot.lift_system.set_position(robot.params.search_height)
   if elapsed() > 2 then enter('search') end
end

function states.pull()
   drive(0, 0)
   robot.lift_system.set_position(0.003)
   robot.electromagnet_system.set_discharge_mode('constructive')
   if elapsed() > 1 then enter('lift') end
end

function states.lift()
   robot.electromagnet_system.set_discharge_mode('disable')
   robot.lift_system.set_position(BLOCK_SIDE + 0.003)
   if robot.lift_system.state ~= 'inactive' or elapsed() < 0.5 then return end
   holding = touches()
   if not holding then enter('back') return end
   robot.simple_radios.nfc.send(IN_TRANSPORT)
   enter('carry')
end

function states.carry()
   drive(robot.params.speed, robot.params.speed)
end

function init()
   robot.camera_system.enable()
   reset()
end

function reset()
   robot.params.turn = robot.params.turn or 0.02
   robot.params.speed = robot.params.speed or 0.03
   robot.params.search_height = robot.params.search_height or 0.135
   holding = false
   enter('search')
   robot.lift_system.set_position(robot.params.search_height)
end

function step()
   states[state]()
   robot.show.text('state', state)
   robot.show.text('holding', holding)
end

function destroy()
   drive(0, 0)
   robot.camera_system.disable()
end
