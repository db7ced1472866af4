// SPDX-License-Identifier: MIT
// Drawn by hand rather than by a library, as the curves of validations are. Coordinates are in
// SVG's user units, y downwards, with one decimal.
#include "search/plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>

#include "base/round_step.h"
#include "base/text.h"

namespace stig::search {
namespace {

constexpr double kWidth = 640, kHeight = 420, kLeft = 72, kRight = 20, kTop = 34, kBottom = 50;

constexpr double kLeastStep = 1e-9;  ///< of an axis

/// From values to the drawing along one direction; from < to.
struct Scale {
  double from = 0, to = 1;
  double begin = 0, end = 1;  ///< in the drawing
  double at(double value) const { return begin + (value - from) / (to - from) * (end - begin); }
};

/// Whole steps around the values, so that no point lies on the frame's outside.
Scale scale_over(double low, double high, double begin, double end) {
  if (!(low < high)) {
    low -= 0.5;
    high += 0.5;
  }
  const double step = round_step(high - low, 6, kLeastStep);
  return {std::floor(low / step) * step, std::ceil(high / step) * step, begin, end};
}

struct Frame {
  Scale x, y;
};

Frame frame_over(double x_low, double x_high, double y_low, double y_high) {
  return {scale_over(x_low, x_high, kLeft, kWidth - kRight),
          scale_over(y_low, y_high, kHeight - kBottom, kTop)};
}

void text(std::string& out, double x, double y, std::string_view anchor, std::string_view what) {
  fmt::format_to(std::back_inserter(out),
                 "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor,
                 escaped_markup(what));
}

/// Numbers of steps, so that a step of 0.1 is not added up to 0.30000000000000004.
template <class Draw>
void for_each_step(const Scale& scale, const Draw& draw) {
  const double step = round_step(scale.to - scale.from, 8, kLeastStep);
  const auto first = static_cast<long>(std::ceil(scale.from / step - 1e-6));
  for (long k = first; static_cast<double>(k) * step <= scale.to + step * 1e-6; ++k) {
    draw(static_cast<double>(k) * step);
  }
}

std::string opened(const Frame& frame, const std::string& x, const std::string& y) {
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:g} {1:g}\" width=\"{0:g}\" "
      "height=\"{1:g}\" font-family=\"sans-serif\" font-size=\"12\">\n"
      "<style>.grid{{stroke:#ddd;fill:none}}.run{{stroke:#2b6cb0;stroke-opacity:.35;fill:none}}"
      ".mean{{stroke:#1a365d;stroke-width:2;fill:none}}.band{{fill:#2b6cb0;fill-opacity:.18}}"
      ".bar{{fill:#2b6cb0}}</style>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
      kWidth, kHeight);
  for_each_step(frame.x, [&](double value) {
    fmt::format_to(std::back_inserter(out), "<path class=\"grid\" d=\"M{:.1f} {:g}V{:g}\"/>\n",
                   frame.x.at(value), kTop, kHeight - kBottom);
    text(out, frame.x.at(value), kHeight - kBottom + 17, "middle", fmt::format("{:.6g}", value));
  });
  for_each_step(frame.y, [&](double value) {
    fmt::format_to(std::back_inserter(out), "<path class=\"grid\" d=\"M{:g} {:.1f}H{:g}\"/>\n",
                   kLeft, frame.y.at(value), kWidth - kRight);
    text(out, kLeft - 8, frame.y.at(value) + 4, "end", fmt::format("{:.6g}", value));
  });
  text(out, (kLeft + kWidth - kRight) / 2, kHeight - 12, "middle", x);
  text(out, 8, kTop - 14, "start", y);
  return out;
}

/// Viridis (van der Walt & Smith 2015) at five places, linear between them: it is read in order by
/// everybody and in grey.
std::string shade_of(double share) {
  constexpr std::array<std::array<double, 3>, 5> kStops = {
      {{68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {253, 231, 37}}};
  const double at = std::clamp(share, 0.0, 1.0) * 4;
  const auto low = std::min<std::size_t>(3, static_cast<std::size_t>(at));
  std::array<int, 3> rgb{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double mixed =
        kStops[low][i] + (at - static_cast<double>(low)) * (kStops[low + 1][i] - kStops[low][i]);
    rgb[i] = static_cast<int>(mixed + 0.5);
  }
  return fmt::format("#{:02x}{:02x}{:02x}", rgb[0], rgb[1], rgb[2]);
}

std::string no_values() {
  std::string out =
      opened({{0, 1, kLeft, kWidth - kRight}, {0, 1, kHeight - kBottom, kTop}}, "", "");
  text(out, kWidth / 2, kHeight / 2, "middle", "nothing to show");
  return out + "</svg>\n";
}

std::string path_of(const Frame& frame, const PlotCurve& curve) {
  std::string out;
  for (const auto& [x, y] : curve) {
    fmt::format_to(std::back_inserter(out), "{}{:.1f} {:.1f}", out.empty() ? "M" : "L",
                   frame.x.at(x), frame.y.at(y));
  }
  return out;
}

struct BandRow {
  double x = 0, mean = 0, deviation = 0;
};

/// At the x that all curves have.
std::vector<BandRow> band_of(const std::vector<PlotCurve>& curves) {
  std::map<double, std::vector<double>> at;
  for (const PlotCurve& curve : curves) {
    for (const auto& [x, y] : curve) at[x].push_back(y);
  }
  std::vector<BandRow> rows;
  for (const auto& [x, values] : at) {
    if (values.size() != curves.size()) continue;
    const auto count = static_cast<double>(values.size());
    BandRow row{x, 0, 0};
    for (const double value : values) row.mean += value / count;
    double squares = 0;
    for (const double value : values) squares += (value - row.mean) * (value - row.mean);
    row.deviation = std::sqrt(squares / (count - 1));
    rows.push_back(row);
  }
  return rows;
}

std::string band_drawn(const Frame& frame, const std::vector<PlotCurve>& curves) {
  const std::vector<BandRow> rows = band_of(curves);
  if (rows.empty()) return {};
  PlotCurve outline, mean;
  for (const BandRow& row : rows) {
    outline.emplace_back(row.x, std::min(row.mean + row.deviation, frame.y.to));
    mean.emplace_back(row.x, row.mean);
  }
  for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
    outline.emplace_back(row->x, std::max(row->mean - row->deviation, frame.y.from));
  }
  return fmt::format("<path class=\"band\" d=\"{}Z\"/>\n<path class=\"mean\" d=\"{}\"/>\n",
                     path_of(frame, outline), path_of(frame, mean));
}

}  // namespace

