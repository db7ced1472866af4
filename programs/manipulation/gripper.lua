-- SPDX-License-Identifier: MIT
-- Takes the block below the end effector, colours it, and lets go of it.

local geometry = require 'common.geometry'
local led_code = require 'common.led_code'

local PULSE, LOWER = 0.006, 0.003  -- heights of the lift over a block on the floor
local CARRY_FAR = 0.080        -- passes over a block without being drawn to it
local LET_GO = 0.030           -- up from a block that was put down
local PULSE_TIME, LOWER_TIME, SETTLE_TIME = 0.5, 0.5, 0.2  -- s
local READY, EMPTY = 1.065, 1.06   -- of the charge without a field: at least, to let go, and down to which current flows, for a
                               -- step at least: a block comes to rest farther aside where the effector rises as it falls
local CHARGE_TIME, EMPTY_TIME = 8, 6  -- s, at most
local BEHIND_BLOCK = 0.025     -- m, of the rangefinders behind a block that see it
local FINDERS_APART = 0.040    -- m
local SLIPPED, SURELY = 0.005, 3  -- m, off what was read before, in so many readings in turn: the block hangs otherwise by now
local REMEMBERED = 50          -- readings of a carried block's back, at most
local FIRST_CHARACTER = 48     -- '0', of colours as the radio sends them
local WORD = 119               -- 'w', before the four of a code word
local ANSWER = 97              -- 'a', before what a block says to have heard
local ANSWER_TIME = 0.3        -- s, since the step after it was sent: it hears in that, and is heard in the next
local PASS = 112               -- 'p', before what a block is to pass on to the one below it
local PASS_TIME, HOP_TIME = 1.0, 0.4  -- s, likewise, that the answer takes by way of one such block, and of each further one
local SENDS = 2

-- neutral: the charge at which a current takes the magnets' field away. gap: from the rangefinders
-- behind a block to its face, m, when it hangs right below the magnets.
local Gripper = {}
Gripper.__index = Gripper

function Gripper.new(robot, description, ranges, process, magnets, lift)
   return setmetatable({
      robot = robot, ranges = ranges, process = process, magnets = magnets, lift = lift,
      neutral = description.magnets.neutral,
      gap = description.magnets.ahead - geometry.HALF - description.rangefinders.left.x,
   }, Gripper)
end

-- What the two rangefinders at the back of the block say: left, right; nothing where none is.
function Gripper:back_of_block()
   local left, right = self.ranges:range('left'), self.ranges:range('right')
   if not left or not right or math.max(left, right) > BEHIND_BLOCK then return nil end
   return left, right
end

-- Call it once a step: the mean of what they said of a block that is carried, since a reading may be
-- off by a millimetre, which is two degrees. One that is far off counts only where the next ones are, too.
function Gripper:sense()
   local left, right = self:back_of_block()
   if not left or not self.magnets.carrying then
      self.felt = nil
      return
   end
   local felt = self.felt
   local off = felt and (math.abs(left - felt.left) > SLIPPED or math.abs(right - felt.right) > SLIPPED)
   if off then
      felt.off = felt.off + 1
      if felt.off < SURELY then return end
   end
   if off or not felt then felt = { left = left, right = right, count = 0 } end
   felt.count, felt.off = math.min(felt.count + 1, REMEMBERED), 0
   felt.left = felt.left + (left - felt.left) / felt.count
   felt.right = felt.right + (right - felt.right) / felt.count
   self.felt = felt
end

-- How a block sits below the magnets: how far its middle is ahead of where it should be, and its yaw.
function Gripper:seat()
   local left, right = self:back_of_block()
   if not left then return 0, 0 end
   if self.felt then left, right = self.felt.left, self.felt.right end
   return (left + right) / 2 - self.gap, math.atan((right - left) / FINDERS_APART)
end

