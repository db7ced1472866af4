// SPDX-License-Identifier: MIT
#include "base/memory_file.h"

#include <cassert>
#include <map>
#include <mutex>
#include <utility>

namespace stig {
namespace {

struct MemoryShelf {
  std::mutex mutex;
  std::map<std::string, std::string> texts;
};

MemoryShelf& shelf() {
  static MemoryShelf one;
  return one;
}

}  // namespace

MemoryFile::MemoryFile(std::string path, std::string text) : path_(std::move(path)) {
  const std::lock_guard lock(shelf().mutex);
  [[maybe_unused]] const bool fresh = shelf().texts.emplace(path_, std::move(text)).second;
  assert(fresh);
}

MemoryFile::~MemoryFile() {
  const std::lock_guard lock(shelf().mutex);
  shelf().texts.erase(path_);
}

std::optional<std::string> in_memory(const std::string& path) {
  const std::lock_guard lock(shelf().mutex);
  const auto found = shelf().texts.find(path);
  if (found == shelf().texts.end()) return std::nullopt;
  return found->second;
}

}  // namespace stig
