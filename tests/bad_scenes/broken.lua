-- The second line is no Lua.
local speed = = 3
