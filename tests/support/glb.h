// SPDX-License-Identifier: MIT
// What a binary glTF file says of itself.
#pragma once

#include <doctest/doctest.h>

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

namespace stig {

/// The JSON chunk; a test fails when there is none. Every view lies within the binary chunk.
inline nlohmann::json glb_content(const std::string& glb) {
  const auto word = [&](std::size_t at) {
    const auto byte = [&](std::size_t i) {
      return std::uint32_t{static_cast<unsigned char>(glb[i])};
    };
    return byte(at) | byte(at + 1) << 8U | byte(at + 2) << 16U | byte(at + 3) << 24U;
  };
  REQUIRE(glb.size() >= 20);
  REQUIRE(glb.substr(0, 4) == "glTF");
  REQUIRE(word(8) == glb.size());
  const std::size_t size = word(12);
  nlohmann::json content = nlohmann::json::parse(glb.substr(20, size));
  const std::size_t bytes = glb.size() > 20 + size ? word(20 + size) : 0;
  if (content.contains("bufferViews")) {
    for (const auto& view : content["bufferViews"]) {
      REQUIRE(view["byteOffset"].get<std::size_t>() + view["byteLength"].get<std::size_t>() <=
              bytes);
    }
  }
  return content;
}

}  // namespace stig
