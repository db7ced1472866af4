-- SPDX-License-Identifier: MIT
-- The rangefinders, in metres whatever they report.

local RangeSensors = {}
RangeSensors.__index = RangeSensors

local NOTHING = 1              -- m, more than any of them reaches

function RangeSensors.new(robot, description)
   return setmetatable({ robot = robot, description = description }, RangeSensors)
end

-- Metres from a reading, by the calibration of the rangefinder's file; v = exp(-metres) is what it is
-- about. Nil when nothing is within its range.
local CALIBRATIONS = {
   metres = function(reading, finder)
      return reading < finder.range - 0.0001 and reading or nil
   end,
   -- counts = a v^b
   power = function(reading, finder)
      local a, b = table.unpack(finder.coefficients)
      return reading > 0 and math.max(0, math.log(a / reading) / b) or nil
   end,
   -- counts = c0 + c1 v + c2 v²
   quadratic = function(reading, finder)
      local c0, c1, c2 = table.unpack(finder.coefficients)
      if reading <= 0 then return nil end
      local root = math.sqrt(c1 ^ 2 - 4 * c2 * (c0 - reading))
      return math.max(0, -math.log((-c1 + root) / (2 * c2)))
   end,
}

-- Metres, or nil when nothing is within its range, or the robot has no such rangefinder.
function RangeSensors:range(name)
   local finder = self.robot.rangefinders and self.robot.rangefinders[name]
   if not finder then return nil end
   local described = self.description.rangefinders[name]
   return CALIBRATIONS[described.calibration](finder.proximity, described)
end

-- How far the chassis' rangefinders see; without limit where there are none.
function RangeSensors:reach()
   local least = math.huge
   for _, ray in ipairs(self:chassis_rays()) do
      least = math.min(least, self.description.rangefinders[ray.name].range)
   end
   return least
end

-- The least of some readings, m; 1 where nothing is near.
function RangeSensors:nearest(names)
   local least = NOTHING
   for _, name in ipairs(names) do least = math.min(least, self:range(name) or NOTHING) end
   return least
end

-- Whether something is that near under the end effector.
function RangeSensors:underneath_within(distance)
   local range = self:range('underneath')
   return range ~= nil and range <= distance
end

-- The chassis' rangefinders: {name, from, to}, place and direction in the robot's frame.
function RangeSensors:chassis_rays()
   local rays = {}
   for number = 1, 12 do
      local name = tostring(number)
      local finder = self.robot.rangefinders and self.robot.rangefinders[name]
      if finder then
         local way = vector3(0, 0, 1):rotate(finder.transform.orientation)
         table.insert(rays, { name = name, from = finder.transform.position, to = way })
      end
   end
   return rays
end

return RangeSensors
