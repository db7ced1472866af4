// SPDX-License-Identifier: MIT
// The results of a search as one SQLite file, which other programs read as it is.
//
// A batch is one transaction: a search that is killed, or whose disk is full, has lost what it was
// at work on and nothing that it had reported. Journals are written ahead (WAL), so that others may
// read while a search goes on. docs/search.md has the tables.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "search/search_run.h"
#include "search/uses.h"

namespace stig::search {

class ResultFile {
 public:
  ~ResultFile();
  ResultFile(ResultFile&&) noexcept;
  ResultFile& operator=(ResultFile&&) noexcept;

  /// Opens the results of this plan to go on with, or makes an empty file; `state` is as far as the
  /// file says. Nothing with `error` set: the file holds another plan, no results, or cannot be
  /// read or written.
  static std::optional<ResultFile> go_on(const std::string& path, const SearchPlan& plan,
                                         SearchState& state, std::string& error);
  /// Adds a batch that is in the state's archive; false with `error` set. Fails where another
  /// search has written to the file meanwhile.
  bool add(const SearchBatch& batch, const FindArchive& archive, std::string& error);

 private:
  struct Connection;
  explicit ResultFile(std::unique_ptr<Connection> connection);
  std::unique_ptr<Connection> connection_;
};

/// A find as the file has it.
struct StoredFind {
  std::uint64_t id = 0;
  std::string origin;
  std::optional<std::uint64_t> parent, other_parent;
  double score = 0;
  std::uint64_t structure = 0, times = 0;
  std::vector<double> values;  ///< of objectives(), by their numbers
  Genome genome;
};

struct StoredBatch {
  std::uint64_t evaluated = 0, structures = 0;  ///< at its end
  double best = 0, mean = 0, deviation = 0;     ///< of its scores
};

/// What a file of results holds, for those who look at it: nothing is written.
struct StoredResults {
  std::string name;        ///< of the plan
  std::uint64_t plan = 0;  ///< plan_hash
  std::uint64_t evaluated = 0, structures = 0, kept = 0;
  std::uint64_t content = 0;      ///< FindArchive::content_hash
  std::vector<StoredFind> finds;  ///< the best of each structure, by falling score
  std::vector<StoredBatch> batches;
};
/// With `most` finds at most. Nothing with `error` set.
std::optional<StoredResults> read_results(const std::string& path, std::size_t most,
                                          std::string& error);
/// An individual by its number. Nothing with `error` set.
std::optional<StoredFind> read_find(const std::string& path, std::uint64_t id, std::string& error);
/// The bricks of a structure by its hash, in the order of cells. Nothing with `error` set.
std::optional<std::vector<PlacedBrick>> read_bricks(const std::string& path,
                                                    std::uint64_t structure, std::string& error);

}  // namespace stig::search
