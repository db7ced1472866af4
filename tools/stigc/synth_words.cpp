// SPDX-License-Identifier: MIT
// Words that synth and synth --robot have in common.
#include "synth_words.h"

#include "base/file_io.h"
#include "outputs.h"

namespace stig::cli {

bool has_file(const SynthOptions& options) { return options.output && *options.output != "-"; }

// What names of rule sets may have: a file's name can be anything.
std::string set_name(const std::string& path) {
  std::string name = file_name(path);
  name = name.substr(0, name.rfind('.'));
  for (char& c : name) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (!plain) c = '-';
  }
  return name.empty() ? "target" : name;
}

std::string_view ended_early() {
  return stop_requested() ? "a signal ended the search: another run may find better"
                          : "the time allowed ended the search: another run may find better";
}

std::string_view early_verdict() { return stop_requested() ? "interrupted" : "out-of-time"; }

int write_one(const std::string& path, const std::string& bytes, const App& app,
              std::vector<std::string>& written) {
  FileError error;
  if (!write_file(path, bytes, error)) {
    app.complain(error.message);
    return kRunFailed;
  }
  written.push_back(path);
  return kOk;
}

}  // namespace stig::cli
