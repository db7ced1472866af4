// SPDX-License-Identifier: MIT
// The form below is the only place that lists a plan's keys: it checks files and makes the schema.
// What keys ask of each other comes after it.
#include "search/plan_reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/form.h"
#include "base/load.h"
#include "base/node_checks.h"
#include "base/yaml.h"
#include "lattice/rgb.h"
#include "lattice/structure_text.h"
#include "search/objectives.h"

namespace stig::search {
namespace {

constexpr std::size_t kMostPlanBytes = std::size_t{1} << 16;
/// Candidates are compared with a target in as many places as it has cells.
constexpr std::size_t kMostTargetCells = 200;
constexpr std::string_view kLattices[] = {"cubic", "hexagonal"};
constexpr std::string_view kSymmetries[] = {"none", "rotations", "rotations+mirrors", "any"};
constexpr SearchMethod kMethods[] = {SearchMethod::random, SearchMethod::local,
                                     SearchMethod::genetic, SearchMethod::map_elites};

FormKey key(std::string_view name, FormKind kind, std::string_view doc) {
  FormKey out;
  out.name = name;
  out.kind = kind;
  out.doc = doc;
  return out;
}

FormKey number(std::string_view name, std::string_view doc, double low, double high,
               FormKind kind = FormKind::number) {
  FormKey out = key(name, kind, doc);
  out.low = low;
  out.high = high;
  return out;
}

FormKey whole(std::string_view name, std::string_view doc, double low, double high) {
  return number(name, doc, low, high, FormKind::integer);
}

FormKey choice(std::string_view name, std::string_view doc, std::vector<std::string_view> words) {
  FormKey out = key(name, FormKind::choice, doc);
  out.words = std::move(words);
  return out;
}

FormKey parts(std::string_view name, std::string_view doc, const Form& form, std::size_t least,
              std::size_t most) {
  FormKey out = key(name, FormKind::forms, doc);
  out.form = &form;
  out.least = least;
  out.most = most;
  return out;
}

FormKey needed(FormKey out) {
  out.required = true;
  return out;
}

std::vector<std::string_view> objective_names() {
  std::vector<std::string_view> names;
  for (const Objective& objective : objectives()) names.push_back(objective.name);
  return names;
}

std::vector<std::string_view> method_names() {
  std::vector<std::string_view> names;
  for (const SearchMethod method : kMethods) names.push_back(to_string(method));
  return names;
}

const Form& score_form() {
  static const Form kForm{"part of a score",
                          {needed(choice("objective", "What is measured.", objective_names())),
                           number("weight", "Factor; 1 without it.", -1e6, 1e6)}};
  return kForm;
}

constexpr std::size_t kMostTerms = 20;

/// A list of parts, or the name of a program.
bool check_score(NodeChecks& checks, const YamlNode& node, const FormKey& key) {
  if (node.kind == YamlKind::scalar) {
    if (!checks.check_name(node)) return false;
    return node.text.ends_with(".lua") ||
           checks.wrong(node, "a list of objectives, or a file of Lua whose name ends in .lua");
  }
  if (!checks.expect(node, YamlKind::sequence, "a list of objectives, or a file of Lua")) {
    return false;
  }
  bool sound = checks.check_size(node, key.name, node.items.size(), 1, kMostTerms);
  if (node.items.size() > kMostTerms) return sound;
  for (const YamlNode& item : node.items) sound = checks.check_part(item, score_form()) && sound;
  return sound || checks.mark(node);
}

std::string score_schema() {
  std::string names;
  for (const Objective& objective : objectives()) {
    names += fmt::format("{}\"{}\"", names.empty() ? "" : ",", objective.name);
  }
  return fmt::format(
      R"({{"oneOf":[{{"type":"string","pattern":"[.]lua$"}},{{"type":"array","minItems":1,)"
      R"("maxItems":{},"items":{{"type":"object","additionalProperties":false,)"
      R"("required":["objective"],"properties":{{"objective":{{"enum":[{}]}},)"
      R"("weight":{{"type":"number","minimum":-1e6,"maximum":1e6}}}}}}}}]}})",
      kMostTerms, names);
}

FormKey score_key(std::string_view doc) {
  static const std::string kSchema = score_schema();
  static const ValueKind kScore{check_score, kSchema};
  FormKey out = key("score", FormKind::own, doc);
  out.own = &kScore;
  return out;
}

const Form& axis_form() {
  static const Form kForm{
      "axis",
      {needed(choice("objective", "What is measured.", objective_names())),
       needed(number("from", "Low end.", -1e9, 1e9)), needed(number("to", "High end.", -1e9, 1e9)),
       whole("bins", "Cells along it; 10 without it.", 1, 1000)}};
  return kForm;
}

const Form& plan_form() {
  static const Form kForm{
      "search plan",
      {needed(number("stigc_search", "Version of the format: 1.", 0, 1, FormKind::version)),
       needed(key("name", FormKind::name, "A short name.")),
       needed(choice("method", "How candidates are chosen.", method_names())),
       needed(score_key("What is better: the sum of these, or what a program in Lua says.")),
       parts("axes", "The grid of map-elites: two or three.", axis_form(), 2, 3),
       whole("evaluations", "Candidates in all, rounded up to whole batches; 10000 without it.", 1,
             1e12),
       whole("batch", "Candidates made at once; 256 without it.", 1, 100'000),
       whole("population", "Structures that the genetic algorithm breeds; 64 without it.", 2,
             100'000),
       whole("seed", "Of all random choices; 1 without it.", 0, 1e15),
       choice("lattice", "cubic without it.", {kLattices[0], kLattices[1]}),
       key("floor", FormKind::boolean, "Is there a floor below z = 0? Without it not."),
       whole("colours", "Of bricks; 2 without it.", 1, kMostGenomeColours),
       whole("rules", "Of a candidate; 20 without it.", 1, static_cast<double>(kMostGenomeRules)),
       number("wildcards", "Chance that a neighbour does not matter; 0.1 without it.", 0, 1),
       number("heights", "Chance of a bound on a rule's height; 0 without it.", 0, 1),
       choice("symmetry", "Of candidates; any: a gene, which it is without this key.",
              {std::begin(kSymmetries), std::end(kSymmetries)}),
       whole("box", "Cells along each side; 20 without it.", 1, 64),
       whole("deposits", "Bricks after which a run ends; 500 without it.", 1, 250'000),
       whole("orders", "Further random orders of each candidate, for same_ends; 0 without it.", 0,
             1000),
       whole("faults", "Times that a brick is lost, and one too many; 0 without it.", 0, 1000),
       whole("proof", "Steps of the verifier for a candidate; 0 without it: no proofs.", 0, 1e12),
       key("robot", FormKind::name, "The file of a robot that is to build finds; needs a proof."),
       key("target", FormKind::text, "A drawing of the shape that distance is measured to.")}};
  return kForm;
}

template <class Words>
std::size_t index_of(const Words& words, const std::string& word) {
  std::size_t i = 0;
  while (words[i] != word) ++i;
  return i;
}

std::uint64_t count(const FormView& root, std::string_view name, std::uint64_t otherwise) {
  return static_cast<std::uint64_t>(root.number(name, static_cast<double>(otherwise)));
}

int small(const FormView& root, std::string_view name, int otherwise) {
  return static_cast<int>(root.number(name, otherwise));
}

DrawSettings read_draw(const FormView& root) {
  DrawSettings draw;
  draw.lattice = static_cast<Lattice>(index_of(kLattices, root.text("lattice", "cubic")));
  draw.floor = root.flag("floor");
  draw.colours = small(root, "colours", draw.colours);
  draw.rules = small(root, "rules", draw.rules);
  draw.wildcards = root.number("wildcards", draw.wildcards);
  draw.heights = root.number("heights", draw.heights);
  const std::size_t symmetry = index_of(kSymmetries, root.text("symmetry", "any"));
  if (symmetry < 3) draw.symmetry = static_cast<Symmetry>(symmetry);
  return draw;
}

SearchPlan read_plan(const FormView& root) {
  SearchPlan plan;
  plan.name = root.text("name");
  plan.method = kMethods[index_of(method_names(), root.text("method"))];
  plan.draw = read_draw(root);
  plan.screen.side = small(root, "box", plan.screen.side);
  plan.screen.most_deposits = count(root, "deposits", plan.screen.most_deposits);
  plan.orders = small(root, "orders", plan.orders);
  plan.faults = small(root, "faults", plan.faults);
  plan.proof = count(root, "proof", plan.proof);
  plan.seed = count(root, "seed", plan.seed);
  plan.evaluations = count(root, "evaluations", plan.evaluations);
  plan.batch = small(root, "batch", plan.batch);
  plan.population = small(root, "population", plan.population);
  plan.robot = root.text("robot");
  plan.score_program = root.text("score");
  for (const FormView& term : root.forms("score")) {
    plan.score.push_back({*objective_number(term.text("objective")), term.number("weight", 1)});
  }
  for (const FormView& axis : root.forms("axes")) {
    plan.axes.push_back({*objective_number(axis.text("objective")), axis.number("from"),
                         axis.number("to"), small(axis, "bins", 10)});
  }
  return plan;
}

/// What a table of keys cannot say.
void check_axes(const YamlDocument& document, const SearchPlan& plan, Diagnostics& out) {
  const YamlNode* axes = document.root.find("axes");
  if (plan.method == SearchMethod::map_elites && axes == nullptr) {
    out.add(Code::R102, document.head(*document.root.find("method")),
            "map-elites needs 'axes': two or three objectives that make its grid");
  }
  for (std::size_t i = 0; i < plan.axes.size(); ++i) {
    if (plan.axes[i].from < plan.axes[i].to) continue;
    out.add(Code::R105, document.head(*axes->items[i].find("to")),
            "an axis ends above where it begins: 'to' is greater than 'from'");
  }
}

/// As rule sets draw the structures that they expect; colours do not count.
void read_target(const YamlDocument& document, SearchPlan& plan, Diagnostics& out) {
  const YamlNode* drawing = document.root.find("target");
  if (drawing == nullptr) return;
  auto source = std::make_shared<const SourceFile>("the target's drawing", drawing->text);
  const auto structure = read_structure_text(std::move(source), plan.draw.lattice,
                                             numbered_bricks(kMostGenomeColours), out);
  if (!structure) return;
  for (const PlacedBrick& brick : structure->bricks()) plan.target.push_back(brick.at);
  if (plan.target.empty() || plan.target.size() > kMostTargetCells) {
    out.add(Code::R105, document.head(*drawing),
            fmt::format("a target has 1 to {} cells, and this one {}", kMostTargetCells,
                        plan.target.size()));
  }
}

/// What an objective needs of the plan, where the score or an axis names it.
void check_needed(const YamlDocument& document, const SearchPlan& plan, std::string_view objective,
                  std::string_view needed, std::string_view what, Diagnostics& out) {
  const std::size_t number = *objective_number(objective);
  const auto names_it = [&](const auto& part) { return part.objective == number; };
  const bool named = std::any_of(plan.score.begin(), plan.score.end(), names_it) ||
                     std::any_of(plan.axes.begin(), plan.axes.end(), names_it);
  if (!named || document.root.find(needed) != nullptr) return;
  out.add(Code::R102, document.head(*document.root.find("score")),
          fmt::format("the objective {} needs a '{}': {}", objective, needed, what));
}

void check_robot(const YamlDocument& document, const SearchPlan& plan, Diagnostics& out) {
  if (plan.robot.empty() || plan.proof > 0) return;
  out.add(Code::R102, document.head(*document.root.find("robot")),
          "a robot needs a 'proof' above 0: it is asked about what is proved alone");
}

}  // namespace

std::optional<SearchPlan> read_search_plan(SourceRef source, Diagnostics& diagnostics) {
  Diagnostics own;
  std::optional<SearchPlan> plan;
  if (const auto document = parse_yaml(std::move(source), {kMostPlanBytes, 8, 2000}, own)) {
    const BadNodes bad = check_form(*document, plan_form(), own);
    if (!own.has_errors()) plan = read_plan(FormView(document->root, bad));
    if (plan) {
      check_axes(*document, *plan, own);
      read_target(*document, *plan, own);
      check_needed(*document, *plan, "distance", "target", "the drawing of a shape", own);
      check_needed(*document, *plan, "robots", "robot", "the file of one", own);
      check_needed(*document, *plan, "refusal", "robot", "the file of one", own);
      check_robot(*document, *plan, own);
    }
  }
  diagnostics.append(own);
  return own.has_errors() ? std::nullopt : plan;
}

std::optional<SearchPlan> read_search_plan_file(const std::string& path, Diagnostics& diagnostics) {
  SourceRef source = load_source(path, kMostPlanBytes, diagnostics);
  return source ? read_search_plan(std::move(source), diagnostics) : std::nullopt;
}

std::string plan_schema() {
  return form_schema(
      plan_form(), "stigc search plan, version 1",
      "A search for rule sets: what is drawn, how it is judged, and by which method.");
}

}  // namespace stig::search
