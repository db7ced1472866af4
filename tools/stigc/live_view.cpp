// SPDX-License-Identifier: MIT
// The session runs in this thread, the server in threads of its own. Files are written when they
// are whole: checkpoints as they are taken, the trace at the end.
#include "live_view.h"

#include <fmt/format.h>

#include "base/file_guard.h"
#include "base/file_io.h"
#include "live/server.h"
#include "live_input.h"
#include "outputs.h"
#include "page_template.h"

namespace stig::cli {
namespace {

/// What is wrong with the options together; empty: nothing.
std::string live_problem(const ViewOptions& o) {
  if (!o.output.empty()) return "--live serves the page: leave -o out";
  if (o.files.size() != 1) return "--live takes one scene or rule set";
  if (o.target || o.title || o.lattice || o.mesh.bricks) {
    return "--target, --title, --lattice and --bricks are for -o";
  }
  return {};
}

/// The newest checkpoint takes the place of the one before.
std::string keep(const std::string& path, const std::string& bytes) {
  FileError error;
  let_rewrite(path);
  return write_file(path, bytes, error) ? std::string() : error.message;
}

int serve(const ViewOptions& options, const std::string& page, LiveLoad first, App& app) {
  LiveSettings settings;
  settings.load = [&] { return load_live(options, app); };
  settings.paused = options.paused;
  if (options.checkpoint) {
    settings.keep_checkpoint = [&](const std::string& bytes) {
      return keep(*options.checkpoint, bytes);
    };
  }
  LiveSession session(std::move(settings), std::move(first));
  const std::string token = random_token();
  LiveServer server(session, page, token);
  const auto port = server.bind(options.port.value_or(0));
  if (!port) {
    app.complain(
        options.port
            ? fmt::format("port {} of 127.0.0.1 cannot be had: another program may have it",
                          *options.port)
            : "no port of 127.0.0.1 can be had");
    return kRunFailed;
  }
  server.start();
  // At once: somebody waits for it.
  app.print(fmt::format("http://127.0.0.1:{}/?token={}\n", *port, token));
  app.flush();
  app.say("open this address in a browser of this machine; Ctrl-C ends the run");
  const std::string trace = session.work(stop_requested());
  accept_stop();
  server.stop();
  return options.trace ? write_output(*options.trace, trace, app) : kOk;
}

}  // namespace

int view_live(const ViewOptions& options, App& app) {
  const std::string problem = live_problem(options);
  if (!problem.empty()) {
    app.complain(problem);
    return kUsage;
  }
  // From now on an end that is asked for is a good one, however early it comes.
  stop_on_signals();
  LiveLoad first = load_live(options, app);
  if (!first.run) return kFailed;
  std::vector<std::string> outputs;
  for (const auto& path : {options.trace, options.checkpoint}) {
    if (path) outputs.push_back(*path);
  }
  if (const int code = check_outputs(outputs, app); code != kOk) return code;
  const auto page = page_template(app);
  return page ? serve(options, *page, std::move(first), app) : kRunFailed;
}

}  // namespace stig::cli
