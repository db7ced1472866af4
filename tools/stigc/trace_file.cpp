// SPDX-License-Identifier: MIT
// A trace appears under its name when it is whole (GrowingFile); until then a failure to write is
// kept, and told once at the end.
#include "trace_file.h"

#include <cassert>

namespace stig::cli {

bool TraceFile::open(const std::string& path) {
  path_ = path;
  return file_.open(path, error_);
}

PoseTraceWriter& TraceFile::begin(const PoseTraceHeader& header) {
  assert(!writer_);
  return writer_.emplace(header, [this](std::string_view bytes) {
    // After the first failure the file is closed, and nothing more is tried.
    if (file_.is_open()) file_.append(bytes, error_);
  });
}

bool TraceFile::commit() { return file_.is_open() && file_.commit(error_); }

int commit(TraceFile& trace, const App& app) {
  if (trace.commit()) {
    app.say("wrote " + printable(trace.path()));
    return kOk;
  }
  app.complain(trace.error());
  return kRunFailed;
}

}  // namespace stig::cli
