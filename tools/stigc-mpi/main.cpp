// SPDX-License-Identifier: MIT
// stigc-mpi: `stigc sweep` with items done by other processes, on any machines that MPI reaches.
//
//     mpirun -n 8 stigc-mpi sweep studies/coral.yaml -o coral.jsonl
//
// Rank 0 keeps the journal, and lends items: each of the others says what it has done and is given
// about a second's worth of further ones. A record depends on the plan and the item's number alone,
// so it makes no difference who does it, and what a process that was killed had on loan is done
// again by the next such command. All ranks read the same plan.
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
  bool served = false;  ///< rank 0 has dismissed the others; another rank was dismissed
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
void lend(int to, const std::vector<std::uint64_t>& items) {
  MPI_Send(items.data(), static_cast<int>(items.size()), MPI_UINT64_T, to, kLoan, MPI_COMM_WORLD);
}

std::vector<std::string> lines_in(std::string_view text) {
  std::vector<std::string> lines;
  for (std::size_t end = 0; (end = text.find('\n')) != text.npos; text.remove_prefix(end + 1)) {
    lines.emplace_back(text.substr(0, end));
  }
  return lines;
}

/// What rank 0 knows of another: how many items it had last, and since when.
struct Borrower {
  std::size_t items = 0;
  Clock::time_point since;
};

/// So many more that they take about kLoanTime, and that enough is left for the others.
std::size_t loan_size(const Borrower& borrower, std::size_t left, int others) {
  const std::chrono::duration<double> took = Clock::now() - borrower.since;
  double size = 1;
  if (borrower.items > 0) {
    const double pace = kLoanTime / std::max(took.count(), 1e-3);
    size = static_cast<double>(borrower.items) * std::clamp(pace, 0.25, 4.0);
  }
  const auto share = left / static_cast<std::size_t>(2 * others) + 1;
  return std::min({static_cast<std::size_t>(std::max(size, 1.0)), share, left});
}

/// Rank 0's part: until all others are gone.
bool lead(const std::vector<std::uint64_t>& items, const TakeLines& take) {
  rank().served = true;
  std::vector<Borrower> borrowers(static_cast<std::size_t>(rank().all));
  std::size_t next = 0;
  bool good = true;
  for (int there = rank().all - 1; there > 0;) {
    int from = 0;
    const std::vector<std::string> lines = lines_in(receive_report(from));
    if (good && !lines.empty()) good = take(lines);
    Borrower& borrower = borrowers[static_cast<std::size_t>(from)];
    const bool more = good && !stop_requested() && next < items.size();
    const std::size_t size = more ? loan_size(borrower, items.size() - next, rank().all - 1) : 0;
    const auto begin = items.begin() + static_cast<std::ptrdiff_t>(next);
    lend(from, {begin, begin + static_cast<std::ptrdiff_t>(size)});
    borrower = {size, Clock::now()};
    next += size;
    if (size == 0) --there;
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
    MPI_Get_count(&status, MPI_UINT64_T, &size);
    std::vector<std::uint64_t> items(static_cast<std::size_t>(size));
    MPI_Recv(items.data(), size, MPI_UINT64_T, 0, kLoan, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    if (items.empty()) return;
    // A rank is a core, unless somebody says otherwise.
    share_among_threads(items, std::max(threads, 1), work, [&](const auto& lines) {
      for (const std::string& line : lines) report += line + "\n";
      return true;
    });
  }
}

bool share_among_ranks(const std::vector<std::uint64_t>& items, int threads, const DoItem& work,
                       const TakeLines& take) {
  if (rank().own == 0) return lead(items, take);
  serve(threads, work);
  return true;
}

/// Where the command ended before anything was lent, the others wait all the same.
void part() {
  if (rank().served || rank().all == 1) return;
  if (rank().own == 0) {
    lead({}, {});
  } else {
    serve(1, {});
  }
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
  if (argc < 2 || std::string_view(argv[1]) != "sweep") {
    if (rank().own == 0) std::fputs("stigc-mpi: what it does is sweep PLAN\n", stderr);
  } else {
    if (rank().all > 1) workforce() = {share_among_ranks, rank().own == 0};
    if (rank().own > 0) words.push_back("--quiet");
    code = run_main(static_cast<int>(words.size()), words.data());
  }
  part();
  MPI_Finalize();
  return rank().own == 0 ? code : kOk;
}
