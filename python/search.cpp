// SPDX-License-Identifier: MIT
// Searches as ask and tell: candidates are made and measured here, and scored by whoever asks.
// Genomes and the operators that keep them alive are there for other optimisers too.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cmath>
#include <memory>

#include "base/hash.h"
#include "base/parallel.h"
#include "interruptible.h"
#include "module.h"
#include "rules/rule_printer.h"
#include "search/objectives.h"
#include "search/operators.h"
#include "search/result_file.h"
#include "search_judges.h"

namespace stig::python {
namespace {

namespace py = pybind11;
using namespace stig::cli;
using search::Genome;
using search::Individual;

/// Of a rule's row: the colour placed and two bounds of the height, then the neighbours' states.
constexpr std::size_t kBefore = 3;

std::size_t neighbours_of(const Genome& genome) {
  return static_cast<std::size_t>(neighbourhood(genome.lattice).size);
}

py::array_t<std::int32_t> encode(const Genome& genome) {
  const std::size_t columns = kBefore + neighbours_of(genome);
  py::array_t<std::int32_t> out({genome.rules.size(), columns});
  std::int32_t* at = out.mutable_data();
  for (const search::GeneRule& rule : genome.rules) {
    *at++ = rule.place;
    *at++ = rule.height_min;
    *at++ = rule.height_max;
    for (std::size_t i = 0; i + kBefore < columns; ++i)
      *at++ = static_cast<std::int32_t>(rule.when[i]);
  }
  return out;
}

using Rows = py::array_t<std::int32_t, py::array::c_style | py::array::forcecast>;

/// The genome with other rules; it is read as one from a file is, which nobody trusts either.
Genome with_rules(const Genome& like, const Rows& rows) {
  const std::size_t columns = kBefore + neighbours_of(like);
  if (rows.ndim() != 2 || static_cast<std::size_t>(rows.shape(1)) != columns) {
    throw py::value_error("rules are rows of " + std::to_string(columns) + " numbers");
  }
  Genome out = like;
  out.rules.clear();
  const std::int32_t* at = rows.data();
  for (py::ssize_t r = 0; r < rows.shape(0); ++r) {
    search::GeneRule rule;
    rule.when.fill(search::kGeneAnything);
    const std::int32_t place = *at++;
    rule.place = place >= 1 && place <= out.colours ? static_cast<Colour>(place) : Colour{0};
    rule.height_min = *at++;
    rule.height_max = *at++;
    for (std::size_t i = 0; i + kBefore < columns; ++i)
      rule.when[i] = static_cast<search::CellGene>(*at++);
    out.rules.push_back(rule);
  }
  auto sound = search::read_genome(genome_text(out));
  if (!sound || sound->rules.empty()) {
    throw py::value_error(
        "no such genome: 1 to 64 rules, colours from 1 on, states from 1 to 131071, and in each "
        "rule a neighbour that has to be a brick");
  }
  return std::move(*sound);
}

/// A search that waits for scores.
class PySearch {
 public:
  PySearch(const std::string& path, const std::optional<std::string>& output, int threads)
      : threads_(thread_count(threads)) {
    Captured captured;
    App app(GlobalOptions{}, captured);
    task_ = read_search_task(path, app);
    problem_ = captured.err;
    codes_ = captured.codes;
    if (!task_) return;
    // Another plan's, since results that Python scores are none that the program could go on with.
    task_->plan.outside = combine(task_->plan.outside, hash_text("told"));
    hash_ = plan_hash(task_->plan);
    state_ = std::make_unique<search::SearchState>(task_->plan);
    if (output) file_ = search::ResultFile::go_on(*output, task_->plan, *state_, problem_);
    if (output && !file_) task_.reset();
  }

  bool ready() const { return task_.has_value(); }
  const std::string& problem() const { return problem_; }
  const std::vector<std::string>& codes() const { return codes_; }
  std::uint64_t evaluated() const { return state_->evaluated; }
  std::size_t structures() const { return state_->archive.structures(); }
  std::string content_hash() const { return to_hex(state_->archive.content_hash()); }
  std::size_t batch() const { return static_cast<std::size_t>(task_->plan.batch); }
  bool asked() const { return !asked_.empty(); }

  std::vector<Individual> ask(std::size_t count) {
    auto made = search::make_batch(task_->plan, *state_, count, threads_);
    asked_ = measured(std::move(made));
    return asked_;
  }

  void tell(const std::vector<double>& scores) {
    if (asked_.empty()) throw py::value_error("nothing was asked for");
    if (scores.size() != asked_.size()) {
      throw py::value_error("a score for each of the " + std::to_string(asked_.size()) +
                            " that were asked for");
    }
    for (std::size_t i = 0; i < scores.size(); ++i) {
      if (!std::isfinite(scores[i])) throw py::value_error("scores are finite numbers");
      asked_[i].score = scores[i];
      asked_[i].problem.clear();
    }
    const auto batch = take_batch(*state_, std::exchange(asked_, {}));
    if (file_ && !file_->add(batch, state_->archive, problem_)) {
      throw std::runtime_error(problem_);
    }
  }

  /// What the archive keeps of the best; structures that a file has are grown again.
  std::vector<Individual> best(std::size_t most) const {
    std::vector<Individual> out;
    search::Screener screener(task_->plan.screen);
    for (const std::size_t place : state_->archive.best(most)) {
      out.push_back(state_->archive.kept()[place]);
      Individual& one = out.back();
      if (!one.bricks.empty()) continue;
      one.bricks = built(one.genome, screener.run(one.genome, combine(hash_, one.id)));
    }
    return out;
  }

