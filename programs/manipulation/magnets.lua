-- SPDX-License-Identifier: MIT
-- The electromagnets, and whether a block hangs on them.

local HELD = 0.010             -- m, under the end effector, of a carried block
local JUST_LIFTED = 0.005      -- m, likewise of one that has come along

local Magnets = {}
Magnets.__index = Magnets

-- carrying: a block was lifted, and seen there when it was last looked for; lost: the last one fell.
function Magnets.new(robot, ranges)
   return setmetatable({ robot = robot, ranges = ranges, carrying = false, lost = false }, Magnets)
end

-- Whether current flows that makes the magnets hold harder, until their charge has sunk.
function Magnets:hold_fast(on)
   self.robot.electromagnet_system.set_discharge_mode(on and 'constructive' or 'disable')
end

function Magnets:discharge(mode)
   self.robot.electromagnet_system.set_discharge_mode(mode)
end

function Magnets:charge()
   return self.robot.electromagnet_system.voltage
end

-- Whether a block is right under the end effector.
function Magnets:feels_block()
   return self.ranges:underneath_within(HELD)
end

-- Whether the block that was lifted has come along.
function Magnets:has_lifted()
   self.carrying, self.lost = self.ranges:underneath_within(JUST_LIFTED), false
   return self.carrying
end

-- Whether the carried block is still there.
function Magnets:holds()
   local carried = self.carrying
   self.carrying = carried and self:feels_block()
   self.lost = self.lost or carried and not self.carrying
   return self.carrying
end

return Magnets
