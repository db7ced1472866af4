-- SPDX-License-Identifier: MIT
-- luacheck: globals Say api package debug
-- Messages that are switched on and off by the file that they come from.
local Say = { named = {}, on = {} }
setmetatable(Say, {
   __call = function(_, ...)
      local file = debug.getinfo(2).short_src
      if Say.on[Say.named[file] or 'main'] then print(Say.named[file] or 'main', ...) end
   end,
})

function Say.name(name)
   Say.named[debug.getinfo(2).short_src] = name
end

return Say
