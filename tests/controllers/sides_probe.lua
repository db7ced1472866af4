-- SPDX-License-Identifier: MIT
-- Goes from side +x of a structure, 0.3 m ahead, to its next side, and says what came of it.
-- Parameters: side ('+x'), sides.

local handling = require 'handling'
local lattice = require 'lattice'
local sides = require 'sides'

local function main()
   local task = { delay = 30, transport = 4, sides = { '+x', '+y', '-x', '-y' } }
   task.sides = sides.own(task)
   handling.wait(0.4)
   lattice.start(task)
   sides.start(task)
   lattice.known = { x = 0.3, y = 0, reach = 0.03, yaw = 0, origin = { x = 0.3, y = 0 } }
   lattice.side, lattice.cache, lattice.cache_way = lattice.SIDES['+x'], { x = -0.2, y = 0 }, 0.5
   local changed = sides.change()
   handling.wait(1)
   log(string.format('changed %s, side %s, cache at %.2f %.2f', changed, lattice.side_name(),
                     lattice.cache.x, lattice.cache.y))
end

function init() handling.start(main) end
function step() handling.step() end
