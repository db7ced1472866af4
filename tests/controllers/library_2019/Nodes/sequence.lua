-- SPDX-License-Identifier: MIT
-- A node whose children run one after the other; a child that returns nothing is done at once.
return function(children)
   local at = 1
   return function()
      while children[at] do
         local running, success = children[at]()
         if running then return true end
         if success == false then return false, false end
         at = at + 1
      end
      return false, true
   end
end
