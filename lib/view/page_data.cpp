// SPDX-License-Identifier: MIT
#include "view/page_data.h"

#include <zlib.h>

#include <cassert>
#include <new>
#include <nlohmann/json.hpp>

#include "base/base64.h"
#include "base/bytes.h"

namespace stig {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

Json PageColumns::add(std::span<const std::int64_t> numbers) {
  const Json place{{"at", bytes_.size()}, {"count", numbers.size()}};
  std::int64_t last = 0;
  for (const std::int64_t number : numbers) {
    put_zigzag(bytes_, number - last);
    last = number;
  }
  return place;
}

std::string page_data(const Json& json, const PageColumns& columns) {
  const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string all;
  put(all, static_cast<std::uint32_t>(text.size()));
  all += text;
  all += columns.bytes();
  return base64(deflated(all));
}

std::string deflated(std::string_view bytes) {
  std::string out(compressBound(bytes.size()), '\0');
  uLongf size = out.size();
  const int status =
      compress2(reinterpret_cast<Bytef*>(out.data()), &size,
                reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), Z_BEST_COMPRESSION);
  if (status == Z_MEM_ERROR) throw std::bad_alloc();
  assert(status == Z_OK);
  out.resize(size);
  return out;
}

}  // namespace stig
