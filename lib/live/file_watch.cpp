// SPDX-License-Identifier: MIT
// A file that is away is not a change that matters: an editor may be about to rename another to its
// name.
#include "live/file_watch.h"

namespace stig::live {

FileWatch::Stamp FileWatch::stamp_of(const std::string& path) {
  std::error_code error;
  Stamp out;
  out.time = std::filesystem::last_write_time(path, error);
  if (!error) out.size = std::filesystem::file_size(path, error);
  out.there = !error;
  return out.there ? out : Stamp{};
}

void FileWatch::watch(const std::vector<std::string>& paths) {
  known_.clear();
  for (const std::string& path : paths) known_[path] = stamp_of(path);
  last_ = known_;
}

bool FileWatch::saved() {
  bool changed = false, quiet = true;
  for (const auto& known : known_) {
    const Stamp now = stamp_of(known.first);
    changed = changed || (now.there && !(now == known.second));
    Stamp& last = last_[known.first];
    quiet = quiet && now == last;
    last = now;
  }
  return changed && quiet;
}

}  // namespace stig::live
