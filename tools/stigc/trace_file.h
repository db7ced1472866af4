// SPDX-License-Identifier: MIT
// A trace that grows on the disk while the run goes on.
#pragma once

#include <optional>
#include <string>

#include "app.h"
#include "base/file_io.h"
#include "physical/trace/pose_trace.h"
#include "uses.h"

namespace stig::cli {

class TraceFile {
 public:
  /// False when the file cannot be written: error() says why.
  bool open(const std::string& path);
  PoseTraceWriter& begin(const PoseTraceHeader& header);
  /// Everything has been written; false as above.
  bool commit();
  const std::string& path() const { return path_; }
  const std::string& error() const { return error_.message; }

 private:
  std::string path_;
  GrowingFile file_;
  FileError error_;
  std::optional<PoseTraceWriter> writer_;
};

/// Commits and says so; an exit code.
int commit(TraceFile& trace, const App& app);

}  // namespace stig::cli
