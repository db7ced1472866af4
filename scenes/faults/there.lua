-- SPDX-License-Identifier: MIT
-- Drives `params.ahead` m straight on from where it begins, round what is in the way, for as long as
-- it takes.

local handling = require 'handling'
local travel = require 'travel'

function init()
   handling.start(function()
      handling.enter('drive')
      while not travel.straight_to(robot.params.ahead, 0) do handling.enter('drive again') end
      handling.enter('there')
   end)
end

function step() handling.step() end
