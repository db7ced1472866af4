-- SPDX-License-Identifier: MIT
-- What a robot that builds counts, and shows to those who watch: bricks placed, attempts aborted, and
-- those of them for which another robot was in the way (busy). They also see the chart's state (chart), and of
-- each decision the branch that was taken (branch) and what it was told (told).

local Record = {}
Record.__index = Record

function Record.new(robot)
   local self = setmetatable({ robot = robot, placed = 0, aborted = 0, busy = 0, recoloured = 0 }, Record)
   self:show('placed')
   return self
end

function Record:show(name)
   if self.robot.show then self.robot.show.number(name, self[name]) end
end

-- A word for those who watch alone.
function Record:tell(name, text)
   if self.robot.show then self.robot.show.text(name, text) end
end

function Record:tally(name)
   self[name] = self[name] + 1
   self:show(name)
end

return Record
