-- SPDX-License-Identifier: MIT
-- Runs unit tests of the library in programs/, each a file of cases, and says how many passed.
--
--     lua5.4 run_units.lua SOURCE_DIR FILE...

local root = arg[1]
package.path = root .. '/programs/?.lua;' .. root .. '/tests/lua/?.lua'

local unit = require 'unit'
for i = 2, #arg do dofile(arg[i]) end
print(string.format('%d passed, %d failed', unit.passed, unit.failed))
os.exit(unit.failed == 0 and unit.passed > 0)
