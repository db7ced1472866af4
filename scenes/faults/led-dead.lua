-- SPDX-License-Identifier: MIT
-- The LED to the right of each tag of the second block is dead.

local second_block = require 'second_block'

on_step = second_block(function(world, name) world.set_leds(name, false, 1) end)
