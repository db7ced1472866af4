// SPDX-License-Identifier: MIT
// A CSV has a column for each plain value that any record has, in the order in which they are met:
// so the records are gone through twice, and never all in memory.
#include "sweep_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <unordered_map>

#include "base/file_io.h"
#include "base/hash.h"
#include "base/text.h"
#include "outputs.h"
#include "report.h"

namespace stig::cli {
namespace {

std::string plain_text(const Json& value) {
  if (value.is_null()) return "";
  return value.is_string() ? value.get<std::string>() : value.dump();
}

/// Calls with every plain value and its name: "result.measures.cavities". A list of plain values
/// is one, parted by blanks; a list of one object is that object; other lists have no place in a
/// table.
void each_value(const std::string& name, const Json& json,
                const std::function<void(const std::string&, const std::string&)>& each) {
  if (json.is_object()) {
    for (const auto& [key, value] : json.items()) {
      each_value(name.empty() ? key : name + "." + key, value, each);
    }
  } else if (!json.is_array()) {
    each(name, plain_text(json));
  } else if (json.size() == 1 && json[0].is_object()) {
    each_value(name, json[0], each);
  } else if (std::none_of(json.begin(), json.end(),
                          [](const Json& one) { return one.is_structured(); })) {
    std::string text;
    for (const Json& one : json) text += (text.empty() ? "" : " ") + plain_text(one);
    each(name, text);
  }
}

std::string csv_row(const std::vector<std::string>& cells) {
  std::string out;
  for (std::size_t i = 0; i < cells.size(); ++i) out += (i > 0 ? "," : "") + csv_field(cells[i]);
  return out + "\n";
}

bool write_csv(GrowingFile& file, const EachRecord& records, FileError& error) {
  std::vector<std::string> columns;
  std::unordered_map<std::string, std::size_t> places;
  const bool read = records([&](std::string_view line) {
    each_value("", Json::parse(line, nullptr, false),
               [&](const std::string& name, const std::string&) {
                 if (places.emplace(name, columns.size()).second) columns.push_back(name);
               });
    return true;
  });
  if (!read || !file.append(csv_row(columns), error)) return false;
  return records([&](std::string_view line) {
    std::vector<std::string> cells(columns.size());
    each_value(
        "", Json::parse(line, nullptr, false),
        [&](const std::string& name, const std::string& text) { cells[places.at(name)] = text; });
    return file.append(csv_row(cells), error);
  });
}

bool write_lines(GrowingFile& file, const EachRecord& records, FileError& error) {
  return records(
      [&](std::string_view line) { return file.append(std::string(line) + "\n", error); });
}

}  // namespace

int check_tables(const std::vector<std::string>& paths, const std::vector<std::string>& others,
                 const App& app) {
  for (const std::string& path : paths) {
    if (path.ends_with(".jsonl") || path.ends_with(".csv")) continue;
    app.complain(fmt::format("'{}': records are .jsonl or .csv", printable(path)));
    return kUsage;
  }
  std::vector<std::string> all = paths;
  all.insert(all.end(), others.begin(), others.end());
  return check_outputs(all, app);
}

TablesWritten write_tables(const std::vector<std::string>& paths, const EachRecord& records,
                           const App& app) {
  TablesWritten written;
  written.hash = hash_text("records");
  const bool read = records([&](std::string_view line) {
    ++written.records;
    written.hash = combine(written.hash, hash_text(line));
    return true;
  });
  if (!read) written.code = kRunFailed;
  for (const std::string& path : paths) {
    GrowingFile file;
    FileError error;
    const bool good = file.open(path, error) &&
                      (path.ends_with(".csv") ? write_csv(file, records, error)
                                              : write_lines(file, records, error)) &&
                      file.commit(error);
    if (good) {
      app.say("wrote " + printable(path));
    } else {
      if (!error.message.empty()) app.complain(error.message);
      written.code = kRunFailed;
    }
  }
  return written;
}

std::string study_summary(const TablesWritten& written, std::uint64_t items, bool json) {
  if (json) {
    return dump(
        Json{{"items", items}, {"done", written.records}, {"content_hash", to_hex(written.hash)}});
  }
  return line("items", fmt::format("{} of {} done", written.records, items)) +
         line("content", to_hex(written.hash));
}

}  // namespace stig::cli
