-- SPDX-License-Identifier: MIT
-- Puts the carried block down next to another: where = 'raise', on top of it; 'extend', in front of it,
-- on the robot's side; 'beside', to the left of it by `left`.

local Approach = require 'manipulation.approach'
local geometry = require 'common.geometry'

local SIDE = geometry.SIDE
local CLEAR = 0.014            -- of a carried block over what it passes, more than magnets reach
local DRAW, SHY = 0.025, 0.001 -- from a face: where it begins to draw, and where to stop
local ASIDE = 0.002            -- from a neighbour beside, which draws the block when it is there
local CAUGHT = 0.0035          -- back in the gripper, of a block that has caught on something on its way in
local CATCHES = 2              -- so often at most it comes again, ASIDE more off that neighbour each time
local NEARER = 0.0005          -- less than that, at most, for a block that a turn takes away from it
local DRAWN_OFF, FURTHER = 0.005, 0.003  -- ahead in the gripper, and than before: neighbours have drawn the block into
                                         -- its place
local REST = 0.0015            -- of a block over what it is put on, and less than 1 mm more, on its way in
local LET_DOWN = 0.002         -- likewise when it is let go: on its way down it slides into line with its neighbours,
                               -- before what it comes to lie on holds it
local FROM_OVER = 0.001        -- likewise of one that has come down from above: from 2 mm it may jump to a neighbour so high that
                               -- its upper edge meets the brick over that, and turns it
local SET_DOWN = 0.0003        -- likewise where it would be drawn aside on a longer way
local DROP = 0.006             -- likewise over the floor, where the effector is kept off by KEPT_OFF or more: the floor's
local KEPT_OFF = 0.004         -- friction would hold it against magnets that are so far
-- of a block over a brick to which it passes a message on, ever lower until that answers: radios reach 20 mm, and are up to
-- 5 mm below their faces
local PASSES = { CLEAR, 0.0080, 0.0052, 0.0045, 0.0038 }
local BACK_SLOWLY = 0.05       -- m, from over it
local CARRIED = 0.12           -- m, from a site, where a block in another robot's hand is in the way
local CONTESTED = 0.08         -- m, likewise at any height, on the last way to the site: nearer than who looks aside
local TAKEN = 0.6 * SIDE       -- from a site's middle, where a block is that fills it
local SEEN_LATELY = 2          -- s
local SEEN_NOW = 0.7           -- s, in which a tag in sight was seen
local SETTLE_TIME = 0.4        -- s
local RELEASES = 3             -- attempts to let go
local TURNED = 0.012           -- rad, by which a block hangs askew that is worth a turn: how blocks hang differs by 0.003, and
                               -- what the rangefinders say of that by 0.005
local UNDER_TOP = 0.0005       -- m, of the lift

local Placement = {}
Placement.__index = Placement

-- parts: odometry, process, tracker, path, magnets, lift, gripper, approach. transport:
-- the colour of a block in a robot's hand. floats: set by who knows a structure: whether a block without a colour is in one;
-- spared: id of a brick that shows the colour of one, or false.
function Placement.new(parts)
   local self = setmetatable({ transport = 4, spared = false, floats = function() return false end }, Placement)
   for name, part in pairs(parts) do self[name] = part end
   return self
end

-- How high over what it is put on a block is let go; `short`: how far it is before its place, nil where it came from above.
local function let_go_over(level, drawn, short)
   if level == 0 and short and short > KEPT_OFF then return DROP end
   if drawn then return SET_DOWN end
   return short and LET_DOWN or FROM_OVER
end

-- Puts the carried block down on `level`, over the gripping point; `colour` is set before. `drawn`: what stands about
-- the place would draw it aside; `short`: how far it was slid in short of its place, nil where it came from above.
function Placement:release(level, colour, drawn, short)
   local over = SIDE * level + let_go_over(level, drawn, short)
   self.process:enter('release')
   -- first the colour: near its place magnets draw the block away from the radio
   if colour then self.gripper:colour(colour) end
   self.lift:to(over)
   self.process:wait(SETTLE_TIME)
   for _ = 1, RELEASES do
      if self.gripper:let_go() then
         self.process:enter('reverse')
         self.path:go_by(-0.15, 0.15)
         return true
      end
      self.lift:to(over)
   end
   return false, 'it does not let go'
end

-- Whether a block on a level can be come over.
function Placement:reaches(level)
   return SIDE * level + CLEAR <= self.lift.highest - UNDER_TOP
