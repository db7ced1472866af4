// SPDX-License-Identifier: MIT
// More than four kinds of brick: the four LEDs about a tag, read in the tag's frame, as a word of
// four letters. Letters are the four colours; a dark LED is no letter, so that one which was missed
// is known to be missing.
//
// Words are those of Reed and Solomon (1960): the letters of kind 1 + a + 4b + 16c are a + bx + cx²
// at the four x of the field of four elements. The first 4 kinds show one colour all round, as
// published blocks do; two of the first 16 differ in three LEDs at least, two of all 62 in two.
//
//     kinds   differ in   LEDs that may be missed, or misread
//        4        4       most of them decide
//       16        3       two missed, or one misread: the word is still known
//       62        2       one missed: still known; one misread: known to be no word
#pragma once

#include <array>
#include <cstdint>
#include <optional>

namespace stig::sensing {

/// By LED, to the right of the tag first and then on against the clock: 1 to 4; 0: dark or missed.
using LedWord = std::array<std::uint8_t, 4>;

/// Words of the smallest code that has so many kinds, 1 to kMostKinds: 4, 16 or 62.
int code_size(int kinds);
/// LEDs in which any two words of that code differ, at least.
int code_distance(int kinds);
/// LEDs of a face that have to be in view for a kind to be known, so that it is known still when
/// one of them is missed; of the plain colours one, as robots of 2017 had it.
int leds_needed(int kinds);

/// The word of a kind, 1 to kMostKinds.
LedWord word_of(int kind);
/// The kind whose word this is, exactly; nothing where there is none.
std::optional<int> kind_of(const LedWord& word);

}  // namespace stig::sensing
