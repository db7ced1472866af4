// SPDX-License-Identifier: MIT
// Rules for robots for larger and larger targets of a few forms: processor seconds against bricks,
// and the exponent that fits them. A search that found nothing was ended by its bound of effort,
// so its time says nothing of growth and is left out of the fit.
//
//   bench_assembly_sizes [MOST_BRICKS [KINDS]]
//   bench_assembly_sizes named [KINDS]
//
// With `named`: targets that were to be synthesised in a given time, or refused with a reason that
// is proved; the exit status is 1 when one of them is not.
#include <fmt/format.h>

#include <cstdlib>
#include <ctime>
#include <iostream>
#include <string>
#include <vector>

#include "assembly/assemble.h"
#include "assembly_named.h"
#include "growth.h"
#include "paper_robot.h"
#include "support/uses.h"
#include "synthesis/shapes.h"

namespace stig::bench {
namespace {

struct Form {
  const char* name;
  Target (*of)(int);
  std::vector<int> sizes;
};

struct Trial {
  double seconds = 0;  ///< of processor time
  bool found = false;
};

Trial try_size(const Form& form, int size, const Abilities& robot, int kinds) {
  AssemblyTask task;
  task.target = form.of(size);
  task.robot = robot;
  task.most_colours = kinds;
  task.wording = {"target", form.name, {}};
  const std::size_t bricks = task.target.cells.size();
  const std::clock_t before = std::clock();
  const Assembly made = assemble(task, 1);
  const double seconds = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
  std::cout << fmt::format("{:12} {:6} {:9.2f}  {}\n", form.name, bricks, seconds,
                           !made.plan              ? made.obstacle ? "impossible" : "not found"
                           : made.plan->any_number ? "any number of robots"
                                                   : "one robot")
            << std::flush;
  return {seconds, made.plan.has_value()};
}

void measure_sizes(std::size_t most, const Abilities& robot, int kinds) {
  const std::vector<Form> forms = {{"wall N×1×3",
                                    [](int n) {
                                      return box({n, 1, 3});
                                    },
                                    {8, 15, 30, 60, 120, 240, 480}},
                                   {"slab N×3×3",
                                    [](int n) {
                                      return box({n, 3, 3});
                                    },
                                    {4, 8, 15, 30, 60, 120}},
                                   {"plate N×N",
                                    [](int n) {
                                      return box({n, n, 1});
                                    },
                                    {5, 7, 10, 14, 20, 28, 40, 57, 77}}};
  std::cout << "form         bricks   seconds\n";
  for (const Form& form : forms) {
    std::vector<std::pair<double, double>> points;
    std::size_t tried = 0;
    for (const int size : form.sizes) {
      const std::size_t bricks = form.of(size).cells.size();
      if (bricks > most) break;
      const Trial trial = try_size(form, size, robot, kinds);
      ++tried;
      if (trial.found) points.emplace_back(static_cast<double>(bricks), trial.seconds);
    }
    if (points.size() > 2) {
      std::cout << fmt::format("{:12} time ~ bricks^{:.1f}, {} of {} found\n", form.name,
                               growth_of(points).exponent, points.size(), tried);
    }
  }
}

}  // namespace
}  // namespace stig::bench

int main(int argc, char** argv) {
  const bool named = argc > 1 && std::string(argv[1]) == "named";
  const std::size_t most = argc > 1 && !named ? std::strtoull(argv[1], nullptr, 10) : 1000;
  const int kinds = argc > 2 ? std::atoi(argv[2]) : stig::kBlockColours;
  if (kinds < 1 || kinds > stig::kMaxColours) {
    std::cerr << "KINDS is a number from 1 to " << stig::kMaxColours << '\n';
    return 2;
  }
  if (named) return stig::bench::measure_named(stig::bench::paper_robot(), kinds) ? 0 : 1;
  stig::bench::measure_sizes(most, stig::bench::paper_robot(), kinds);
}