-- From those rangefinders to the back of a block, m, as they say now; nil where they see none.
function Gripper:way_to_back()
   local left, right = self.ranges:range('left'), self.ranges:range('right')
   return left and right and (left + right) / 2
end

-- A function that says, once a step, whether the carried block has been drawn ahead by more than `most`, and by
-- `further` than it hangs now, or those finders see nothing: for two steps, since readings may be off.
function Gripper:drawn_off(most, further)
   local farthest, before = math.max(most, self:seat() + further) + self.gap, false
   return function()
      local back = self:way_to_back()
      local now = not back or back > farthest
      local drawn = now and before
      before = now
      return drawn
   end
end

-- A function that says, once a step, whether the carried block has been pushed back by more than `most` from where it
-- hangs now, by the mean of two steps: it has caught on something.
function Gripper:pushed_back(most)
   local nearest, before = self:seat() + self.gap - most, nil
   return function()
      local now = self:way_to_back()
      local pushed = now and before and (now + before) / 2 < nearest or false
      before = now
      return pushed
   end
end

-- Whether a block's answer to a message has come in.
function Gripper:hears_answer(message)
   for _, heard in ipairs(self.robot.simple_radios.nfc.recv or {}) do
      local same = heard[1] == ANSWER
      for i, byte in ipairs(message) do same = same and heard[i + 1] == byte end
      if same then return true end
   end
   return false
end

-- What tells a block its colour: 1 to 4, 0 for dark, or the kind of a code word.
local function message_of(colour)
   if colour <= led_code.PLAIN then return { FIRST_CHARACTER + colour } end
   local message = { WORD }
   for i, letter in ipairs(led_code.word_of(colour)) do message[i + 1] = FIRST_CHARACTER + letter end
   return message
end

-- Sends something, and waits for a message to be answered. Whether it was.
function Gripper:ask(sent, message, time)
   self.robot.simple_radios.nfc.send(sent)
   coroutine.yield()
   return self.process:wait_until(function() return self:hears_answer(message) end, time)
end

-- Colours the carried block (or the one at the radio). Whether it answered.
function Gripper:colour(colour)
   local message = message_of(colour)
   for _ = 1, SENDS do
      if self:ask(message, message, ANSWER_TIME) then return true end
   end
   return false
end

-- Colours the block so many blocks below the carried one, which passes the message on, as those in between do. Whether it
-- answered.
function Gripper:colour_below(colour, blocks)
   local message, sent = message_of(colour), {}
   for hop = 1, blocks do sent[hop] = PASS end
   return self:ask(table.move(message, 1, #message, blocks + 1, sent), message, PASS_TIME + HOP_TIME * (blocks - 1))
end

-- Takes the block that lies below the magnets, and colours it on its way up. Whether it came along, and whether it answered.
function Gripper:pull(colour)
   local magnets, lift = self.magnets, self.lift
   self.process:enter('pull')
   lift:to(PULSE)
   magnets:discharge('constructive')
   self.process:wait(PULSE_TIME)
   lift:to(LOWER)
   self.process:wait(LOWER_TIME)
   magnets.carrying = true
   local arrive = lift:set_out(CARRY_FAR)
   local answered = self:colour(colour)
   arrive()
   magnets:discharge('disable')
   self.process:wait(SETTLE_TIME)
   return magnets:has_lifted(), answered
end

-- Lets the current flow against the magnets' own field until the two cancel, and goes up before it
-- turns over: a block's free magnets would follow. Whether the block stayed behind.
function Gripper:let_go()
   local magnets, neutral = self.magnets, self.neutral
   self.process:wait_until(function() return magnets:charge() >= READY * neutral end, CHARGE_TIME)
   magnets:discharge('destructive')
   self.process:wait_until(function() return magnets:charge() <= EMPTY * neutral end, EMPTY_TIME)
   magnets.carrying = false
   self.lift:to(math.min(self.lift:height() + LET_GO, self.lift.highest))
   magnets:discharge('disable')
   return not magnets:feels_block()
end

return Gripper
