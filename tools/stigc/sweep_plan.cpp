// SPDX-License-Identifier: MIT
// A plan is read in three steps: its keys by a table, its options and parameters, and then, with
// one item for each value, whether the command would take them: so that a slip is found before the
// work begins.
#include "sweep_plan.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/file_io.h"
#include "base/form.h"
#include "base/hash.h"
#include "base/load.h"
#include "command_line.h"
#include "shipped_files.h"
#include "sweep_item.h"

namespace stig::cli {
namespace {

constexpr int kSweepFormat = 1;
constexpr double kMostSample = 1e7;
constexpr std::size_t kMostRead = std::size_t{1} << 28;  ///< bytes of a file that items read
constexpr std::size_t kMostTried = 1000;                 ///< values of an axis tried beforehand

/// Options that say what is written or how the work is shared: the study's own business.
constexpr std::string_view kNotForItems[] = {
    "--runs",   "--threads",     "--json",         "--output", "--palette",
    "--trace",  "--certificate", "--witness",      "--proof",  "--target",
    "--report", "--why",         "--trace-detail", "--help"};
constexpr std::string_view kFileOptions[] = {"robot", "block", "scene"};

// Keys that are not named keep their defaults.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
const Form& sweep_form() {
  using enum FormKind;
  static const Form kForm{
      "study",
      {{.name = "stigc_sweep",
        .kind = version,
        .required = true,
        .doc = "Version of the file format: 1.",
        .high = kSweepFormat},
       {.name = "name", .kind = FormKind::name, .doc = "Short name, for reports."},
       {.name = "title", .kind = text, .doc = "What is asked, in one line."},
       {.name = "command",
        .kind = choice,
        .required = true,
        .doc = "What is done at each point.",
        .words = {"explore", "verify", "synth", "compile", "validate"}},
       {.name = "file",
        .kind = FormKind::name,
        .doc = "The rule set; of synth the structure. Left out where it varies."},
       {.name = "options",
        .kind = anything,
        .doc = "Options that all items have, without their dashes."},
       {.name = "vary",
        .kind = anything,
        .required = true,
        .doc = "Options, or paths in files such as rules.grow.probability, and their values: a "
               "list, 1..20 or 0.1..0.9/5."},
       {.name = "sample",
        .kind = integer,
        .doc = "So many points at random, in place of the whole grid.",
        .low = 1,
        .high = kMostSample},
       {.name = "seed", .kind = integer, .doc = "Of the sample.", .low = 0, .high = 1e15}},
      "stigc_sweep: 1\ncommand: explore\nfile: wall.yaml\nvary: {seed: 1..10}\n"};
  return kForm;
}
#pragma GCC diagnostic pop

/// Fills a plan from a document whose keys are sound.
class SweepReader {
 public:
  SweepReader(const YamlDocument& document, SweepPlan& plan, Diagnostics& diagnostics)
      : document_(document), plan_(plan), out_(diagnostics) {}

  void read() {
    const YamlNode& root = document_.root;
    const auto text = [&](const char* key) {
      const YamlNode* node = root.find(key);
      return node == nullptr ? std::string() : node->text;
    };
    plan_.name = text("name");
    plan_.command = text("command");
    plan_.file = text("file");
    if (const YamlNode* sample = root.find("sample")) {
      plan_.sample = static_cast<std::uint64_t>(*number_of(*sample));
    }
    if (const YamlNode* seed = root.find("seed")) {
      plan_.seed = static_cast<std::uint64_t>(*number_of(*seed));
    }
    each_pair("options", [&](const YamlPair& pair) { read_option(pair); });
    each_pair("vary", [&](const YamlPair& pair) { read_vary(pair); });
    if (out_.has_errors()) return;
    count_items();
    check_file();
    if (!out_.has_errors()) load_texts();
    if (!out_.has_errors()) try_values();
    if (!out_.has_errors()) plan_.hash = hash_of_plan();
  }

 private:
  void bad(const YamlNode& node, std::string message) {
    out_.add(Code::R106, document_.head(node), std::move(message));
  }

