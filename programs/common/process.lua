-- SPDX-License-Identifier: MIT
-- A robot's behaviour as a process in time. Behaviours are functions that take as long as they take
-- and return true, or false and a reason; they run in a coroutine, of which each control step runs
-- one part.

local TIME_OUT = 7.5           -- s

-- state: what the robot is at, for those who watch.
local Process = {}
Process.__index = Process

function Process.new(robot, odometry)
   return setmetatable({ robot = robot, odometry = odometry, state = '' }, Process)
end

-- Runs `main` from now on.
function Process:start(main)
   self.behaviour = coroutine.create(main)
end

-- Once in each step, when all is sensed. False when the behaviour has ended.
function Process:resume()
   if coroutine.status(self.behaviour) == 'dead' then return false end
   local good, problem = coroutine.resume(self.behaviour)
   if not good then error(problem, 0) end
   return true
end

function Process:time()
   return self.odometry.time
end

function Process:wait(seconds)
   local start = self:time()
   while self:time() - start < seconds - 1e-6 do coroutine.yield() end
end

-- Until `done()`, or false after a time.
function Process:wait_until(done, seconds)
   local start = self:time()
   while not done() do
      if self:time() - start > (seconds or TIME_OUT) then return false end
      coroutine.yield()
   end
   return true
end

function Process:enter(state)
   self.state = state
   if self.robot.params.verbose then
      local pose = self.odometry.pose
      log(string.format('%.1f s: %s at %.3f %.3f %.1f', self:time(), state, pose.x, pose.y,
                        math.deg(pose.yaw)))
   end
   if self.robot.show then self.robot.show.text('state', state) end
end

return Process
