// SPDX-License-Identifier: MIT
#include "lattice/rgb.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace stig {

namespace {

// Okabe & Ito (2008), "Color universal design": told apart by colour-blind readers.
constexpr std::array<Rgb, 8> kPalette = {{{0x00, 0x72, 0xb2},
                                          {0xe6, 0x9f, 0x00},
                                          {0x00, 0x9e, 0x73},
                                          {0xd5, 0x5e, 0x00},
                                          {0x56, 0xb4, 0xe9},
                                          {0xcc, 0x79, 0xa7},
                                          {0xf0, 0xe4, 0x42},
                                          {0x99, 0x99, 0x99}}};

std::uint8_t to_byte(double value) {
  return static_cast<std::uint8_t>(std::lround(std::fmin(std::fmax(value, 0), 255)));
}

// Past the palette: hues by the golden angle, so that near numbers look different.
Rgb palette_colour(int index) {
  if (index < static_cast<int>(kPalette.size())) return kPalette[static_cast<std::size_t>(index)];
  const double hue = std::fmod(index * 137.508, 360.0) / 60.0;
  const double light = index % 2 == 0 ? 0.55 : 0.42;
  const double chroma = 0.55 * (1 - std::abs(2 * light - 1));
  const auto channel = [&](double shift) {
    const double h = std::fmod(hue + shift, 6.0);
    const double rise = std::fmin(std::fmax(std::abs(h - 3) - 1, 0), 1);
    return to_byte(255 * (light + chroma * (rise - 0.5)));
  };
  return {channel(0), channel(4), channel(2)};
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

}  // namespace

std::optional<Rgb> parse_color(std::string_view text) {
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  std::array<std::uint8_t, 3> channels{};
  for (std::size_t i = 0; i < 3; ++i) {
    const int high = hex_digit(text[1 + 2 * i]);
    const int low = hex_digit(text[2 + 2 * i]);
    if (high < 0 || low < 0) return std::nullopt;
    channels[i] = static_cast<std::uint8_t>(16 * high + low);
  }
  return Rgb{channels[0], channels[1], channels[2]};
}

std::string to_color(Rgb rgb) { return fmt::format("#{:02x}{:02x}{:02x}", rgb.r, rgb.g, rgb.b); }

Rgb rgb_of(const std::vector<Brick>& bricks, Colour colour) {
  if (colour >= 1 && colour <= bricks.size()) {
    if (const auto rgb = parse_color(bricks[colour - 1U].color)) return *rgb;
  }
  return palette_colour(colour - 1);
}

Rgb blend(Rgb a, Rgb b, double t) {
  const auto channel = [t](std::uint8_t from, std::uint8_t to) {
    return to_byte(from + t * (to - from));
  };
  return {channel(a.r, b.r), channel(a.g, b.g), channel(a.b, b.b)};
}

double linear_light(std::uint8_t value) {
  const double s = value / 255.0;
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

std::vector<Brick> numbered_bricks(int count) {
  std::vector<Brick> bricks(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    Brick& brick = bricks[static_cast<std::size_t>(i)];
    brick.symbol = brick.name = std::to_string(i + 1);
    brick.color = to_color(palette_colour(i));
  }
  return bricks;
}

std::string symbol_of(const std::vector<Brick>& bricks, Colour colour) {
  if (colour >= 1 && colour <= bricks.size()) return bricks[colour - 1U].symbol;
  return std::to_string(colour);
}

}  // namespace stig
