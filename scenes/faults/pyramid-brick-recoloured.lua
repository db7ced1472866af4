-- SPDX-License-Identifier: MIT
-- The upper brick of one wing's middle column shows the colour of those at the wings' ends.
on_step = require('brick_shows')(1, 0, 1, 1)
