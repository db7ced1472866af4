// SPDX-License-Identifier: MIT
// An example for every diagnostic code: what provokes it, and the same thing mended.
//
// The examples stand beside diagnostics.def rather than in it, because every source includes that
// list and none but this needs these; a code without an example, or one out of order, does not
// compile. Most are parts of a file and say what matters alone. The rest of the file is that of
// example_file(), so that a test can hold each example to its word.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "base/diagnostic.h"

namespace stig {

/// What the text of an example is.
enum class ExampleForm : std::uint8_t {
  rules,     ///< keys of a rule set
  scene,     ///< keys of a scene
  robot,     ///< keys of a robot
  compiled,  ///< keys of a rule set that is compiled for a robot
  commands,  ///< command lines
  words,     ///< what no text can show
};

struct CodeExample {
  Code code;
  ExampleForm form;
  std::string_view wrong;  ///< provokes the code
  std::string_view right;  ///< does not; empty: there is nothing to be mended
};
const CodeExample& example_of(Code code);

/// A whole file with these keys, the others as in a small good file of this form.
std::string example_file(ExampleForm form, std::string_view keys);

/// A code by its name (R304 or r304) or its slug (fires-everywhere); null: there is none.
const CodeInfo* find_code(std::string_view name);
/// What `stigc --explain` prints: name and slug, what it means and what to do, the example.
std::string explanation_text(const CodeInfo& code);
/// The example alone, every line after `indent`.
std::string example_text(const CodeInfo& code, std::string_view indent);
/// A line for every code.
std::string list_of_codes();

}  // namespace stig
