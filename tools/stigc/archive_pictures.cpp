// SPDX-License-Identifier: MIT
// Figures are named by what stands on their axes: one name is a distribution, two are points or,
// over `evaluated`, a curve, and a third one colours points.
#include "archive_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/base64.h"
#include "base/text.h"
#include "lattice/picture.h"
#include "outputs.h"
#include "search/objectives.h"
#include "search/plots.h"
#include "search/result_file.h"

namespace stig::cli {
namespace {

constexpr std::size_t kAllFinds = 1'000'000;
constexpr std::string_view kOver = "evaluated";
constexpr std::array<std::string_view, 3> kCurves = {"best", "mean", "structures"};
/// Generations that a page tells of each find.
constexpr int kMostAncestors = 12;

std::vector<std::string> split(const std::string& names) {
  std::vector<std::string> words(1);
  for (const char c : names) {
    c == ',' ? words.emplace_back().clear() : words.back().push_back(c);
  }
  return words;
}

bool is_curve(const std::vector<std::string>& words) {
  return words.size() == 2 && words[0] == kOver &&
         std::find(kCurves.begin(), kCurves.end(), words[1]) != kCurves.end();
}

bool is_measure(const std::string& word) {
  return word == "score" || word == "times" || word == "id" ||
         search::objective_number(word).has_value();
}

double value_of(const search::StoredFind& find, const std::string& word) {
  if (word == "score") return find.score;
  if (word == "times") return static_cast<double>(find.times);
  if (word == "id") return static_cast<double>(find.id);
  return find.values[*search::objective_number(word)];
}

double value_of(const search::StoredBatch& batch, const std::string& word) {
  if (word == "best") return batch.best;
  return word == "mean" ? batch.mean : static_cast<double>(batch.structures);
}

std::string figure(const std::vector<search::StoredResults>& all,
                   const std::vector<std::string>& words) {
  if (is_curve(words)) {
    std::vector<search::PlotCurve> curves;
    for (const search::StoredResults& results : all) {
      auto& curve = curves.emplace_back();
      for (const search::StoredBatch& batch : results.batches) {
        curve.emplace_back(static_cast<double>(batch.evaluated), value_of(batch, words[1]));
      }
    }
    return search::curves_svg(words[0], words[1], curves);
  }
  std::vector<double> values;
  std::vector<search::PlotPoint> points;
  for (const search::StoredResults& results : all) {
    for (const search::StoredFind& find : results.finds) {
      values.push_back(value_of(find, words[0]));
      if (words.size() < 2) continue;
      const double shade = words.size() > 2 ? value_of(find, words[2]) : 0;
      points.push_back({values.back(), value_of(find, words[1]), shade});
    }
  }
  if (words.size() == 1) return search::histogram_svg(words[0], std::move(values));
  return search::scatter_svg(words[0], words[1], words.size() > 2 ? words[2] : "",
                             std::move(points));
}

/// The results and those beside them; empty when something was complained of.
std::vector<search::StoredResults> read_all(const ArchiveOptions& options, const App& app) {
  std::vector<std::string> paths{options.results};
  paths.insert(paths.end(), options.beside.begin(), options.beside.end());
  std::vector<search::StoredResults> all;
  for (const std::string& path : paths) {
    std::string error;
    auto results = search::read_results(path, kAllFinds, error);
    if (!results) {
      app.complain(printable(error));
      return {};
    }
    all.push_back(std::move(*results));
  }
  return all;
}

std::string picture(const std::vector<PlacedBrick>& bricks, const search::Genome& genome) {
  const Structure structure(genome.lattice, bricks);
  PictureOptions options;
  options.format = PictureFormat::svg;
  options.palette = Palette::okabe_ito;
  options.floor = genome.floor;
  options.legend = false;
  const std::string svg = draw_structure(structure, numbered_bricks(genome.colours), options);
  return "<img alt=\"\" src=\"data:image/svg+xml;base64," + base64(svg) + "\"/>";
}

/// "mutated from 1885, crossed from 1203 and 77, drawn".
std::string lineage(const std::string& path, search::StoredFind find) {
  std::string text;
  for (int i = 0; i < kMostAncestors; ++i) {
    text += find.origin;
    if (!find.parent) return text;
    text += fmt::format(" from {}", *find.parent);
    if (find.other_parent) text += fmt::format(" and {}", *find.other_parent);
    std::string error;
    auto parent = search::read_find(path, *find.parent, error);
    // Ids fall from child to parent in every file that a search wrote.
    if (!parent || parent->id >= find.id) return text;
    text += ", ";
    find = std::move(*parent);
  }
  return text + "…";
}

std::string find_section(const std::string& path, const search::StoredFind& find) {
  std::string error;
  const auto bricks = search::read_bricks(path, find.structure, error);
  std::string out = fmt::format("<section><h2>{}</h2>\n", find.id);
  out += bricks ? picture(*bricks, find.genome) : "<p>" + escaped_markup(printable(error)) + "</p>";
  out += fmt::format("\n<p>score {:.6g}; built {} times; {}</p>\n<table>\n", find.score, find.times,
                     escaped_markup(printable(lineage(path, find))));
  for (std::size_t k = 0; k < find.values.size(); ++k) {
    out += fmt::format("<tr><td>{}</td><td>{:.6g}</td></tr>\n", search::objectives()[k].name,
                       find.values[k]);
  }
  return out + "</table></section>\n";
}

constexpr std::string_view kHead = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8"/>
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'; img-src data:; base-uri 'none'; form-action 'none'"/>
<meta name="viewport" content="width=device-width, initial-scale=1"/>
<title>{0}</title>
<style>
body {{ font: 15px/1.45 sans-serif; max-width: 70em; margin: 2em auto; padding: 0 1em }}
section {{ display: inline-block; vertical-align: top; width: 20em; margin: .5em }}
section img {{ width: 100%; border: 1px solid #ddd }}
td {{ padding: 0 .7em }}
td + td {{ text-align: right }}
svg {{ max-width: 100%; height: auto }}
</style>
</head>
<body>
<h1>{0}</h1>
<p>{1} evaluations, {2} structures; content {3:016x}</p>
)";

}  // namespace

std::string plot_problem(const std::string& names) {
  const std::vector<std::string> words = split(names);
  if (is_curve(words)) return {};
  if (words.size() > 3) return "at most three names, parted by commas, make a figure";
  for (const std::string& word : words) {
    if (!is_measure(word)) {
      return fmt::format(
          "{} is no objective, nor score, times or id; over 'evaluated' go best, mean and "
          "structures",
          in_quotes(word));
    }
  }
  return {};
}

int write_plot(const ArchiveOptions& options, const App& app) {
  const auto all = read_all(options, app);
  if (all.empty()) return kFailed;
  return write_output(*options.output, figure(all, split(*options.plot)), app);
}

int write_gallery(const ArchiveOptions& options, const App& app) {
  auto all = read_all(options, app);
  if (all.empty()) return kFailed;
  const search::StoredResults& own = all.front();
  std::string page = fmt::format(fmt::runtime(kHead), escaped_markup(printable(own.name)),
                                 own.evaluated, own.structures, own.content);
  page += figure(all, {"evaluated", "best"}) + figure(all, {"evaluated", "mean"});
  page += figure(all, {"score"}) + figure(all, {"bricks", "score"}) + "\n";
  const std::size_t shown = std::min(own.finds.size(), static_cast<std::size_t>(options.top));
  for (std::size_t i = 0; i < shown; ++i) page += find_section(options.results, own.finds[i]);
  return write_output(*options.gallery, page + "</body>\n</html>\n", app);
}

}  // namespace stig::cli
