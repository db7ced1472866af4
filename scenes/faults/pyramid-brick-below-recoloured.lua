-- SPDX-License-Identifier: MIT
-- The lower brick of one wing's middle column shows the colour of those at the wings' ends as soon as one stands on it.
on_step = require('brick_shows')(1, 0, 0, 1, 0, true)
