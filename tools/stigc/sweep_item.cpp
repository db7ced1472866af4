// SPDX-License-Identifier: MIT
// Commands run within this process, with what they print kept: explore takes a millisecond for a
// small set, which starting a program for each would take twentyfold. Files that an item changes
// are changed in memory.
#include "sweep_item.h"

#include <fmt/format.h>

#include <map>
#include <memory>

#include "base/hash.h"
#include "base/memory_file.h"
#include "base/text.h"
#include "base/yaml_edit.h"
#include "option_values.h"
#include "report.h"
#include "rules/rule_printer.h"
#include "rules/rule_reader.h"
#include "run_line.h"
#include "shipped_files.h"

namespace stig::cli {
namespace {

/// What is done at a point: words of a command line, and the files that it changes.
struct ItemLine {
  std::string shown;               ///< as the user would write it; with the files as they were
  std::vector<std::string> words;  ///< as it is run
  std::string file, problem;
  std::map<std::string, std::string> names;  ///< files by the options that name them
  std::vector<std::unique_ptr<MemoryFile>> changed;
};

/// A word of a shell's, in quotes where it needs them.
std::string shell_word(const std::string& word) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=,./:@";
  if (!word.empty() && word.find_first_not_of(kPlain) == word.npos) return word;
  return shell_quoted(word);
}

std::string option_word(const std::string& name, const SweepValue& value) {
  if (value.json == true) return "--" + name;
  return fmt::format("--{}={}", name, value.text);
}

/// By what name the changed file is read: beside the file itself, where what it names is found.
std::string changed_name(const std::string& name, const std::string& mark) {
  return fmt::format("{}@{}", shipped_name(name), mark);
}

class LineMaker {
 public:
  LineMaker(const SweepPlan& plan, const std::vector<SweepValue>& point, const std::string& mark)
      : plan_(plan), point_(point), mark_(mark) {}

  ItemLine make() {
    names_["file"] = plan_.file;
    for (const auto& [name, value] : plan_.options) add(name, value);
    for (std::size_t i = 0; i < point_.size(); ++i) {
      if (!plan_.axes[i].is_path()) add(plan_.axes[i].name, point_[i]);
    }
    for (std::size_t i = 0; i < point_.size(); ++i) {
      if (plan_.axes[i].is_path()) change(plan_.axes[i], point_[i]);
    }
    put_together();
    return std::move(line_);
  }

 private:
  void add(const std::string& name, const SweepValue& value) {
    if (value.json == false) return;
    names_[name] = value.text;
    if (name != "file") given_.emplace_back(name, value);
  }

  void change(const SweepAxis& axis, const SweepValue& value) {
    const PlaceInFile place = place_of(axis.name);
    const auto original = plan_.texts.find(names_[place.role]);
    if (original == plan_.texts.end()) return;
    const auto [text, fresh] = texts_.emplace(place.role, original->second);
    auto changed = with_value(text->second, place.path, value.yaml, line_.problem);
    if (changed) text->second = std::move(*changed);
  }

  void put_together() {
    for (auto& [role, text] : texts_) {
      line_.changed.push_back(
          std::make_unique<MemoryFile>(changed_name(names_[role], mark_), std::move(text)));
      read_as_[role] = line_.changed.back()->path();
    }
    const auto read_name = [&](const std::string& role) {
      return read_as_.count(role) > 0 ? read_as_[role] : names_[role];
    };
    line_.file = read_name("file");
    line_.names = names_;
    line_.shown = fmt::format("stigc {} {}", plan_.command, shell_word(names_["file"]));
    line_.words = {plan_.command, line_.file};
    for (const auto& [name, value] : given_) {
      const std::string word = option_word(name, value);
      line_.shown += " " + shell_word(word);
      line_.words.push_back(read_as_.count(name) > 0 ? fmt::format("--{}={}", name, read_as_[name])
                                                     : word);
    }
    // What makes it print JSON, and not share its work: items are done side by side.
    line_.words.push_back(plan_.command == "compile" ? "--target=ir" : "--json");
    if (plan_.command == "explore" || plan_.command == "validate") {
      line_.words.push_back("--threads=1");
    }
    for (const char* word : {"--quiet", "--color=never"}) line_.words.push_back(word);
  }

  const SweepPlan& plan_;
  const std::vector<SweepValue>& point_;
  std::string mark_;
  ItemLine line_;
  std::vector<std::pair<std::string, SweepValue>> given_;
  std::map<std::string, std::string> names_, texts_, read_as_;
};

/// The hash of a rule set's rules; null where they are none.
Json rules_hash(const std::string& command, const std::string& path) {
  if (command == "synth") return nullptr;
  Diagnostics ignored;
  const auto rules = read_rule_set_file(path, ignored);
  if (!rules || ignored.has_errors()) return nullptr;
  return to_hex(rule_set_hash(*rules));
}

/// What a command printed. How long it took is no result of the item.
Json printed(const std::string& text) {
  Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) return nullptr;
  json.erase("seconds");
  return json;
}

}  // namespace

std::string problem_at(const SweepPlan& plan, const std::vector<SweepValue>& point) {
  const ItemLine line = LineMaker(plan, point, "try").make();
  if (!line.problem.empty()) return line.problem;
  return parse_words(line.words).problem;
}

std::string item_record(const SweepPlan& plan, std::uint64_t item) {
  const std::vector<SweepValue> point = point_of(plan, item);
  const ItemLine line = LineMaker(plan, point, fmt::to_string(item)).make();
  Json set = Json::object();
  for (std::size_t i = 0; i < point.size(); ++i) set[plan.axes[i].name] = point[i].json;
  Json record{{"stigc", STIG_VERSION}, {"plan", to_hex(plan.hash)}, {"item", item},
              {"items", plan.items},   {"command", line.shown},     {"set", std::move(set)}};
  Parsed parsed = parse_words(line.words);
  Json options = parsed.line ? option_values(parsed.line->command) : Json(nullptr);
  // By the names that the plan has for them, wherever they are on this machine.
  for (const char* role : {"robot", "block", "scene"}) {
    if (line.names.count(role) > 0) options[role] = line.names.at(role);
  }
  Captured captured;
  const int code = run_captured(parsed, captured);
  // Half an item is none.
  if (stop_requested()) return {};
  record["ruleset_hash"] = rules_hash(plan.command, shipped_name(line.file));
  record["seed"] = options.is_object() ? options.value("seed", Json(nullptr)) : Json(nullptr);
  record["options"] = options;
  record["exit"] = code;
  record["codes"] = captured.codes;
  if (!captured.err.empty() && code != kOk) record["message"] = captured.err;
  record["result"] = printed(captured.out);
  return record.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace stig::cli
