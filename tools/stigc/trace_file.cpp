// SPDX-License-Identifier: MIT
#include "trace_file.h"

namespace stig {

bool TraceFile::open(const std::string& path) {
  path_ = path;
  return file_.open(path, error_);
}

PoseTraceWriter& TraceFile::begin(const PoseTraceHeader& header) {
  return writer_.emplace(header, [this](std::string_view bytes) {
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

}  // namespace stig
