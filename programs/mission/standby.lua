-- SPDX-License-Identifier: MIT
-- What a robot does that is one too many on its side: it stands by, beside the side's cache and farther out, and watches
-- that. Where no block has been taken for long it goes to look, from aside. It begins to work where nobody is left that
-- does, and goes back otherwise, to wait twice as long.
--
-- `params.standby`, 1, 2 ..., says that a robot is the first, second ... such robot of its side. Odd ones begin to the left
-- of the cache, as seen with one's back to the structure, even ones to the right. Its own place is all that the robot knows
-- then.

local geometry = require 'common.geometry'

local BEYOND, ASIDE = 0.06, 0.32  -- m, of where it begins, from the side's cache
local OFF = 0.15               -- m, from where it is expected, of the cache's next block
local INWARDS = 0.45           -- m, of the structure, from the cache
local LOOKOUT = 0.20           -- m, likewise, of where it looks whether somebody works
local GONE = 2                 -- s out of sight of a block that was taken
local PATIENCE = 150           -- s without a block taken until the first goes to look, at least
local FRESH = 1                -- s, in which a block in sight was seen

-- number: of those that stand by on its side, 0 for a robot that works. cache, structure: where they are expected. across:
-- the frame in which one looks across the way from the cache to the structure.
local Standby = {}
Standby.__index = Standby

function Standby.new(machine, map, navigation, sides, supply)
   local number = tonumber(machine.robot.params.standby) or 0
   local right = number % 2 == 1 and -1 or 1  -- in which direction the cache is
   local cache = { x = -BEYOND, y = right * ASIDE }
   return setmetatable({
      process = machine.process, path = machine.path, lift = machine.lift, camera = machine.camera,
      odometry = machine.odometry, tracker = machine.tracker,
      map = map, navigation = navigation, sides = sides, supply = supply, number = number, cache = cache,
      structure = { x = cache.x - INWARDS, y = cache.y },
      across = { x = cache.x - LOOKOUT, y = cache.y, yaw = right * math.pi / 2 },
   }, Standby)
end

-- Ends when the robot is to work.
function Standby:stand_by()
   local patience = PATIENCE * self.number
   while true do
      self:watch_cache(patience * (1 + math.random()))
      if not self.sides:is_worked_across(self.across) then break end
      self.process:enter('stand by')
      self.navigation:to(0, 0)
      patience = 2 * patience
   end
   self.map.cache = self.map.cache or self.cache
end

-- Until no block has been taken there for so many seconds.
function Standby:watch_cache(patience)
   self.process:enter('stand by')
   local pivot = self.odometry:pivot()
   self.path:turn_to(math.atan(self.cache.y - pivot.y, self.cache.x - pivot.x))
   self.lift:look_to(self.camera, geometry.apart(pivot, self.cache) + self.odometry.ahead)()
   local function lies_there(known)
      return geometry.apart(known, self.cache) < OFF and self.supply:is_unused(known)
   end
   local since, seen = self.process:time(), nil
   self.process:wait_until(function()
      local now, known = self.process:time(), self.tracker:recall(lies_there, FRESH)
      if known then
         seen, self.map.cache = now, { x = known.x, y = known.y }
      elseif seen and now - seen > GONE then
         since, seen = now, nil
      end
      return now - since > patience
   end, math.huge)
end

return Standby