  template <class Each>
  void each_pair(const char* key, Each each) {
    const YamlNode* node = document_.root.find(key);
    if (node == nullptr) return;
    if (node->kind != YamlKind::mapping) {
      bad(*node, fmt::format("'{}' takes a mapping", key));
      return;
    }
    for (const YamlPair& pair : node->pairs) each(pair);
  }

  /// The option as the command has it; false where it has none, or not for items.
  bool known(const YamlPair& pair) {
    if (pair.key.text == "file") return true;
    static const CommandTree tree = command_tree();
    const auto command =
        std::find_if(tree.commands.begin(), tree.commands.end(),
                     [&](const CommandInfo& one) { return one.name == plan_.command; });
    const std::string name = "--" + pair.key.text;
    std::vector<std::string_view> names;
    for (const OptionInfo& option : command->options) {
      for (const std::string& one : option.names) {
        const auto* ends = std::end(kNotForItems);
        if (!one.starts_with("--") || std::find(std::begin(kNotForItems), ends, one) != ends) {
          continue;
        }
        if (one == name) return true;
        names.push_back(std::string_view(one).substr(2));
      }
    }
    const std::string_view near = nearest(pair.key.text, names);
    bad(pair.key,
        fmt::format("'{}' is no option of {} that items can have{}", pair.key.text, plan_.command,
                    near.empty() ? "" : fmt::format("; did you mean '{}'?", near)));
    return false;
  }

  void read_option(const YamlPair& pair) {
    if (!known(pair)) return;
    if (auto value = read_value(document_, pair.value)) {
      plan_.options.emplace_back(pair.key.text, std::move(*value));
    } else {
      bad(pair.value, fmt::format("'{}' takes one value here", pair.key.text));
    }
  }

  void read_vary(const YamlPair& pair) {
    std::string problem;
    auto axis = read_axis(document_, pair, problem);
    if (!axis) return bad(pair.value, problem);
    if (!axis->is_path() && !known(pair)) return;
    if (axis->values.empty() && !plan_.sample) {
      return bad(pair.value, fmt::format("'{}' has no number of values, as 0.1..0.9/5 has, and "
                                         "there is no 'sample'",
                                         axis->name));
    }
    keys_.push_back(&pair.key);
    plan_.axes.push_back(std::move(*axis));
  }

  void count_items() {
    plan_.items = plan_.sample.value_or(1);
    if (plan_.axes.empty()) bad(*document_.root.find("vary"), "nothing varies");
    for (const SweepAxis& axis : plan_.axes) {
      if (!plan_.sample) plan_.items *= axis.values.size();
      if (plan_.items > kMostItems) {
        return bad(*document_.root.find("vary"),
                   fmt::format("more than {} items: take a sample", kMostItems));
      }
    }
  }

  bool varies(std::string_view name) const {
    return std::any_of(plan_.axes.begin(), plan_.axes.end(),
                       [&](const SweepAxis& axis) { return axis.name == name; });
  }
  bool is_given(std::string_view name) const {
    return varies(name) || std::any_of(plan_.options.begin(), plan_.options.end(),
                                       [&](const auto& option) { return option.first == name; });
  }

  void check_file() {
    if (plan_.file.empty() == !varies("file")) {
      bad(document_.root, "a study has a 'file', or varies it");
    }
    for (std::size_t i = 0; i < plan_.axes.size(); ++i) {
      const SweepAxis& axis = plan_.axes[i];
      if (!axis.is_path()) continue;
      const std::string role = place_of(axis.name).role;
      if (role == "file" ? plan_.command == "synth" : !is_given(role)) {
        bad(*keys_[i], fmt::format("'{}' is in a file that the study does not name", axis.name));
      }
    }
  }

  void load_text(const YamlNode& at, const std::string& name) {
    if (plan_.texts.count(name) > 0) return;
    FileError error;
    auto text = read_file(shipped_name(name), kMostRead, error);
    if (!text) return bad(at, printable(error.message));
    plan_.texts.emplace(name, std::move(*text));
  }