std::string scatter_svg(const std::string& x, const std::string& y, const std::string& shade,
                        std::vector<PlotPoint> points) {
  std::erase_if(points, [](const PlotPoint& p) {
    return !std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.shade);
  });
  if (points.empty()) return no_values();
  const auto range = [&](double PlotPoint::*member) {
    const auto [low, high] = std::minmax_element(
        points.begin(), points.end(),
        [&](const PlotPoint& a, const PlotPoint& b) { return a.*member < b.*member; });
    return std::pair((*low).*member, (*high).*member);
  };
  const auto xs = range(&PlotPoint::x), ys = range(&PlotPoint::y),
             shades = range(&PlotPoint::shade);
  const Frame frame = frame_over(xs.first, xs.second, ys.first, ys.second);
  std::string out = opened(frame, x, y);
  const double span = shades.second > shades.first ? shades.second - shades.first : 1;
  for (const PlotPoint& p : points) {
    const double share = shade.empty() ? 0.25 : (p.shade - shades.first) / span;
    fmt::format_to(std::back_inserter(out),
                   "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\" fill=\"{}\" "
                   "fill-opacity=\".7\"/>\n",
                   frame.x.at(p.x), frame.y.at(p.y), shade_of(share));
  }
  if (!shade.empty()) {
    text(out, kWidth - kRight, kTop - 14, "end",
         fmt::format("{}: {:.6g} dark to {:.6g} bright", shade, shades.first, shades.second));
  }
  return out + "</svg>\n";
}

std::string histogram_svg(const std::string& name, std::vector<double> values) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  if (values.empty()) return no_values();
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const Scale across = scale_over(*low, *high, kLeft, kWidth - kRight);
  const double step = round_step(across.to - across.from, 40, kLeastStep);
  std::map<long, int> bars;
  int most = 0;
  for (const double value : values) {
    most = std::max(most, ++bars[static_cast<long>(std::floor((value - across.from) / step))]);
  }
  const Frame frame{across, scale_over(0, most, kHeight - kBottom, kTop)};
  std::string out = opened(frame, name, "finds");
  for (const auto& [bar, count] : bars) {
    const double left = frame.x.at(across.from + static_cast<double>(bar) * step);
    const double top = frame.y.at(count);
    fmt::format_to(
        std::back_inserter(out),
        "<rect class=\"bar\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" "
        "height=\"{:.1f}\"/>\n",
        left, top,
        std::max(1.0, (across.end - across.begin) * step / (across.to - across.from) - 1),
        frame.y.at(0) - top);
  }
  return out + "</svg>\n";
}

std::string curves_svg(const std::string& x, const std::string& y,
                       const std::vector<PlotCurve>& curves) {
  PlotCurve all;
  for (const PlotCurve& curve : curves) {
    for (const auto& point : curve) {
      if (!std::isfinite(point.first) || !std::isfinite(point.second)) return no_values();
      all.push_back(point);
    }
  }
  if (all.empty()) return no_values();
  const auto by_y = [](const auto& a, const auto& b) { return a.second < b.second; };
  const auto xs = std::minmax_element(all.begin(), all.end());
  const auto ys = std::minmax_element(all.begin(), all.end(), by_y);
  const Frame frame =
      frame_over(xs.first->first, xs.second->first, ys.first->second, ys.second->second);
  std::string out = opened(frame, x, y);
  const bool several = curves.size() > 1;
  if (several) out += band_drawn(frame, curves);
  for (const PlotCurve& curve : curves) {
    out += fmt::format("<path class=\"{}\" d=\"{}\"/>\n", several ? "run" : "mean",
                       path_of(frame, curve));
  }
  return out + "</svg>\n";
}

}  // namespace stig::search
