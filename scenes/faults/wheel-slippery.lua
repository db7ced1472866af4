-- SPDX-License-Identifier: MIT
-- The front right wheel has half its friction.

function on_start(world) world.set_friction('robot 1/front right wheel', 0.5) end
