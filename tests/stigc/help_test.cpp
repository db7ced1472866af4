// SPDX-License-Identifier: MIT
// The examples of every --help run as they stand, one after the other, from any folder.
#include <doctest/doctest.h>

#include <cctype>
#include <filesystem>
#include <sstream>

#include "program.h"
#include "support/golden.h"
#include "support/uses.h"

namespace stig {
namespace {

/// The indented lines after a heading, up to the next empty line.
std::vector<std::string> lines_under(const std::string& heading, const std::string& text) {
  std::vector<std::string> lines;
  const std::size_t at = text.find("\n" + heading + "\n");
  REQUIRE_MESSAGE(at != std::string::npos, text);
  std::istringstream rest(text.substr(at + heading.size() + 2));
  for (std::string line; std::getline(rest, line) && line.starts_with("  ");) {
    lines.push_back(line);
  }
  return lines;
}

/// The exit status that an example's comment promises, else 0.
int promised(const std::string& example) {
  const std::string promise = "# exit status ";
  const std::size_t at = example.find(promise);
  return at == std::string::npos ? 0 : std::stoi(example.substr(at + promise.size()));
}

/// The names of the commands, "" for the program's own help.
std::vector<std::string> commands() {
  std::vector<std::string> names{""};
  const Workplace place;
  for (const std::string& line : lines_under("Commands:", place.stigc({"--help"}).out)) {
    std::string name;
    std::istringstream(line) >> name;
    // Lines that go on with what the command above does are indented further.
    if (line.find_first_not_of(' ') == 2) names.push_back(name);
  }
  return names;
}

/// Pages take a template, which a build without node does not have.
bool has_viewer() {
  return std::filesystem::exists(std::filesystem::path(STIGC_PROGRAM).parent_path() /
                                 "viewer/viewer.html");
}

/// Meshes take CGAL.
bool has_meshes() {
  return std::filesystem::exists(std::filesystem::path(STIGC_PROGRAM).parent_path() / "stigc-mesh");
}

TEST_CASE("the examples of every help run as they stand in an empty folder") {
  for (const std::string& command : commands()) {
    if (command == "view" && !has_viewer()) continue;
    if ((command == "voxelise" || command == "convex") && !has_meshes()) continue;
    const Workplace place;
    std::filesystem::remove(place.path("sets"));
    const std::vector<std::string> examples =
        lines_under("Examples:", place.shell("stigc " + command + " --help").out);
    CHECK(!examples.empty());
    for (const std::string& example : examples) {
      CAPTURE(example);
      const Outcome outcome = place.shell("export HOME=\"$PWD\"; " + example);
      CHECK_MESSAGE(outcome.exit_code == promised(example), outcome.err);
    }
  }
}

/// A command's own options but --help, each with all of its names: "-o", "--output".
std::vector<std::vector<std::string>> options_of(const std::string& help) {
  std::vector<std::vector<std::string>> out;
  if (help.find("\nOptions:\n") == std::string::npos) return out;
  for (const std::string& line : lines_under("Options:", help)) {
    // What goes on with the option above is indented further.
    if (line[2] != '-') continue;
    std::vector<std::string>& names = out.emplace_back();
    std::istringstream words(line);
    for (std::string word; words >> word && word[0] == '-';) {
      const bool more = word.back() == ',';
      names.push_back(word.substr(0, word.size() - (more ? 1 : 0)));
      if (!more) break;
    }
    if (names.back() == "--help") out.pop_back();
  }
  return out;
}

/// Whether the text has one of an option's names, whole.
bool names_option(const std::string& text, const std::vector<std::string>& names) {
  const auto part = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '-'; };
  for (const std::string& name : names) {
    for (auto at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
      const std::size_t end = at + name.size();
      if ((at == 0 || !part(text[at - 1])) && (end == text.size() || !part(text[end]))) return true;
    }
  }
  return false;
}

/// All files of a folder with this ending, one after the other.
std::string texts_of(const std::string& folder, const std::string& ending) {
  std::string out;
  for (const auto& entry : std::filesystem::directory_iterator(STIG_SOURCE_DIR "/" + folder)) {
    if (entry.path().extension() != ending) continue;
    out += project_file(folder + "/" + entry.path().filename().string());
  }
  return out;
}

TEST_CASE("every command has a row in the table of the README") {
  const std::string page = project_file("README.md");
  for (const std::string& command : commands()) {
    if (command.empty()) continue;
    CAPTURE(command);
    CHECK((page.find("`" + command + " ") != std::string::npos ||
           page.find("`" + command + "`") != std::string::npos));
  }
}

TEST_CASE("every option of a command stands in the documentation, and is tried") {
  const std::string pages = texts_of("docs", ".md") + project_file("README.md");
  const std::string tests = texts_of("tests/stigc", ".cpp");
  const Workplace place;
  for (const std::string& command : commands()) {
    if (command.empty()) continue;
    CAPTURE(command);
    const std::string help = place.stigc({command, "--help"}).out;
    // The examples are run above.
    const std::string tried = tests + help.substr(help.find("\nExamples:\n"));
    for (const std::vector<std::string>& names : options_of(help)) {
      CAPTURE(names.back());
      CHECK(names_option(pages, names));
      CHECK(names_option(tried, names));
    }
  }
}

TEST_CASE("a shipped file is found by its name, and a file of one's own comes first") {
  const Workplace place;
  const Outcome shipped = place.stigc({"check", "rulesets/staircase.yaml"});
  CHECK(shipped.exit_code == 0);
  CHECK(shipped.err.starts_with("reading /"));
  CHECK(shipped.err.ends_with("/rulesets/staircase.yaml, which came with the program\n"));
  CHECK(place.stigc({"check", "-q", "./rulesets/staircase.yaml"}).exit_code == 1);
  for (const std::string none : {"rulesets/none.yaml", "rulesets/../README.md", "docs/README.md",
                                 "rulesets", "scenes/faults", "staircase.yaml"}) {
    CAPTURE(none);
    const Outcome outcome = place.stigc({"check", none});
    CHECK(outcome.exit_code == 1);
    CHECK(outcome.err.find("came with") == std::string::npos);
  }
  std::filesystem::create_directory(place.path("rulesets"));
  place.write("rulesets/staircase.yaml", place.file("sets/line.yaml"));
  const Outcome own = place.stigc({"check", "rulesets/staircase.yaml"});
  CHECK(own.exit_code == 0);
  CHECK(own.err.empty());
}

TEST_CASE("a file that came with the program is never written") {
  const Workplace place;
  const Outcome in_place = place.stigc({"fmt", "--write", "rulesets/staircase.yaml"});
  CHECK(in_place.exit_code == 1);
  CHECK(in_place.err.find("No such file or directory") != std::string::npos);
  const Outcome output = place.shell(
      "stigc explore rulesets/staircase.yaml --trace rulesets/staircase.yaml > /dev/null");
  CHECK(output.exit_code == 3);
  CHECK(place.files().empty());
}

}  // namespace
}  // namespace stig
