-- SPDX-License-Identifier: MIT
-- The lower brick of the middle column shows the colour of the end column, ten seconds after another came on it.
on_step = require('brick_shows')(1, 0, 0, 1, -0.15, true)
