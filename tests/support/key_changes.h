// SPDX-License-Identifier: MIT
// Every declared key of a data file is read: for each value of a file that has them all, the file
// with another value in its place.
//
//     for (const KeyChange& change : key_changes(text, robot_form(), {"other.lua"})) {
//       …     // read change.text, and compare
//     }
//
// Which other values are possible is not known here: some of the changes contradict the rest of
// the file, so that its reader refuses them. What can be asked is that every key has a change that
// is taken, and that whoever takes a change notices it.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/form.h"
#include "support/uses.h"

namespace stig {

struct KeyChange {
  std::string key;   ///< "cameras/far", of a list's entries "cameras/look[2]"
  std::string text;  ///< the whole file
};

/// `words`: names that may stand in the place of others; every `name` of the file is tried as well.
std::vector<KeyChange> key_changes(const std::string& text, const Form& form,
                                   const std::vector<std::string>& words);

/// The keys of the form and of those within it that have values of their own, "cameras/far"; not
/// the format's version, which has one value alone.
std::set<std::string> declared_keys(const Form& form);

/// What was read of a text, printed; nothing when it was refused.
using ShownText = std::function<std::optional<std::string>(const std::string& text)>;

/// What is wrong, a line each: declared keys that none of the files has, values in whose place
/// nothing could be put, and changes that were read without a trace.
std::vector<std::string> unread_keys(const std::vector<std::string>& texts, const Form& form,
                                     const std::vector<std::string>& words, const ShownText& read);

/// Words that stand nowhere in the code of a page, which is what is between backticks or indented
/// by four.
std::vector<std::string> words_missing_on(const std::string& page,
                                          const std::vector<std::string>& words);
/// Declared keys of which that is so.
std::vector<std::string> keys_missing_on(const std::string& page, const Form& form);

}  // namespace stig
