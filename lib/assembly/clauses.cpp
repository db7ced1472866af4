// SPDX-License-Identifier: MIT
#include "assembly/clauses.h"

#include <cadical.hpp>
#include <cassert>
#include <cstdio>
#include <cstdlib>

#include "certify/drat.h"

namespace stig::assembly {

void Clauses::add(const std::vector<int>& literals) {
  literals_.insert(literals_.end(), literals.begin(), literals.end());
  literals_.push_back(0);
  ++count_;
}

std::string Clauses::dimacs() const {
  std::string out = "p cnf " + std::to_string(variables_) + ' ' + std::to_string(count_) + '\n';
  for (const int literal : literals_) {
    out += std::to_string(literal);
    out += literal == 0 ? '\n' : ' ';
  }
  return out;
}

Answered Clauses::fulfilled(int most_conflicts) const {
  constexpr int kYes = 10, kNo = 20;  // as IPASIR has it
  char* bytes = nullptr;
  std::size_t size = 0;
  std::FILE* memory = open_memstream(&bytes, &size);
  if (memory == nullptr) return Answered::given_up;
  int result = 0;
  // The braces end the solver before the stream that it writes to is closed.
  {
    CaDiCaL::Solver solver;
    solver.set("quiet", 1);
    solver.set("binary", 0);
    solver.trace_proof(memory, "memory");
    for (const int literal : literals_) solver.add(literal);
    solver.limit("conflicts", most_conflicts);
    result = solver.solve();
    solver.flush_proof_trace();
    solver.close_proof_trace();
  }
  std::fclose(memory);
  const std::string proof(bytes, size);
  std::free(bytes);
  if (result == kYes) return Answered::yes;
  if (result != kNo || !certify::check_drat(dimacs(), proof).refuted) return Answered::given_up;
  return Answered::no;
}

}  // namespace stig::assembly
