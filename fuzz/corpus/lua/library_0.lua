
    local t = {1, 2, 3}
    table.insert(t, 4) table.insert(t, 1, 0)
    assert(table.concat(t, ',') == '0,1,2,3,4')
    assert(table.remove(t) == 4 and table.remove(t, 1) == 0 and table.concat(t) == '123')
    assert(table.remove({}) == nil and table.remove({}, 0) == nil and table.remove({5}, 2) == nil)
    assert(not pcall(table.insert, t, 9, 1) and not pcall(table.insert, t) and not pcall(table.remove, t, 9))
    assert(table.concat({1, 2.5, 'x'}, '-', 2) == '2.5-x' and table.concat({}, 'x') == '')
    assert(not pcall(table.concat, {{}}))
    local p = table.pack(1, nil, 3) assert(p.n == 3 and p[3] == 3)
    assert(select('#', table.unpack({1, nil, 3}, 1, 3)) == 3 and table.unpack({4, 5}, 2) == 5)
    assert(not pcall(table.unpack, {}, 1, 1e8) and not pcall(table.unpack, {}, math.mininteger, math.maxinteger))
    local m = table.move({1, 2, 3}, 2, 3, 1) assert(m[1] == 2 and m[2] == 3 and m[3] == 3)
    m = table.move({1, 2, 3}, 1, 3, 2) assert(m[2] == 1 and m[4] == 3)
    m = table.move({1, 2}, 1, 2, 1, {}) assert(m[2] == 2)
    local s = {} for i = 1, 500 do s[i] = (i * 7919) % 503 end
    table.sort(s) for i = 2, 500 do assert(s[i - 1] <= s[i]) end
    table.sort(s, function(a, b) return a > b end) assert(s[1] > s[500])
    table.sort(s, function() return true end)   -- nonsense, but it ends
    assert(not pcall(table.sort, {1, 'x'}))
    local r = {{1, 'a'}, {0, 'b'}, {1, 'c'}, {0, 'd'}}
    table.sort(r, function(x, y) return x[1] < y[1] end)   -- stable
    assert(r[1][2] .. r[2][2] .. r[3][2] .. r[4][2] == 'bdac')
  