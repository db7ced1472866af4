// SPDX-License-Identifier: MIT
// The playground's module: questions and answers as JSON, one function for each thing that the page
// does with a rule set. The page's own code (tools/viewer/src/playground) asks, and shows what
// comes back; what is said is said by the same code as in the program.
//
// A question is an object whose `do` names the function:
//
//   schema    {}                                the JSON Schema of rule sets
//   check     {text}                            what is wrong with a rule set
//   explore   {text, motion, agents, seed, …}   a run, as the viewer shows it, and its files; the
//                                             options of the program by their names
//   structure {target, ending}                a structure as another kind of file, in base64;
//                                             an .svg with the title of `text`, in `palette`
//   explain   {text, at, bricks}                rule by rule, why it fires at a site or why not
//   verify    {text, effort}                    the verdict, and the runs that show it
//   compile   {text, robot, block}              what a robot does where, or why it cannot
//   synth     {target, name, effort}            rules that build a structure
//
// Every answer to a `text` has `diagnostics`; where these are errors, it has nothing else.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "uses.h"

namespace stig::playground {

using namespace cli;
using Json = nlohmann::ordered_json;

/// The answer to a question, as text. What is no question is answered by an `error`.
std::string answer(std::string_view question);

Json schema_answer(const Json& question);
Json check_answer(const Json& question);
Json explore_answer(const Json& question);
Json structure_answer(const Json& question);
Json explain_answer(const Json& question);
Json verify_answer(const Json& question);
Json compile_answer(const Json& question);
Json synth_answer(const Json& question);

}  // namespace stig::playground
