// SPDX-License-Identifier: MIT
// Base64 adds a third to the bytes, but keeps the page a text that can be mailed and opened
// anywhere.
#include "view/page_data.h"

#include <zlib.h>

#include <cassert>
#include <new>
#include <nlohmann/json.hpp>

#include "base/base64.h"
#include "base/bytes.h"

namespace stig::view {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

std::string page_data(const Json& json, const PageColumns& columns) {
  const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string all;
  // The length comes first, so that the script knows where the JSON ends and the columns begin.
  put(all, static_cast<std::uint32_t>(text.size()));
  all += text;
  all += columns.bytes();
  return base64(deflated(all));
}

std::string deflated(std::string_view bytes) {
  // With room for the worst case, the buffer cannot be too small, and only memory can run out.
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

}  // namespace stig::view