end

-- From DRAW before a place, where the magnets of its neighbours begin to draw the carried block, down to
-- the level and on to it, or as far as the effector goes. How far before its place the block is then, 0 where it was
-- drawn in.
function Placement:slide_in(level)
   self.process:enter('slide in')
   local drawn_off = self.gripper:drawn_off(DRAWN_OFF, FURTHER)
   local line = self.odometry:line_ahead()
   self.lift:to(SIDE * level + REST)
   -- what goes on would push a block that is in its place already
   drawn_off()
   coroutine.yield()
   if drawn_off() then return 0 end
   -- beside a neighbour the block is to give way, and not the neighbour that draws it
   self.magnets:hold_fast(self.site_aside == 0)
   -- the neighbours draw the robot too
   self.approach:creep(DRAW - SHY - self.odometry:on_line(line), nil, drawn_off)
   self.magnets:hold_fast(false)
   return drawn_off() and 0 or DRAW - self.odometry:on_line(line)
end

-- A block that another robot is seen to hold over a place, `within` m of it beside, or nil; `counts(block)`, if given,
-- says which of these count.
function Placement:held_near(x, y, within, counts)
   for _, known in ipairs(self.tracker.tracks) do
      local dx, dy = known.x - x, known.y - y
      local in_hand = known.colour == self.transport or known.colour == 0 and self.floats(known)
      if in_hand and known.id ~= self.spared and known.z > SIDE and
         self.odometry.time - known.time < SEEN_LATELY and dx * dx + dy * dy < within * within and
         (not counts or counts(known)) then return known end
   end
   return nil
end

-- Another robot's block that is in sight about a place, on its way there or next to it, or, in its colour by now, in
-- it or over it, or nil: two that looked in the same second meet there.
function Placement:contested_by(x, y, level)
   for _, known in ipairs(self.tracker.tracks) do
      local dx, dy = known.x - x, known.y - y
      local near = known.z > SIDE * level and TAKEN or 0
      if known.colour == self.transport then near = CONTESTED end
      if known.id == self.spared then near = 0 end
      if dx * dx + dy * dy < near * near and self.odometry.time - known.time < SEEN_NOW then return known end
   end
   return nil
end

-- Whether a place that is to be filled is free as far as the camera has seen.
function Placement:is_free(x, y, level)
   if self:held_near(x, y, CARRIED) then return false end
   for _, known in ipairs(self.tracker.tracks) do
      local dx, dy, dz = known.x - x, known.y - y, known.z - SIDE * (level + 0.5)
      if known.missed == 0 and dx * dx + dy * dy + dz * dz < TAKEN ^ 2 then return false end
   end
   return true
end

-- Whether the block comes down on its place from above, or is slid in.
local function comes_down(where, options)
   return where == 'raise' or options.over
end

-- What is to be done right before the last way to a place, or nil. On top, beside a neighbour, that may
-- snatch the block off the gripper and into its place as soon as it is near: it has its colour by then. Where no neighbour
-- is to draw it into line, magnets hold harder on the way: the charge that this takes is one that need not go when they let
-- go. Where they are not to let go, they need it longer.
function Placement:before_docking(over, options)
   if not options.colour then return nil end
   if (options.aside or 0) == 0 then return function() self.magnets:hold_fast(true) end end
   return over and function() self.gripper:colour(options.colour) end or nil
end

-- Where to bring the block, as Approach:to has it; `back`: how far it hangs ahead in the gripper; `caught`: how often it has
-- caught on a neighbour.
function Placement:target(block, where, level, back, options, caught)
   local raise, over = where == 'raise', comes_down(where, options)
   return {
      block = block, heading = options.heading,
      lowest = math.min(SIDE * level + CLEAR, self.lift.highest - UNDER_TOP),
      short = (over and -(options.before or 0) or -DRAW) - back, ahead = where == 'extend' and -SIDE or 0,
      left = (options.left or 0) + ASIDE * (options.aside or 0) * (1 + caught),
      caught = self.gripper:pushed_back(CAUGHT),
      stop = over and function() return self.approach:column_ahead() end or nil,
      -- a block that another robot is putting there hides the top
      free = function(line, top)
         return self:is_free(line.x, line.y, level) and not (options.outdated and options.outdated()) and
                (not raise or self.odometry.time - top.top_time < SEEN_NOW)
      end,
      alone = options.alone,
      contested = options.alone and function(line) return self:contested_by(line.x, line.y, level) end or nil,
      brisk = over and options.brisk, clear = options.clear, goes_before = options.goes_before,
      begin = self:before_docking(over, options),
   }
