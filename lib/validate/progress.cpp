// SPDX-License-Identifier: MIT
#include "validate/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace stig {
namespace {

constexpr double kMostRows = 240;
constexpr double kWidth = 760, kHeight = 360, kLeft = 56, kRight = 16, kTop = 24, kBottom = 46;

/// A round number such that there are at most `most` of it up to `reach`.
double round_step(double reach, double most) {
  double step = 1;
  for (int i = 0; step * most < reach; ++i) step *= i % 3 == 1 ? 2.5 : 2;
  return step;
}

/// From seconds and bricks to the drawing.
struct Axes {
  double time = 1, bricks = 1;
  double x(double t) const { return kLeft + t / time * (kWidth - kLeft - kRight); }
  double y(double n) const { return kHeight - kBottom - n / bricks * (kHeight - kTop - kBottom); }
};

void text(std::string& out, double x, double y, std::string_view anchor, const std::string& what) {
  fmt::format_to(std::back_inserter(out),
                 "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor,
                 what);
}

std::string frame(const Axes& axes) {
  std::string out;
  const double by_time = round_step(axes.time, 8), by_bricks = round_step(axes.bricks, 8);
  for (double t = 0; t <= axes.time * 1.0001; t += by_time) {
    fmt::format_to(std::back_inserter(out),
                   "<path class=\"grid\" d=\"M{0:.1f} {1:.1f}V{2:.1f}\"/>\n", axes.x(t), axes.y(0),
                   axes.y(axes.bricks));
    text(out, axes.x(t), kHeight - kBottom + 17, "middle", fmt::format("{:g}", t));
  }
  for (double n = 0; n <= axes.bricks * 1.0001; n += by_bricks) {
    fmt::format_to(std::back_inserter(out),
                   "<path class=\"grid\" d=\"M{0:.1f} {1:.1f}H{2:.1f}\"/>\n", axes.x(0), axes.y(n),
                   axes.x(axes.time));
    text(out, kLeft - 8, axes.y(n) + 4, "end", fmt::format("{:g}", n));
  }
  text(out, (kLeft + kWidth - kRight) / 2, kHeight - 8, "middle", "time / s");
  text(out, kLeft, kTop - 9, "start", "bricks placed");
  return out;
}

std::string stairs(const Axes& axes, const ProgressCurve& curve) {
  std::string out = fmt::format("M{:.1f} {:.1f}", axes.x(0), axes.y(0));
  for (const auto& [time, bricks] : curve.steps) {
    fmt::format_to(std::back_inserter(out), "H{:.1f}V{:.1f}", axes.x(time), axes.y(bricks));
  }
  return out + fmt::format("H{:.1f}", axes.x(curve.end));
}

template <class Value>
std::string points(const Axes& axes, const ProgressBand& band, bool back, const Value& value) {
  std::string out;
  const auto add = [&](const ProgressBand::Row& row) {
    const double n = std::clamp(value(row), 0.0, axes.bricks);
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

}  // namespace

int ProgressCurve::at(double time) const {
  int out = 0;
  for (const auto& [when, bricks] : steps) {
    if (when <= time + 1e-9) out = bricks;
  }
  return out;
}

ProgressCurve curve_of(const BuildTarget& target, const Trial& trial) {
  ProgressCurve curve{trial.seed, {}, trial.time};
  int bricks = 0;
  for (const BrickEvent& event : trial.events) {
    const State wanted = target.whole.at(event.cell);
    if (!is_brick(wanted) || led_of(*target.rules, wanted) != event.led) continue;
    bricks += event.kind == BrickEvent::Kind::placed ? 1 : -1;
    curve.steps.emplace_back(event.time, bricks);
  }
  return curve;
}

ProgressBand band_of(const std::vector<ProgressCurve>& curves) {
  ProgressBand band;
  double end = 0;
  for (const ProgressCurve& curve : curves) end = std::max(end, curve.end);
  const double step = round_step(end, kMostRows);
  const auto n = static_cast<double>(curves.size());
  for (double time = 0; !curves.empty() && time < end + step; time += step) {
    ProgressBand::Row row{time, 0, 0, curves.front().at(time), 0};
    for (const ProgressCurve& curve : curves) {
      const int bricks = curve.at(time);
      row.mean += bricks / n;
      row.least = std::min(row.least, bricks);
      row.most = std::max(row.most, bricks);
    }
    double squares = 0;
    for (const ProgressCurve& curve : curves) {
      const double off = curve.at(time) - row.mean;
      squares += off * off;
    }
    row.deviation = curves.size() > 1 ? std::sqrt(squares / (n - 1)) : 0;
    band.rows.push_back(row);
  }
  return band;
}

std::string progress_csv(const std::vector<ProgressCurve>& curves, const ProgressBand& band) {
  std::string out = "time,mean,deviation,least,most";
  for (const ProgressCurve& curve : curves) out += fmt::format(",seed_{}", curve.seed);
  out += "\n";
  for (const ProgressBand::Row& row : band.rows) {
    out += fmt::format("{:g},{:.3f},{:.3f},{},{}", row.time, row.mean, row.deviation, row.least,
                       row.most);
    for (const ProgressCurve& curve : curves) out += fmt::format(",{}", curve.at(row.time));
    out += "\n";
  }
  return out;
}

std::string progress_svg(const std::vector<ProgressCurve>& curves, const ProgressBand& band,
                         int bricks) {
  Axes axes;
  axes.bricks = std::max(1, bricks);
  for (const ProgressCurve& curve : curves) axes.time = std::max(axes.time, curve.end);
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:g} {1:g}\" width=\"{0:g}\" "
      "height=\"{1:g}\" font-family=\"sans-serif\" font-size=\"12\">\n"
      "<style>.grid{{stroke:#ddd;fill:none}}.run{{stroke:#2b6cb0;stroke-opacity:.35;fill:none}}"
      ".mean{{stroke:#1a365d;stroke-width:2;fill:none}}.band{{fill:#2b6cb0;fill-opacity:.18}}"
      "</style>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
      kWidth, kHeight);
  out += frame(axes);
  // The grid's last time may lie beyond the longest run.
  ProgressBand inside = band;
  std::erase_if(inside.rows, [&](const ProgressBand::Row& row) { return row.time > axes.time; });
  if (curves.size() > 1 && !inside.rows.empty()) {
    const auto high = [](const ProgressBand::Row& row) { return row.mean + row.deviation; };
    const auto low = [](const ProgressBand::Row& row) { return row.mean - row.deviation; };
    out += fmt::format("<path class=\"band\" d=\"{}{}Z\"/>\n", points(axes, inside, false, high),
                       points(axes, inside, true, low));
  }
  for (const ProgressCurve& curve : curves) {
    out += fmt::format("<path class=\"{}\" d=\"{}\"/>\n", curves.size() > 1 ? "run" : "mean",
                       stairs(axes, curve));
  }
  if (curves.size() > 1) {
    const auto mean = [](const ProgressBand::Row& row) { return row.mean; };
    out += fmt::format("<path class=\"mean\" d=\"{}\"/>\n", points(axes, inside, false, mean));
  }
  return out + "</svg>\n";
}

}  // namespace stig
