
      local out = {}
      local function note(...) for k = 1, select('#', ...) do out[#out + 1] = tostring((select(k, ...))) end out[#out + 1] = '|' end
      note(pcall(string.find, s, p, i)) note(pcall(string.match, s, p, i))
      note(pcall(string.gsub, s, p, '<%0>')) note(pcall(string.gsub, s, p, '<%1>', 2))
      note(pcall(string.gsub, s, p, {a = 'x', b = false})) note(pcall(string.find, s, p, i, true))
      note(pcall(function() for x, y in s:gmatch(p) do note(x, y) end end))
      for k, v in ipairs(out) do if k > 1 and out[k - 1] == 'false' then out[k] = 'failed' end end
      return table.concat(out, ' ')