  /// Every file that an item may read by name.
  void load_texts() {
    if (!plan_.file.empty()) load_text(*document_.root.find("file"), plan_.file);
    const auto names_file = [](std::string_view name) {
      const auto* ends = std::end(kFileOptions);
      return name == "file" || std::find(std::begin(kFileOptions), ends, name) != ends;
    };
    for (const auto& [name, value] : plan_.options) {
      if (names_file(name)) load_text(*document_.root.find("options"), value.text);
    }
    for (std::size_t i = 0; i < plan_.axes.size(); ++i) {
      if (!names_file(plan_.axes[i].name)) continue;
      for (const SweepValue& value : plan_.axes[i].values) load_text(*keys_[i], value.text);
    }
  }

  /// Would the command take each value?
  void try_values() {
    std::vector<SweepValue> first = point_of(plan_, 0);
    for (std::size_t i = 0; i < plan_.axes.size(); ++i) {
      std::vector<SweepValue> point = first;
      const auto& values = plan_.axes[i].values;
      for (std::size_t k = 0; k < std::min(values.size(), kMostTried); ++k) {
        point[i] = values[k];
        const std::string problem = problem_at(plan_, point);
        if (problem.empty()) continue;
        bad(*keys_[i], printable(problem));
        return;
      }
    }
    if (const std::string problem = problem_at(plan_, first); !problem.empty()) {
      bad(document_.root, printable(problem));
    }
  }

  std::uint64_t hash_of_plan() const {
    std::uint64_t sum = hash_text("stigc sweep 1");
    const auto add = [&sum](std::string_view text) { sum = combine(sum, hash_text(text)); };
    add(plan_.command);
    add(plan_.file);
    for (const auto& [name, value] : plan_.options) {
      add(name);
      add(value.yaml);
    }
    for (const SweepAxis& axis : plan_.axes) {
      add(axis.name);
      add(fmt::format("{} {}", axis.low, axis.high));
      for (const SweepValue& value : axis.values) add(value.yaml);
    }
    add(plan_.sample ? fmt::format("{} {}", *plan_.sample, plan_.seed) : "grid");
    for (const auto& [name, text] : plan_.texts) {
      add(name);
      add(text);
    }
    return sum;
  }

  const YamlDocument& document_;
  SweepPlan& plan_;
  Diagnostics& out_;
  std::vector<const YamlNode*> keys_;  ///< of the axes
};

}  // namespace

std::optional<SweepPlan> read_sweep(const std::string& path, const App& app) {
  Diagnostics diagnostics;
  SweepPlan plan;
  plan.path = path;
  bool sound = false;
  if (SourceRef source = load_source(path, YamlLimits().bytes, diagnostics)) {
    if (const auto document = parse_yaml(std::move(source), {}, diagnostics)) {
      check_form(*document, sweep_form(), diagnostics);
      if (!diagnostics.has_errors()) SweepReader(*document, plan, diagnostics).read();
      sound = !diagnostics.has_errors();
    }
  }
  app.report(diagnostics);
  if (!sound || app.invalid(diagnostics)) return std::nullopt;
  return plan;
}

std::string sweep_schema() {
  return form_schema(sweep_form(), "stigc study",
                     "One command at every point of a grid of parameters, or at a sample.");
}

std::vector<SweepValue> point_of(const SweepPlan& plan, std::uint64_t item) {
  std::vector<SweepValue> point(plan.axes.size());
  for (std::size_t i = plan.axes.size(); i-- > 0;) {
    const SweepAxis& axis = plan.axes[i];
    if (plan.sample) {
      Random random(plan.seed, 0, Purpose::user, static_cast<std::uint32_t>(i), item);
      point[i] = draw_value(axis, random);
    } else {
      point[i] = axis.values[item % axis.values.size()];
      item /= axis.values.size();
    }
  }
  return point;
}

PlaceInFile place_of(std::string_view axis) {
  const std::string_view first = axis.substr(0, axis.find('.'));
  const auto* ends = std::end(kFileOptions);
  if (std::find(std::begin(kFileOptions), ends, first) == ends) return {"file", std::string(axis)};
  return {std::string(first), std::string(axis.substr(first.size() + 1))};
}

}  // namespace stig::cli
