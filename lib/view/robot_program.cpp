// SPDX-License-Identifier: MIT
// A trace has the programs that ran, and nothing of what they were compiled from. The text is read
// as the compiler lays it out, line by line; of another layout nothing is found, and nothing shown.
#include "view/robot_program.h"

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/text.h"

namespace stig::view {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kDecides = "local function decide(column)", kEndsDecides = "end";
constexpr std::string_view kChart = "local CHART = {", kEndsChart = "}";

std::vector<std::string_view> lines_of_program(std::string_view text) {
  std::vector<std::string_view> out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    out.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

/// What stands between the next two quotes from a place on, and the place behind them.
std::string_view quoted(std::string_view line, std::size_t& at) {
  const std::size_t begin = line.find('\'', at);
  const std::size_t end = begin == std::string_view::npos ? begin : line.find('\'', begin + 1);
  if (end == std::string_view::npos) {
    at = end;
    return {};
  }
  at = end + 1;
  return line.substr(begin + 1, end - begin - 1);
}

/// "on = { found = 'a', none = 'b' }": each event with where it leads.
Json leads(std::string_view line) {
  Json out = Json::array();
  std::size_t at = line.find('{');
  while (at < line.size()) {
    const std::size_t name = line.find_first_not_of("{, ", at);
    const std::size_t equals = line.find(" = ", at);
    if (equals == std::string_view::npos || name >= equals) break;
    const std::string event = printable(line.substr(name, equals - name));
    at = equals;
    const std::string_view state = quoted(line, at);
    if (!state.empty()) out.push_back({event, printable(state)});
  }
  return out;
}

/// One line of the chart: a state begins, or what it leads to.
void add_chart_line(std::string_view line, Json& chart) {
  const std::size_t text = std::min(line.find_first_not_of(' '), line.size());
  line.remove_prefix(text);
  std::size_t at = 0;
  if (line.starts_with("['")) {
    const std::string state = printable(quoted(line, at));
    chart.push_back(
        {{"state", state}, {"does", printable(quoted(line, at))}, {"to", Json::array()}});
  } else if (line.starts_with("on = ") && !chart.empty()) {
    chart.back()["to"] = leads(line);
  }
}

}  // namespace

Json program_json(std::string_view text) {
  Json chart = Json::array();
  std::string decides;
  std::size_t first = 0;
  enum class Within { neither, decisions, states } within = Within::neither;
  const std::vector<std::string_view> lines = lines_of_program(text);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string_view line = lines[i];
    if (within == Within::neither && line == kDecides && decides.empty()) {
      within = Within::decisions;
      first = i + 1;
    }
    if (within == Within::decisions) decides += printable(line) + "\n";
    if (within == Within::states) add_chart_line(line, chart);
    if (within == Within::neither && line == kChart && chart.empty()) within = Within::states;
    const bool ends = (within == Within::decisions && line == kEndsDecides) ||
                      (within == Within::states && line == kEndsChart);
    if (ends) within = Within::neither;
  }
  return {{"chart", chart}, {"decides", {{"line", first}, {"text", decides}}}};
}

}  // namespace stig::view
