-- SPDX-License-Identifier: MIT
-- Picks a block of level 0 up.

local ATTEMPTS = 4
local LEAST, MOST = 0.0003, 0.010  -- m, by which the way that is left is put right by touch
local IN_TRANSPORT = 4         -- the colour, if none is said

local Pickup = {}
Pickup.__index = Pickup

function Pickup.new(process, tracker, path, approach, gripper, lift)
   return setmetatable({
      process = process, tracker = tracker, path = path, approach = approach, gripper = gripper,
      lift = lift,
   }, Pickup)
end

-- Drives up to a block of level 0 until it lies below the magnets: true and the block as it was last
-- seen. `heading`, from which to come, is optional.
function Pickup:approach_block(block, heading)
   local near, seen = self.approach:to {
      block = block, heading = heading, lowest = self.lift.OVER_BLOCK, apart = true, brisk = true,
   }
   if not near then return false, seen end
   -- what odometry and camera left over along the way, by touch
   self.process:enter('contact')
   local ahead = self.gripper:seat()
   if math.abs(ahead) > LEAST and math.abs(ahead) < MOST then self.path:go_by(ahead, 0.02) end
   return true, seen
end

-- Lifts the block that lies below the magnets, and colours it. True and whether it answered, or false and why not.
function Pickup:grip_block(block, colour)
   local holds, answered = self.gripper:pull(colour or IN_TRANSPORT)
   if holds then
      self.tracker:forget(block)
      return true, answered
   end
   self.gripper:let_go()
   return false, 'it does not hold'
end

-- Both; options: heading, colour.
function Pickup:pick_up(block, options)
   options = options or {}
   for _ = 1, ATTEMPTS do
      local near, seen = self:approach_block(block, options.heading)
      if not near then return false, seen end
      block = seen
      if self:grip_block(block, options.colour) then return true end
      self.process:enter('back off')
      self.path:back_off(0.12)
   end
   return false, 'it does not hold'
end

return Pickup
