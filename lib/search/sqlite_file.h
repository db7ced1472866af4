// SPDX-License-Identifier: MIT
// SQLite's C interface with errors as exceptions and handles that close themselves. Private to this
// folder: nothing of it is thrown out of it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "search/uses.h"

struct sqlite3;
struct sqlite3_stmt;

namespace stig::search {

/// What SQLite said, or what is wrong with a file.
struct SqliteFailure {
  std::string text;
};

class SqliteFile {
 public:
  /// As a path: a file in memory, which goes when it is closed.
  static constexpr const char* kInMemory = ":memory:";
  enum class Use : std::uint8_t { read, write_or_create };
  SqliteFile(const std::string& path, Use use);
  ~SqliteFile();
  SqliteFile(const SqliteFile&) = delete;
  SqliteFile& operator=(const SqliteFile&) = delete;

  sqlite3* handle() const { return file_; }
  /// Statements without values, parted by semicolons.
  void run(const std::string& sql);
  /// Rows that the last statement changed.
  int changes() const;
  /// What the file holds, byte by byte, wherever it is.
  std::string bytes() const;

 private:
  sqlite3* file_ = nullptr;
};

class SqliteStatement {
 public:
  SqliteStatement(SqliteFile& file, const std::string& sql);
  ~SqliteStatement();
  SqliteStatement(const SqliteStatement&) = delete;
  SqliteStatement& operator=(const SqliteStatement&) = delete;

  /// The next value, for the next question mark.
  SqliteStatement& bind(double value);
  SqliteStatement& bind(std::uint64_t value);
  SqliteStatement& bind(const std::optional<std::uint64_t>& value);
  SqliteStatement& bind(std::string_view value);
  /// Another row?
  bool step();
  /// For the next row of values.
  void again();

  double number(int column) const;
  std::uint64_t integer(int column) const;
  std::optional<std::uint64_t> integer_if_any(int column) const;
  std::string text(int column) const;
  /// Binds a row's values as they are, numbers or text; a row has `columns` of them.
  SqliteStatement& bind_row(const SqliteStatement& row, int columns);

 private:
  [[noreturn]] void fail() const;
  SqliteStatement& checked(int code);

  sqlite3* file_;
  sqlite3_stmt* it_ = nullptr;
  int bound_ = 0;
};

/// Undone unless it is committed. All that is read in one is of the same moment, whoever else
/// writes meanwhile.
class SqliteTransaction {
 public:
  enum class Use : std::uint8_t { read, write };
  SqliteTransaction(SqliteFile& file, Use use) : file_(file) {
    file_.run(use == Use::write ? "BEGIN IMMEDIATE" : "BEGIN");
  }
  ~SqliteTransaction();
  SqliteTransaction(const SqliteTransaction&) = delete;
  SqliteTransaction& operator=(const SqliteTransaction&) = delete;
  void commit();

 private:
  SqliteFile& file_;
  bool done_ = false;
};

}  // namespace stig::search
