-- SPDX-License-Identifier: MIT
-- The first brick beside the tower goes dark: what comes upon it is not known to be due.
on_step = require('brick_shows')(1, 0, 0, 0, -0.15)
