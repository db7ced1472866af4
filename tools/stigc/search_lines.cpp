// SPDX-License-Identifier: MIT
#include "search_lines.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace stig::cli {
namespace {

using Json = nlohmann::ordered_json;

std::vector<PlacedBrick> bricks_in(const Json& rows) {
  std::vector<PlacedBrick> bricks;
  for (const Json& row : rows) {
    bricks.push_back({Cell{row.at(0), row.at(1), row.at(2)}, row.at(3)});
  }
  return bricks;
}

Json measured_json(const search::Individual& one) {
  Json json{{"id", one.id},       {"structure", one.structure}, {"values", one.values},
            {"score", one.score}, {"problem", one.problem},     {"bricks", Json::array()}};
  for (const PlacedBrick& b : one.bricks) {
    json["bricks"].push_back({b.at.x, b.at.y, b.at.z, b.brick});
  }
  return json;
}

/// Throws where the object is no candidate's.
void take_measured(const Json& json, search::Individual& one) {
  one.structure = json.at("structure");
  one.values = json.at("values").get<std::vector<double>>();
  one.score = json.at("score");
  one.problem = json.at("problem");
  one.bricks = bricks_in(json.at("bricks"));
}

}  // namespace

std::vector<std::string> candidate_lines(const std::vector<search::Individual>& made) {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < made.size(); i += kCandidatesOfLine) {
    Json line = Json::array();
    for (std::size_t k = i; k < std::min(made.size(), i + kCandidatesOfLine); ++k) {
      line.push_back({{"id", made[k].id}, {"genome", genome_text(made[k].genome)}});
    }
    lines.push_back(line.dump());
  }
  return lines;
}

std::vector<search::Individual> read_candidate_line(const std::string& line) {
  std::vector<search::Individual> out;
  for (const Json& json : Json::parse(line, nullptr, false)) {
    if (!json.is_object()) return {};
    auto genome = search::read_genome(json.value("genome", ""));
    if (!genome) return {};
    out.emplace_back();
    out.back().id = json.value("id", std::uint64_t{0});
    out.back().genome = std::move(*genome);
  }
  return out;
}

std::string measured_line(const std::vector<search::Individual>& measured) {
  Json line = Json::array();
  for (const search::Individual& one : measured) line.push_back(measured_json(one));
  return line.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::optional<std::size_t> read_measured_line(const std::string& line,
                                              std::vector<search::Individual>& made) {
  try {
    const Json all = Json::parse(line);
    for (const Json& json : all) {
      const std::uint64_t id = json.at("id");
      if (made.empty() || id < made.front().id || id - made.front().id >= made.size()) {
        return std::nullopt;
      }
      take_measured(json, made[id - made.front().id]);
    }
    return all.size();
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

}  // namespace stig::cli
