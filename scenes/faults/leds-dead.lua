-- SPDX-License-Identifier: MIT
-- All LEDs of the second block are dead.

local second_block = require 'second_block'

on_step = second_block(function(world, name) world.set_leds(name, false) end)
