-- SPDX-License-Identifier: MIT
-- Cases and what they check: a case that raises an error has failed, and the others go on.

local unit = { passed = 0, failed = 0 }

function unit.case(name, does)
   local good, problem = xpcall(does, debug.traceback)
   if good then
      unit.passed = unit.passed + 1
   else
      unit.failed = unit.failed + 1
      print(name .. ': ' .. tostring(problem))
   end
end

function unit.same(what, is, wanted)
   if is ~= wanted then
      error(string.format('%s: %s, wanted %s', what, tostring(is), tostring(wanted)), 2)
   end
end

function unit.near(what, is, wanted, within)
   if math.abs(is - wanted) > (within or 1e-9) then
      error(string.format('%s: %.9g, wanted %.9g', what, is, wanted), 2)
   end
end

return unit
