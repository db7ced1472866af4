// SPDX-License-Identifier: MIT
// Colours of bricks for all writers. A file may leave colours out or give more bricks than
// the palette has; every brick has some colour all the same, and the same one in every
// format.
#include "lattice/rgb.h"

#include <array>
#include <cassert>
#include <cmath>

namespace stig::lattice {

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

// Past the palette: hues by the golden angle, so that near numbers look different.
Rgb palette_colour(int index) {
  assert(index >= 0);
  if (index < static_cast<int>(kPalette.size())) return kPalette[static_cast<std::size_t>(index)];
  // The golden angle, 137.508°, never repeats a hue; lightness alternates as a second cue.
  const double hue = std::fmod(index * 137.508, 360.0) / 60.0;
  const double light = index % 2 == 0 ? 0.55 : 0.42;
  const double chroma = 0.55 * (1 - std::abs(2 * light - 1));
  const auto channel = [&](double shift) {
    const double h = std::fmod(hue + shift, 6.0);
    const double rise = std::fmin(std::fmax(std::abs(h - 3) - 1, 0), 1);
    return static_cast<std::uint8_t>(std::lround(255 * (light + chroma * (rise - 0.5))));
  };
  return {channel(0), channel(4), channel(2)};
}

}  // namespace

Rgb rgb_of(const std::vector<Brick>& bricks, Colour colour) {
  if (colour >= 1 && colour <= bricks.size()) {
    if (const auto rgb = parse_color(bricks[colour - 1U].color)) return *rgb;
  }
  return palette_colour(colour - 1);
}

std::vector<Brick> numbered_bricks(int count) {
  assert(count >= 0);
  std::vector<Brick> bricks(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    Brick& brick = bricks[static_cast<std::size_t>(i)];
    brick.symbol = brick.name = std::to_string(i + 1);
    brick.color = to_color(palette_colour(i));
  }
  return bricks;
}

Rgb rgb_in(Palette palette, Colour colour) {
  constexpr std::array<Rgb, 8> kOkabeIto = {{{0x00, 0x72, 0xb2},
                                             {0xe6, 0x9f, 0x00},
                                             {0x00, 0x9e, 0x73},
                                             {0xcc, 0x79, 0xa7},
                                             {0xd5, 0x5e, 0x00},
                                             {0x56, 0xb4, 0xe9},
                                             {0xf0, 0xe4, 0x42},
                                             {0x99, 0x99, 0x99}}};
  constexpr std::array<Rgb, 7> kTolBright = {{{0x44, 0x77, 0xaa},
                                              {0xee, 0x66, 0x77},
                                              {0x22, 0x88, 0x33},
                                              {0xcc, 0xbb, 0x44},
                                              {0x66, 0xcc, 0xee},
                                              {0xaa, 0x33, 0x77},
                                              {0xbb, 0xbb, 0xbb}}};
  assert(palette != Palette::file && colour >= 1);
  const std::size_t index = colour - 1U;
  return palette == Palette::okabe_ito ? kOkabeIto[index % kOkabeIto.size()]
                                       : kTolBright[index % kTolBright.size()];
}

std::vector<Brick> recoloured(std::vector<Brick> bricks, Palette palette, Colour most) {
  if (palette == Palette::file) return bricks;
  for (std::size_t k = bricks.size() + 1; k <= most; ++k) {
    // As symbol_of calls a colour that there is no brick for.
    bricks.emplace_back().symbol = std::to_string(k);
  }
  for (std::size_t k = 0; k < bricks.size(); ++k) {
    bricks[k].color = to_color(rgb_in(palette, static_cast<Colour>(k + 1)));
  }
  return bricks;
}

std::string symbol_of(const std::vector<Brick>& bricks, Colour colour) {
  if (colour >= 1 && colour <= bricks.size()) return bricks[colour - 1U].symbol;
  return std::to_string(colour);
}

}  // namespace stig::lattice
