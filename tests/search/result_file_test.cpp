// SPDX-License-Identifier: MIT
// Files of results: broken off and gone on with, refused where they must be.
#include <doctest/doctest.h>

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include "search/plans.h"
#include "search/result_file.h"

namespace stig {
namespace {

namespace fs = std::filesystem;

struct Folder {
  Folder() {
    std::string name = (fs::temp_directory_path() / "stig-search-XXXXXX").string();
    REQUIRE(mkdtemp(name.data()) != nullptr);
    path = name;
  }
  ~Folder() { fs::remove_all(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string file(const char* name) const { return (path / name).string(); }
  fs::path path;
};

/// So many batches more, into the file.
void go_on(const std::string& path, const SearchPlan& plan, int batches, int threads) {
  SearchState state(plan);
  std::string error;
  auto file = ResultFile::go_on(path, plan, state, error);
  REQUIRE_MESSAGE(file.has_value(), error);
  for (int b = 0; b < batches; ++b) {
    const auto batch = run_batch(plan, state, threads);
    REQUIRE_MESSAGE(file->add(*batch, state.archive, error), error);
  }
}

}  // namespace

TEST_CASE("a search that is broken off after any batch ends as one that is not") {
  const Folder folder;
  for (const SearchMethod method : kMethods) {
    CAPTURE(to_string(method));
    const SearchPlan plan = small_plan(method);
    const std::string path = folder.file(std::string(to_string(method)).c_str());
    for (const int batches : {1, 0, 2, 2}) go_on(path, plan, batches, 1 + batches % 2);
    std::string error;
    const auto results = read_results(path, 5, error);
    REQUIRE_MESSAGE(results.has_value(), error);
    const SearchState whole = searched(plan, 1);
    CHECK(results->evaluated == 200);
    CHECK(results->content == whole.archive.content_hash());
    CHECK(results->structures == whole.archive.structures());
    CHECK(results->kept == whole.archive.kept().size());
    REQUIRE(results->finds.size() == 5);
    const auto best = whole.archive.best(5);
    for (std::size_t i = 0; i < 5; ++i) {
      const Individual& expected = whole.archive.kept()[best[i]];
      const StoredFind& find = results->finds[i];
      CHECK(find.id == expected.id);
      CHECK(find.genome == expected.genome);
      CHECK(find.values == expected.values);
      CHECK(find.score == expected.score);
      CHECK(find.structure == expected.structure);
      CHECK(find.times == whole.archive.times().at(find.structure));
      CHECK(read_find(path, find.id, error)->genome == expected.genome);
    }
  }
}

TEST_CASE("two searches into one file: the second to write says so, and nothing is lost") {
  const Folder folder;
  const SearchPlan plan = small_plan(SearchMethod::random);
  const std::string path = folder.file("results.sqlite");
  SearchState one(plan), two(plan);
  std::string error;
  auto first = ResultFile::go_on(path, plan, one, error);
  auto second = ResultFile::go_on(path, plan, two, error);
  REQUIRE((first.has_value() && second.has_value()));
  const auto batch = run_batch(plan, one, 1), same = run_batch(plan, two, 1);
  CHECK(first->add(*batch, one.archive, error));
  CHECK_FALSE(second->add(*same, two.archive, error));
  CHECK(error == path + ": another search has written to it meanwhile");
  CHECK(read_results(path, 1, error)->content == one.archive.content_hash());
}

TEST_CASE("what is read while another search writes is of one moment") {
  const Folder folder;
  SearchPlan plan = small_plan(SearchMethod::random);
  plan.evaluations = 4000;
  const std::string path = folder.file("results");
  go_on(path, plan, 1, 1);
  std::atomic<bool> done{false};
  std::thread writer([&] {
    go_on(path, plan, 60, 1);
    done = true;
  });
  // A batch is one transaction: whoever reads has it whole or not at all.
  while (!done) {
    std::string error;
    const auto read = read_results(path, 1, error);
    REQUIRE_MESSAGE(read, error);
    CHECK(read->evaluated == read->batches.back().evaluated);
    CHECK(read->structures == read->batches.back().structures);
  }
  writer.join();
}

TEST_CASE("a file of another plan, of something else or out of reach is refused in words") {
  const Folder folder;
  SearchPlan plan = small_plan(SearchMethod::random);
  const std::string path = folder.file("results.sqlite");
  go_on(path, plan, 1, 1);
  SearchState state(plan);
  std::string error;
  plan.seed = 7;
  CHECK_FALSE(ResultFile::go_on(path, plan, state, error));
  CHECK(error == path + ": its results are of another plan");
  const std::string text = folder.file("text");
  std::ofstream(text) << std::string(4096, 'x');
  CHECK_FALSE(ResultFile::go_on(text, plan, state, error));
  CHECK(error.find("not a database") != std::string::npos);
  CHECK_FALSE(read_results(folder.file("none"), 1, error));
  CHECK(error.find("there is no such file") != std::string::npos);
  CHECK_FALSE(fs::exists(folder.file("none")));
  CHECK_FALSE(ResultFile::go_on(folder.file("none/results"), plan, state, error));
  CHECK_FALSE(read_find(path, 1'000'000, error));
  CHECK(error == path + ": it has no individual 1000000");
}

TEST_CASE("a longer search goes on from a shorter one") {
  const Folder folder;
  SearchPlan plan = small_plan(SearchMethod::genetic);
  const std::string path = folder.file("results.sqlite");
  plan.evaluations = 80;
  go_on(path, plan, 2, 1);
  plan.evaluations = 200;
  go_on(path, plan, 3, 1);
  std::string error;
  CHECK(read_results(path, 1, error)->content == searched(plan, 1).archive.content_hash());
}

}  // namespace stig
