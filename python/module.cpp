// SPDX-License-Identifier: MIT
// stigc._stigc: what the module's Python is made on. Commands run as the program runs them, from
// words to what they print, so that both say and refuse the same; runs of the lattice world and of
// scenes are there as arrays besides.
//
// The interpreter's lock is released while a command runs. Ctrl-C reaches Python's handler alone;
// the thread that called looks for it ten times a second and asks the command to stop.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <nlohmann/json.hpp>

#include "base/memory_file.h"
#include "base/yaml_edit.h"
#include "explore_config.h"
#include "interruptible.h"
#include "lattice/structure_files.h"
#include "module.h"
#include "report.h"
#include "run_line.h"
#include "shipped_files.h"

namespace stig::python {
namespace {

namespace py = pybind11;
using namespace stig::cli;

struct Said {
  int status = kOk;
  Captured captured;
};

py::tuple run(const std::vector<std::string>& words) {
  const Said said = interruptible([&words] {
    Said out;
    Parsed parsed = parse_words(words);
    out.status = run_captured(parsed, out.captured);
    return out;
  });
  return py::make_tuple(said.status, said.captured.out, said.captured.err, said.captured.codes);
}

/// A run of the lattice world, with its bricks and deposits as rows of numbers.
struct Growth {
  std::string report, problem;
  std::vector<std::string> codes;
  int status = kOk;
  std::vector<std::int32_t> bricks;    ///< x y z brick
  std::vector<std::int64_t> deposits;  ///< step agent x y z brick rule
};

std::vector<std::int32_t> rows_of(const Structure& structure) {
  std::vector<std::int32_t> rows;
  rows.reserve(4 * structure.size());
  for (const PlacedBrick& brick : structure.bricks()) {
    rows.insert(rows.end(), {brick.at.x, brick.at.y, brick.at.z, brick.brick});
  }
  return rows;
}

void add_row(std::vector<std::int64_t>& rows, const Deposit& d) {
  rows.insert(rows.end(), {static_cast<std::int64_t>(d.step), d.agent, d.site.x, d.site.y, d.site.z,
                           d.colour, static_cast<std::int64_t>(d.match.rule)});
}

Growth fail(int status, std::string problem, Captured captured = {}) {
  Growth out;
  out.status = status;
  out.problem = captured.err + problem;
  out.codes = std::move(captured.codes);
  return out;
}

Growth grow_now(const std::vector<std::string>& words) {
  Parsed parsed = parse_words(words);
  if (!parsed.line) return fail(kUsage, parsed.problem);
  Captured captured;
  App app(parsed.line->global, captured);
  find_shipped_files(parsed.line->command, app);
  const auto& options = std::get<ExploreOptions>(parsed.line->command);
  const auto rules = app.read_rules(options.file);
  if (!rules) return fail(kFailed, "", std::move(captured));
  const RuleTable table(*rules);
  ExploreConfig config = explore_config(*rules, table, options);
  if (!config.problem.empty()) return fail(kUsage, config.problem);
  config.swarm.run = static_cast<std::uint32_t>(options.run.value_or(0));
  Growth out;
  SwarmHooks hooks;
  hooks.stop = &stop_requested();
  hooks.deposit = [&out](const Deposit& deposit) { add_row(out.deposits, deposit); };
  const SwarmResult result = run_swarm(table, rules->start, config.swarm, hooks);
  out.bricks = rows_of(result.structure);
  out.report = dump(run_json(*rules, config.swarm, result));
  return out;
}

Growth grow(const std::vector<std::string>& words) {
  return interruptible([&words] { return grow_now(words); });
}

/// The array looks into the object, which lives as long as the array does.
template <class Number>
py::array rows(py::object owner, const std::vector<Number>& numbers, std::size_t columns) {
  return py::array(py::dtype::of<Number>(), {numbers.size() / columns, columns}, numbers.data(),
                   std::move(owner));
}

py::tuple read_structure(const std::string& path) {
  Diagnostics diagnostics;
  const auto loaded = read_structure_file(path, {}, diagnostics);
  if (!loaded) return py::make_tuple(py::none(), py::none(), to_text(diagnostics));
  const auto numbers = rows_of(loaded->structure);
  py::array_t<std::int32_t> out({numbers.size() / 4, std::size_t{4}});
  std::copy(numbers.begin(), numbers.end(), out.mutable_data());
  return py::make_tuple(out, loaded->structure.lattice() == Lattice::cubic ? "cubic" : "hexagonal",
                        "");
}

void bind_growth(py::module_& module) {
  py::class_<Growth>(module, "Growth", py::buffer_protocol())
      .def_readonly("status", &Growth::status)
      .def_readonly("problem", &Growth::problem)
      .def_readonly("codes", &Growth::codes)
      .def_readonly("report", &Growth::report)
      .def_property_readonly(
          "bricks",
          [](const py::object& self) { return rows(self, self.cast<Growth&>().bricks, 4); })
      .def_property_readonly("deposits", [](const py::object& self) {
        return rows(self, self.cast<Growth&>().deposits, 7);
      });
}

}  // namespace
}  // namespace stig::python

PYBIND11_MODULE(_stigc, module) {
  using namespace stig::python;
  stig::cli::leave_signals_alone();
  module.attr("version") = STIG_VERSION;
  module.def("run", &run);
  module.def("grow", &grow);
  module.def("read_structure", &read_structure);
  module.def("set_program_folder", &stig::cli::set_program_folder);
  module.def("with_value",
             [](const std::string& text, const std::string& path, const std::string& value) {
               std::string problem;
               auto out = stig::with_value(text, path, value, problem);
               if (!out) throw pybind11::value_error(problem);
               return *out;
             });
  pybind11::class_<stig::MemoryFile>(module, "MemoryFile")
      .def(pybind11::init<std::string, std::string>())
      .def_property_readonly("path", &stig::MemoryFile::path);
  bind_growth(module);
  bind_scene(module);
  bind_search(module);
  bind_traces(module);
}