  /// Genomes from anywhere, as evaluations of number 0: nothing but they decides.
  std::vector<Individual> measure(const std::vector<Genome>& genomes) {
    std::vector<Individual> made(genomes.size());
    for (std::size_t i = 0; i < genomes.size(); ++i) {
      check(genomes[i]);
      made[i].genome = genomes[i];
      made[i].origin = "drawn";
    }
    return measured(std::move(made));
  }

  Genome draw(std::uint64_t seed) const {
    search::DrawnGenome drawn;
    Random random = random_of(seed);
    draw_genome(task_->plan.draw, random, drawn);
    return drawn.genome;
  }
  Genome mutate(const Genome& genome, std::uint64_t seed) const {
    check(genome);
    search::Screener screener(task_->plan.screen);
    Random random = random_of(seed);
    return search::mutate(task_->plan.draw, {genome, screener.run(genome, hash_)}, random);
  }
  Genome cross(const Genome& early, const Genome& late, std::uint64_t seed) const {
    check(early);
    check(late);
    search::Screener screener(task_->plan.screen);
    const search::Screening first = screener.run(early, hash_);
    Random random = random_of(seed);
    return search::cross_over({early, first}, {late, screener.run(late, hash_)}, random);
  }

 private:
  Random random_of(std::uint64_t seed) const {
    return Random(combine(hash_, seed), 0, search::kDrawing, 3, 0);
  }

  std::vector<Individual> measured(std::vector<Individual> made) const {
    const search::Judges judges = judges_of(*task_);
    auto all = interruptible([&] {
      measure_batch(task_->plan, made, judges, threads_, &stop_requested());
      return std::move(made);
    });
    if (const Individual* one = first_unscored(all)) {
      throw py::value_error("individual " + std::to_string(one->id) + ": " + one->problem);
    }
    return all;
  }

  void check(const Genome& genome) const {
    const search::DrawSettings& draw = task_->plan.draw;
    if (genome.rules.empty() || genome.lattice != draw.lattice || genome.floor != draw.floor ||
        genome.colours != draw.colours) {
      throw py::value_error("the plan's genomes have another lattice, floor or number of colours");
    }
  }

  std::optional<SearchTask> task_;
  std::uint64_t hash_ = 0;
  std::unique_ptr<search::SearchState> state_;
  std::optional<search::ResultFile> file_;
  std::vector<Individual> asked_;
  std::string problem_;
  std::vector<std::string> codes_;
  int threads_;
};

py::array_t<std::int32_t> bricks_of(const Individual& one) {
  py::array_t<std::int32_t> out({one.bricks.size(), std::size_t{4}});
  std::int32_t* at = out.mutable_data();
  for (const PlacedBrick& brick : one.bricks) {
    for (const int value : {brick.at.x, brick.at.y, brick.at.z, int{brick.brick}}) *at++ = value;
  }
  return out;
}

std::map<std::string, double> measures_of(const Individual& one) {
  std::map<std::string, double> out;
  for (std::size_t k = 0; k < one.values.size(); ++k) {
    out.emplace(search::objectives()[k].name, one.values[k]);
  }
  return out;
}

std::vector<std::uint64_t> parents_of(const Individual& one) {
  std::vector<std::uint64_t> out;
  if (one.parent) out.push_back(*one.parent);
  if (one.other_parent) out.push_back(*one.other_parent);
  return out;
}

void bind_genome(py::module_& module) {
  py::class_<Genome>(module, "Genome")
      .def(py::init([](const std::string& text) {
        auto genome = search::read_genome(text);
        if (!genome) throw py::value_error("the text is no genome");
        return std::move(*genome);
      }))
      .def("text", [](const Genome& genome) { return genome_text(genome); })
      .def("rules", [](const Genome& genome) { return print_rule_set(rule_set_of(genome)); })
      .def("encode", &encode)
      .def("with_rules", &with_rules)
      .def("__eq__", [](const Genome& a, const Genome& b) { return a == b; })
      .def("__hash__", [](const Genome& genome) { return genome_hash(genome) >> 1; });
  py::class_<Individual>(module, "Candidate")
      .def_readonly("id", &Individual::id)
      .def_readonly("score", &Individual::score)
      .def_readonly("genome", &Individual::genome)
      .def_property_readonly("origin", [](const Individual& o) { return std::string(o.origin); })
      .def_property_readonly("parents", &parents_of)
      .def_property_readonly("measures", &measures_of)
      .def_property_readonly("bricks", &bricks_of);
}

}  // namespace

void bind_search(py::module_& module) {
  bind_genome(module);
  py::class_<PySearch>(module, "Search")
      .def(py::init<const std::string&, const std::optional<std::string>&, int>())
      .def_property_readonly("ready", &PySearch::ready)
      .def_property_readonly("problem", &PySearch::problem)
      .def_property_readonly("codes", &PySearch::codes)
      .def_property_readonly("evaluated", &PySearch::evaluated)
      .def_property_readonly("structures", &PySearch::structures)
      .def_property_readonly("content_hash", &PySearch::content_hash)
      .def_property_readonly("batch", &PySearch::batch)
      .def_property_readonly("asked", &PySearch::asked)
      .def("ask", &PySearch::ask)
      .def("tell", &PySearch::tell)
      .def("best", &PySearch::best)
      .def("measure", &PySearch::measure)
      .def("draw", &PySearch::draw)
      .def("mutate", &PySearch::mutate)
      .def("cross", &PySearch::cross);
}

}  // namespace stig::python
