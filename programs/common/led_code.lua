-- SPDX-License-Identifier: MIT
-- What blocks show: four colours all round, or code words of the four LEDs about a tag, read in the
-- tag's frame. Words are those of Reed and Solomon (1960): the letters of kind 1 + a + 4b + 16c are
-- a + bx + cx² at the four x of the field of four elements, each one more. Of 16 kinds two differ in
-- three letters at least, of all 62 in two.

local PLAIN, SINGLE, ALL = 4, 16, 62
-- of that field; sums are exclusive ors, for which not every Lua has an operator
local PLUS = { [0] = { [0] = 0, 1, 2, 3 }, { [0] = 1, 0, 3, 2 }, { [0] = 2, 3, 0, 1 }, { [0] = 3, 2, 1, 0 } }
local TIMES = { [0] = { [0] = 0, 0, 0, 0 }, { [0] = 0, 1, 2, 3 }, { [0] = 0, 2, 3, 1 }, { [0] = 0, 3, 1, 2 } }

local led_code = { PLAIN = PLAIN }

-- Four letters, 1 to 4.
function led_code.word_of(kind)
   local number, word = kind - 1, {}
   local a, b, c = number % 4, math.floor(number / 4) % 4, math.floor(number / 16)
   for x = 0, 3 do
      word[x + 1] = 1 + PLUS[PLUS[a][TIMES[b][x]]][TIMES[c][TIMES[x][x]]]
   end
   return word
end

local WORDS = {}
for kind = 1, ALL do WORDS[kind] = led_code.word_of(kind) end

-- The colour that most of four LEDs show, 0 where no two are alike.
local function plain_kind(word)
   local votes = {}
   for _, letter in ipairs(word) do votes[letter] = (votes[letter] or 0) + 1 end
   local best, most = 0, 1
   for colour = 1, PLAIN do
      if (votes[colour] or 0) > most then best, most = colour, votes[colour] end
   end
   return best
end

-- What four LEDs show where there are so many kinds; a letter is 0 where nothing shone. 0 for a
-- block that is dark, nil where the letters may be of several kinds. As many letters may be missing,
-- a wrong one counted twice, as leave one word alone.
function led_code.kind_of(word, kinds)
   if kinds <= PLAIN then return plain_kind(word) end
   local missed = 0
   for _, letter in ipairs(word) do
      if letter == 0 then missed = missed + 1 end
   end
   if missed == #word then return 0 end
   local bears = kinds <= SINGLE and 2 or 1
   for kind = 1, kinds do
      local wrong = 0
      for i, letter in ipairs(word) do
         if letter ~= 0 and letter ~= WORDS[kind][i] then wrong = wrong + 1 end
      end
      if missed + 2 * wrong <= bears then return kind end
   end
   return nil
end

return led_code
