// SPDX-License-Identifier: MIT
// Temporary files have names NAME.PID-ATTEMPT.tmp, and a lock of their writer's (file_io.cpp),
// which goes when that ends, however it ends.
#include "base/left_behind.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string_view>
#include <system_error>

namespace stig {
namespace {

/// The name of the file that this one was to become, if it is a temporary one.
std::optional<std::string_view> target_of(std::string_view name) {
  constexpr std::string_view kEnd = ".tmp";
  if (!name.ends_with(kEnd)) return std::nullopt;
  name.remove_suffix(kEnd.size());
  const std::size_t point = name.rfind('.'), dash = name.rfind('-');
  if (point == std::string_view::npos || dash == std::string_view::npos || dash < point) {
    return std::nullopt;
  }
  const auto is_number = [](std::string_view text) {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
  };
  const bool good =
      is_number(name.substr(point + 1, dash - point - 1)) && is_number(name.substr(dash + 1));
  if (!good) return std::nullopt;
  return name.substr(0, point);
}

/// Under the lock that its writer would have.
void remove_unlocked(const std::string& path) {
  const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  if (fd < 0) return;
  if (::flock(fd, LOCK_EX | LOCK_NB) == 0) ::unlink(path.c_str());
  ::close(fd);
}

}  // namespace

void remove_left_behind(const std::string& folder, const std::vector<std::string>& names) {
  std::error_code error;
  for (std::filesystem::directory_iterator file(folder, error), end; !error && file != end;
       file.increment(error)) {
    const std::string name = file->path().filename().string();
    const auto target = target_of(name);
    if (!target || std::find(names.begin(), names.end(), *target) == names.end()) continue;
    remove_unlocked(file->path().string());
  }
}

}  // namespace stig
