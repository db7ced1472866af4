// SPDX-License-Identifier: MIT
// Apart from the compression (page_data.cpp), which the playground's page has no use for.
#include <nlohmann/json.hpp>

#include "base/bytes.h"
#include "view/page_data.h"

namespace stig::view {

nlohmann::ordered_json PageColumns::add(std::span<const std::int64_t> numbers) {
  const nlohmann::ordered_json place{{"at", bytes_.size()}, {"count", numbers.size()}};
  std::int64_t last = 0;
  for (const std::int64_t number : numbers) {
    put_zigzag(bytes_, number - last);
    last = number;
  }
  return place;
}

}  // namespace stig::view