end

-- By how much, m to the left, the turn that squares a block before its place takes it aside, for which to allow. A
-- neighbour beside the place is kept clear of: the block would catch on it on its way.
function Placement:taken_aside(turn, options)
   local left, aside = turn * (self.approach.description.magnets.ahead - self.odometry.ahead), options.aside or 0
   if aside == 0 then return options.open and left or 0 end
   return aside * math.min(aside * left, NEARER)
end

-- Comes before the place once, `caught` times after the block has caught on a neighbour: as Approach:to, and the turn that
-- squares the block.
function Placement:come_before(block, where, level, options, caught)
   local back, yaw = self.gripper:seat()
   local target = self:target(block, where, level, back, options, caught)
   local square = math.abs(yaw) > TURNED and -yaw or 0
   target.left = target.left - self:taken_aside(square, options)
   local near, seen = self.approach:to(target)
   return near, seen, square
end

-- Brings the carried block before its place next to `block`. True, or false and why not. options:
-- heading, left, level (of the place; default: over the block, or on the floor), aside (1 or -1: a
-- little to the left or right, since a neighbour stands on the other side), alone(line): asked on the
-- way in, whether nobody else is at work there; outdated(): asked before the last way, whether something else is wanted
-- by now; goes_before(place), whether one who is met there is to leave; brisk, whether nothing can come before the effector;
-- clear, whether no brick stands behind the place; open, whether no neighbour stands on either side; colour, which it
-- will have; before, by how much, m, it stays before the place, over which it is not to be let go; over, whether it is let
-- down from above as when raised, and not slid in.
function Placement:approach_site(block, where, options)
   options = options or {}
   if not self.magnets:holds() then return false, 'the block was lost' end
   local level = options.level or (where == 'raise' and (block.level or 0) + 1 or 0)
   local near, seen, square
   for caught = 0, CATCHES do
      near, seen, square = self:come_before(block, where, level, options, caught)
      if near or seen ~= Approach.ENDS.caught then break end
   end
   if not near then
      if self.magnets:holds() then self.gripper:colour(self.transport) end
      return false, seen
   end
   if not self.magnets:holds() then
      -- a turn would sweep the structure
      self.magnets:hold_fast(false)
      self.path:back_off(0.15)
      return false, 'the block was lost'
   end
   if square ~= 0 then self.path:turn_by(square, 0.01) end
   self.site_level, self.site_aside = level, options.aside or 0
   self.over = comes_down(where, options)
   return true, seen
end

-- Puts the carried block down where approach_site has brought it; `drawn` as with release.
function Placement:attach(colour, drawn)
   if self.over then return self:release(self.site_level, colour, drawn) end
   if colour then self.gripper:colour(colour) end
   local short = self:slide_in(self.site_level)
   return self:release(self.site_level, nil, drawn, short)
end

-- Over the top brick of a column, or nearly, where approach_site has brought the carried block: gives that brick a colour,
-- by way of the block, or the one that is so many `blocks` below the carried one, by way of those in between, and goes back.
-- Whether it answered.
function Placement:recolour_below(colour, blocks)
   self.process:enter('recolour')
   local answered = false
   -- that brick draws the block harder than magnets hold it without a current
   self.magnets:hold_fast(true)
   for _, over in ipairs(PASSES) do
      self.lift:to(SIDE * self.site_level + over)
      self.magnets:hold_fast(true)
      answered = self.gripper:colour_below(colour, blocks)
      if answered then break end
   end
   -- one that knows nothing of passing on has taken it for another colour
   if not answered then self.gripper:colour(self.transport) end
   -- in a jolt so near that brick would keep the block
   self.lift:to(math.min(SIDE * self.site_level + 2 * CLEAR, self.lift.highest - UNDER_TOP))
   self.magnets:hold_fast(true)
   self.path:go_by(-BACK_SLOWLY, 0.05)
   self.magnets:hold_fast(false)
   self.path:go_by(BACK_SLOWLY - 0.15, 0.12)
   return answered
end

-- Both. options: those of approach_site, and colour.
function Placement:place(block, where, options)
   options = options or {}
   local near, problem = self:approach_site(block, where, options)
   if not near then return false, problem end
   return self:attach(options.colour)
end

return Placement
