// SPDX-License-Identifier: MIT
#include "search/sqlite_file.h"

#include <sqlite3.h>
#include <unistd.h>

#include <filesystem>

namespace stig::search {
namespace {

/// So long a second writer or a reader is waited for.
constexpr int kPatienceMs = 10'000;

/// Readers share their state in a file beside the journal. Where no file can be made, and no
/// journal says that somebody is at work, what is read stays as it is.
bool is_at_rest(const std::string& path) {
  std::error_code ignored;
  const std::string folder = std::filesystem::absolute(path, ignored).parent_path().string();
  return access(folder.c_str(), W_OK) != 0 && !std::filesystem::exists(path + "-wal", ignored);
}

/// A name that SQLite takes for one that does not change; bytes that have a meaning in it are
/// written as numbers.
std::string unchanging(const std::string& path) {
  constexpr char kDigits[] = "0123456789ABCDEF";
  std::error_code ignored;
  std::string name = "file://";
  for (const char c : std::filesystem::absolute(path, ignored).string()) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '%' || c == '?' || c == '#') {
      name += {'%', kDigits[byte / 16], kDigits[byte % 16]};
    } else {
      name += c;
    }
  }
  return name + "?immutable=1";
}

}  // namespace

SqliteFile::SqliteFile(const std::string& path, Use use) {
  // Who may write takes the journal away when done. Where that is not allowed SQLite opens the file
  // for reading by itself.
  const bool at_rest = use == Use::read && is_at_rest(path);
  const int flags = at_rest            ? SQLITE_OPEN_READONLY | SQLITE_OPEN_URI
                    : use == Use::read ? SQLITE_OPEN_READWRITE
                                       : SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
  const std::string name = at_rest ? unchanging(path) : path;
  const int code = sqlite3_open_v2(name.c_str(), &file_, flags, nullptr);
  if (code != SQLITE_OK) {
    const std::string why = file_ ? sqlite3_errmsg(file_) : sqlite3_errstr(code);
    sqlite3_close(file_);
    throw SqliteFailure{why};
  }
  sqlite3_busy_timeout(file_, kPatienceMs);
}

SqliteFile::~SqliteFile() { sqlite3_close(file_); }

void SqliteFile::run(const std::string& sql) {
  if (sqlite3_exec(file_, sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) {
    throw SqliteFailure{sqlite3_errmsg(file_)};
  }
}

std::string SqliteFile::bytes() const {
  sqlite3_int64 size = 0;
  unsigned char* const bytes = sqlite3_serialize(file_, "main", &size, 0);
  if (bytes == nullptr) throw SqliteFailure{"there is not memory enough for it"};
  std::string out(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size));
  sqlite3_free(bytes);
  return out;
}

int SqliteFile::changes() const { return sqlite3_changes(file_); }

SqliteStatement::SqliteStatement(SqliteFile& file, const std::string& sql) : file_(file.handle()) {
  if (sqlite3_prepare_v2(file_, sql.c_str(), -1, &it_, nullptr) != SQLITE_OK) fail();
}

SqliteStatement::~SqliteStatement() { sqlite3_finalize(it_); }

void SqliteStatement::fail() const { throw SqliteFailure{sqlite3_errmsg(file_)}; }

SqliteStatement& SqliteStatement::checked(int code) {
  if (code != SQLITE_OK) fail();
  return *this;
}

SqliteStatement& SqliteStatement::bind(double value) {
  return checked(sqlite3_bind_double(it_, ++bound_, value));
}

SqliteStatement& SqliteStatement::bind(std::uint64_t value) {
  return checked(sqlite3_bind_int64(it_, ++bound_, static_cast<sqlite3_int64>(value)));
}

SqliteStatement& SqliteStatement::bind(const std::optional<std::uint64_t>& value) {
  return value ? bind(*value) : checked(sqlite3_bind_null(it_, ++bound_));
}

SqliteStatement& SqliteStatement::bind(std::string_view value) {
  return checked(sqlite3_bind_text64(it_, ++bound_, value.data(), value.size(), SQLITE_TRANSIENT,
                                     SQLITE_UTF8));
}

bool SqliteStatement::step() {
  const int code = sqlite3_step(it_);
  if (code != SQLITE_ROW && code != SQLITE_DONE) fail();
  return code == SQLITE_ROW;
}

void SqliteStatement::again() {
  sqlite3_reset(it_);
  bound_ = 0;
}

double SqliteStatement::number(int column) const { return sqlite3_column_double(it_, column); }

std::uint64_t SqliteStatement::integer(int column) const {
  return static_cast<std::uint64_t>(sqlite3_column_int64(it_, column));
}

std::optional<std::uint64_t> SqliteStatement::integer_if_any(int column) const {
  if (sqlite3_column_type(it_, column) == SQLITE_NULL) return std::nullopt;
  return integer(column);
}

std::string SqliteStatement::text(int column) const {
  const auto* bytes = static_cast<const char*>(sqlite3_column_blob(it_, column));
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(it_, column));
  return bytes ? std::string(bytes, size) : std::string();
}

SqliteStatement& SqliteStatement::bind_row(const SqliteStatement& row, int columns) {
  for (int column = 0; column < columns; ++column) {
    checked(sqlite3_bind_value(it_, ++bound_, sqlite3_column_value(row.it_, column)));
  }
  return *this;
}

SqliteTransaction::~SqliteTransaction() {
  // Where this fails as well, SQLite has rolled back by itself.
  if (!done_) sqlite3_exec(file_.handle(), "ROLLBACK", nullptr, nullptr, nullptr);
}

void SqliteTransaction::commit() {
  file_.run("COMMIT");
  done_ = true;
}

}  // namespace stig::search
