// SPDX-License-Identifier: MIT
// Drawn by hand rather than by a library: two panels of curves with a common axis of time, as SVG
// that is the same to the byte everywhere and that an HTML report can hold. Coordinates are in
// SVG's user units, y downwards, with one decimal.
#include "validate/progress_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>

#include "base/round_step.h"

namespace stig::validate {
namespace {

constexpr double kWidth = 760, kLeft = 56, kRight = 16, kTop = 24, kCurves = 290;
constexpr double kGap = 34, kBelow = 80;  ///< before the second panel, and its height

/// From seconds and a number to a panel of the drawing. y of the drawing falls as the number rises.
struct Axes {
  double time = 1, most = 1;
  double top = kTop, height = kCurves;
  double x(double t) const { return kLeft + t / time * (kWidth - kLeft - kRight); }
  double y(double n) const { return top + height - n / most * height; }
};

void text(std::string& out, double x, double y, std::string_view rest, std::string_view what) {
  fmt::format_to(std::back_inserter(out), "<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", x, y,
                 rest, what);
}

std::string frame(const Axes& axes, double lines) {
  std::string out;
  // Steps are 1, 2 or 5 times a power of ten, at most so many on an axis.
  const double by_time = round_step(axes.time, 8), by_number = round_step(axes.most, lines);
  // A hair beyond the end, so that rounding does not take the last line.
  for (double t = 0; t <= axes.time * 1.0001; t += by_time) {
    fmt::format_to(std::back_inserter(out),
                   "<path class=\"grid\" d=\"M{0:.1f} {1:.1f}V{2:.1f}\"/>\n", axes.x(t), axes.y(0),
                   axes.y(axes.most));
  }
  for (double n = 0; n <= axes.most * 1.0001; n += by_number) {
    fmt::format_to(std::back_inserter(out),
                   "<path class=\"grid\" d=\"M{0:.1f} {1:.1f}H{2:.1f}\"/>\n", axes.x(0), axes.y(n),
                   axes.x(axes.time));
    text(out, kLeft - 8, axes.y(n) + 4, "text-anchor=\"end\"", fmt::format("{:g}", n));
  }
  return out;
}

std::string times(const Axes& axes) {
  std::string out;
  const double under = axes.y(0);
  for (double t = 0; t <= axes.time * 1.0001; t += round_step(axes.time, 8)) {
    text(out, axes.x(t), under + 17, "text-anchor=\"middle\"", fmt::format("{:g}", t));
  }
  text(out, (kLeft + kWidth - kRight) / 2, under + 38, "text-anchor=\"middle\"", "time / s");
  return out;
}

// Steps and not slopes: between two bricks there is nothing.
std::string stairs(const Axes& axes, const ProgressCurve::Steps& steps, double end) {
  std::string out = fmt::format("M{:.1f} {:.1f}", axes.x(0), axes.y(0));
  for (const auto& [time, bricks] : steps) {
    fmt::format_to(std::back_inserter(out), "H{:.1f}V{:.1f}", axes.x(time), axes.y(bricks));
  }
  return out + fmt::format("H{:.1f}", axes.x(end));
}

// Back and forth along the rows: two of these make the outline of a band.
template <class Value>
std::string points(const Axes& axes, const ProgressBand& band, bool back, const Value& value) {
  std::string out;
  const auto add = [&](const ProgressBand::Row& row) {
    // Mean plus deviation may exceed what can be built; the drawing ends at its frame.
    const double n = std::clamp(value(row), 0.0, axes.most);
    fmt::format_to(std::back_inserter(out), "{}{:.1f} {:.1f}", out.empty() && !back ? "M" : "L",
                   axes.x(row.time), axes.y(n));
  };
  if (back) {
    for (auto row = band.rows.rbegin(); row != band.rows.rend(); ++row) add(*row);
  } else {
    for (const ProgressBand::Row& row : band.rows) add(row);
  }
  return out;
}

std::string path(std::string_view kind, const std::string& way) {
  return fmt::format("<path class=\"{}\" d=\"{}\"/>\n", kind, way);
}

std::string curves_drawn(const Axes& axes, const std::vector<ProgressCurve>& curves,
                         const ProgressBand& band) {
  std::string out;
  // One run has no spread: it is drawn as the mean itself.
  const bool several = curves.size() > 1;
  if (several && !band.rows.empty()) {
    const auto high = [](const ProgressBand::Row& row) { return row.mean + row.deviation; };
    const auto low = [](const ProgressBand::Row& row) { return row.mean - row.deviation; };
    out += path("band", points(axes, band, false, high) + points(axes, band, true, low) + "Z");
  }
  for (const ProgressCurve& curve : curves) {
    // Of a single run the structures too, under their sum.
    for (std::size_t i = 0; !several && i < curve.structures.size(); ++i) {
      out += path("run", stairs(axes, curve.structures[i], curve.end));
    }
    out += path(several ? "run" : "mean", stairs(axes, curve.steps, curve.end));
  }
  const auto mean = [](const ProgressBand::Row& row) { return row.mean; };
  return several ? out + path("mean", points(axes, band, false, mean)) : out;
}

/// A line where each phase ends, through all panels, and its name above.
std::string phases_drawn(const Axes& axes, double bottom, const std::vector<WorkPhase>& phases) {
  std::string out;
  for (const WorkPhase& phase : phases) {
    text(out, axes.x((phase.from + phase.to) / 2), axes.top - 4, "text-anchor=\"middle\"",
         phase.name);
    out += path("phase", fmt::format("M{:.1f} {:.1f}V{:.1f}", axes.x(phase.to), axes.top, bottom));
  }
  return out;
}

std::string work_drawn(const Axes& axes, const ProgressBand& band) {
  std::string out = frame(axes, 4);
  out += path("sites",
              points(axes, band, false, [](const ProgressBand::Row& row) { return row.sites; }));
  out += path("idle",
              points(axes, band, false, [](const ProgressBand::Row& row) { return row.idle; }));
  text(out, kLeft, axes.top - 9, "fill=\"#2f855a\"", "sites open");
  text(out, kLeft + 80, axes.top - 9, "fill=\"#c05621\"", "robots idle");
  return out;
}

}  // namespace

std::string progress_svg(const std::vector<ProgressCurve>& curves, const ProgressBand& band,
                         int bricks) {
  assert(bricks >= 0);
  Axes axes;
  axes.most = std::max(1, bricks);
  Axes below;
  below.top = kTop + kCurves + kGap;
  below.height = kBelow;
  for (const ProgressCurve& curve : curves) {
    axes.time = std::max(axes.time, curve.end);
    for (const auto& [time, sites] : curve.sites) below.most = std::max<double>(below.most, sites);
    if (!curve.sites.empty()) below.most = std::max<double>(below.most, curve.robots);
  }
  below.time = axes.time;
  // The grid's last time may lie beyond the longest run.
  ProgressBand inside = band;
  std::erase_if(inside.rows, [&](const ProgressBand::Row& row) { return row.time > axes.time; });
  const bool work = std::any_of(curves.begin(), curves.end(),
                                [](const ProgressCurve& curve) { return !curve.sites.empty(); });
  const Axes& last = work ? below : axes;
  const double bottom = last.top + last.height;
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:g} {1:g}\" width=\"{0:g}\" "
      "height=\"{1:g}\" font-family=\"sans-serif\" font-size=\"12\">\n"
      "<style>.grid{{stroke:#ddd;fill:none}}.run{{stroke:#2b6cb0;stroke-opacity:.35;fill:none}}"
      ".mean{{stroke:#1a365d;stroke-width:2;fill:none}}.band{{fill:#2b6cb0;fill-opacity:.18}}"
      ".phase{{stroke:#555;stroke-dasharray:4 3;fill:none}}.sites{{stroke:#2f855a;fill:none}}"
      ".idle{{stroke:#c05621;fill:none}}</style>\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
      kWidth, bottom + 46);
  out += frame(axes, 8);
  text(out, 8, kTop - 9, "text-anchor=\"start\"", "bricks");
  out += curves_drawn(axes, curves, inside);
  if (work) out += work_drawn(below, inside);
  out += phases_drawn(axes, bottom, phases_of(curves)) + times(last);
  return out + "</svg>\n";
}

}  // namespace stig::validate
