// SPDX-License-Identifier: MIT
// stigc-mpi: `stigc sweep` and `stigc search` with items done by other processes, on any machines
// that MPI reaches.
//
//     mpirun -n 8 stigc-mpi sweep studies/coral.yaml -o coral.jsonl
//
// Rank 0 keeps the journal or the archive, and lends items, a line of text each: each of the others
// says what it has done and is given about a second's worth of further ones. What an item comes to
// depends on the plan and its line alone, so it makes no difference who does it, and what a
// process that was killed had on loan is done again by the next such command. All ranks read the
// same plan. A search lends batch after batch, and the others wait in between.
#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "app.h"
#include "item_work.h"
#include "run_line.h"

namespace stig::cli {
namespace {

constexpr int kReport = 1, kLoan = 2;  // tags of messages
constexpr double kLoanTime = 1;        ///< s, that a loan is to take

using Clock = std::chrono::steady_clock;

struct Rank {
  int own = 0, all = 1;
  bool served = false;  ///< another rank than 0 was dismissed
};
Rank& rank() {
  static Rank one;
  return one;
}

std::string receive_report(int& from) {
  MPI_Status status;
  int size = 0;
  MPI_Probe(MPI_ANY_SOURCE, kReport, MPI_COMM_WORLD, &status);
  from = status.MPI_SOURCE;
  MPI_Get_count(&status, MPI_CHAR, &size);
  std::string text(static_cast<std::size_t>(size), '\0');
  MPI_Recv(text.data(), size, MPI_CHAR, from, kReport, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  return text;
}

/// Nothing: go home.
void lend(int to, const std::string& text) {
  MPI_Send(text.data(), static_cast<int>(text.size()), MPI_CHAR, to, kLoan, MPI_COMM_WORLD);
}

std::vector<std::string> lines_in(std::string_view text) {
  std::vector<std::string> lines;
  for (std::size_t end = 0; (end = text.find('\n')) != text.npos; text.remove_prefix(end + 1)) {
    lines.emplace_back(text.substr(0, end));
  }
  return lines;
}

/// What rank 0 knows of another.
struct Borrower {
  std::size_t items = 0;  ///< that it had last
  Clock::time_point since;
  std::size_t due = 1;   ///< items that take it about kLoanTime
  bool waiting = false;  ///< for a loan
};
std::vector<Borrower>& borrowers() {
  static std::vector<Borrower> all(static_cast<std::size_t>(rank().all));
  return all;
}

/// It has done what it had.
void note_return(Borrower& borrower) {
  const std::chrono::duration<double> took = Clock::now() - borrower.since;
  if (borrower.items > 0) {
    const double pace = std::clamp(kLoanTime / std::max(took.count(), 1e-3), 0.25, 4.0);
    borrower.due =
        static_cast<std::size_t>(std::max(static_cast<double>(borrower.items) * pace, 1.0));
  }
  borrower.items = 0;
  borrower.waiting = true;
}

/// Hands out items in their order, as long as there are any.
class Lender {
 public:
  explicit Lender(const std::vector<std::string>& items) : items_(items) {}

  /// Enough is left for the others.
  void serve(int to) {
    Borrower& borrower = borrowers()[static_cast<std::size_t>(to)];
    const std::size_t left = items_.size() - next_;
    if (left == 0 || !borrower.waiting) return;
    const auto share = left / static_cast<std::size_t>(2 * (rank().all - 1)) + 1;
    const std::size_t size = std::min({borrower.due, share, left});
    std::string text;
    for (std::size_t i = 0; i < size; ++i) text += items_[next_++] + "\n";
    lend(to, text);
    borrower.items = size;
    borrower.since = Clock::now();
    borrower.waiting = false;
  }
  void close() { next_ = items_.size(); }

 private:
  const std::vector<std::string>& items_;
  std::size_t next_ = 0;
};

/// Rank 0's part: until all others wait for more.
bool lead(const std::vector<std::string>& items, const TakeLines& take) {
  Lender lender(items);
  bool good = true;
  for (int to = 1; to < rank().all; ++to) lender.serve(to);
  const auto waits = [](const Borrower& one) { return one.waiting; };
  // Of those that are not waiting each has something on loan, or has not said hello yet.
  while (!std::all_of(borrowers().begin() + 1, borrowers().end(), waits)) {
    int from = 0;
    const std::vector<std::string> lines = lines_in(receive_report(from));
    if (good && !lines.empty()) good = take(lines);
    note_return(borrowers()[static_cast<std::size_t>(from)]);
    if (!good || stop_requested()) lender.close();
    lender.serve(from);
  }
  return good && !stop_requested();
}

/// The others' part: until they are dismissed.
void serve(int threads, const DoItem& work) {
  rank().served = true;
  std::string report;
  while (true) {
    MPI_Send(report.data(), static_cast<int>(report.size()), MPI_CHAR, 0, kReport, MPI_COMM_WORLD);
    report.clear();
    MPI_Status status;
    int size = 0;
    MPI_Probe(0, kLoan, MPI_COMM_WORLD, &status);
    MPI_Get_count(&status, MPI_CHAR, &size);
    std::string loan(static_cast<std::size_t>(size), '\0');
    MPI_Recv(loan.data(), size, MPI_CHAR, 0, kLoan, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    if (loan.empty()) return;
    // A rank is a core, unless somebody says otherwise.
    share_among_threads(lines_in(loan), std::max(threads, 1), work, [&](const auto& lines) {
      for (const std::string& line : lines) report += line + "\n";
      return true;
    });
  }
}

bool share_among_ranks(const std::vector<std::string>& items, int threads, const DoItem& work,
                       const TakeLines& take) {
  if (rank().own == 0) return lead(items, take);
  serve(threads, work);
  return true;
}

/// Dismisses the others. Where the command ended before anything was lent, they wait all the same.
void part() {
  if (rank().all == 1) return;
  if (rank().own > 0) {
    if (!rank().served) serve(1, {});
    return;
  }
  lead({}, {});
  for (int to = 1; to < rank().all; ++to) lend(to, {});
}

}  // namespace
}  // namespace stig::cli

int main(int argc, char** argv) {
  using namespace stig::cli;
  MPI_Init(&argc, &argv);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank().own);
  MPI_Comm_size(MPI_COMM_WORLD, &rank().all);
  std::vector<const char*> words(argv, argv + argc);
  int code = kUsage;
  const std::string_view command = argc < 2 ? "" : argv[1];
  if (command != "sweep" && command != "search") {
    if (rank().own == 0) std::fputs("stigc-mpi: what it does is sweep PLAN, search PLAN\n", stderr);
  } else {
    if (rank().all > 1) workforce() = {share_among_ranks, rank().own == 0, true};
    if (rank().own > 0) words.push_back("--quiet");
    code = run_main(static_cast<int>(words.size()), words.data());
  }
  part();
  MPI_Finalize();
  return rank().own == 0 ? code : kOk;
}
