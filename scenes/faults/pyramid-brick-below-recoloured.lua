-- SPDX-License-Identifier: MIT
-- The lower brick of one wing's middle column shows the colour of those at the wings' ends, ten seconds after
-- another came on it.
on_step = require('brick_shows')(1, 0, 0, 1, 0, true)
