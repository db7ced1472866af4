// SPDX-License-Identifier: MIT
// stigc view: one page that shows structures and runs.
#include <fmt/format.h>

#include "commands.h"
#include "live_view.h"
#include "mesh_input.h"
#include "outputs.h"
#include "page_template.h"
#include "view_input.h"

namespace stig::cli {

int run(const ViewOptions& options, App& app) {
  if (options.live) return view_live(options, app);
  if (options.port || options.seed || options.paused || options.trace || options.checkpoint) {
    app.complain("--port, --paused, --seed, --trace and --checkpoint are for --live");
    return kUsage;
  }
  if (options.output.empty()) {
    app.complain("-o is wanted, the page, or --live to look at a run");
    return kUsage;
  }
  if (!options.output.ends_with(".html")) {
    app.complain(fmt::format("'{}': a page is .html", printable(options.output)));
    return kUsage;
  }
  const std::vector<std::string> files = viewed_files(options.files);
  std::vector<std::string> structures = files;
  if (options.target) structures.push_back(*options.target);
  if (const std::string problem = bricks_problem(options.mesh, structures); !problem.empty()) {
    app.complain(problem);
    return kUsage;
  }
  PageContent page(options.title.value_or(""));
  bool good = true;
  for (const std::string& file : files) good = add_file(file, options, app, page) && good;
  good = add_target(options, app, page) && good;
  if (!good) return kFailed;
  if (!page.of_one_kind()) {
    app.complain("runs on the lattice and runs in the physical world take a page each");
    return kUsage;
  }
  if (const int code = check_outputs({options.output}, app); code != kOk) return code;
  const auto text = page_template(app);
  if (!text) return kRunFailed;
  const auto whole = page_of(*text, page);
  if (whole) return write_output(options.output, *whole, app);
  app.complain("the template of the page is damaged: build or install the program again");
  return kRunFailed;
}

}  // namespace stig::cli
