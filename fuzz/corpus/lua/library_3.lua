
    weak = setmetatable({}, {__mode = 'k'})
    n = 0
    function step()
      for i = 1, 300 do weak[{}] = 1 local s = 'x' .. i .. n end
      n = n + 1
      local count = 0
      weak.mark = nil
      for i = 1, 10 do _G['name' .. (n * i) % 37] = n % 3 > 0 and n or nil end
      print(collectgarbage('count'))
    end