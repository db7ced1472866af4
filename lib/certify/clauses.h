// SPDX-License-Identifier: MIT
// Reading formulas (DIMACS CNF) and proofs (DRAT), clause by clause.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "certify/uses.h"

namespace stig::certify {

/// Variable v >= 1 is the literals 2v and, negated, 2v + 1.
using Literal = std::uint32_t;
constexpr Literal negated(Literal literal) { return literal ^ 1U; }
using Literals = std::vector<Literal>;

/// The next clause, the end, or a text that is wrong.
enum class Read : std::uint8_t { clause, end, error };

/// Clauses of a CNF text. Comments may stand before and between clauses.
class CnfReader {
 public:
  /// Reads the header; `variables` is 0 and `problem` set when there is none.
  explicit CnfReader(std::string_view text);
  Read next(Literals& clause);

  std::uint64_t variables = 0, clauses = 0;  ///< as the header says
  std::string problem;

 private:
  Read fail(std::string what);
  void skip_blanks_and_comments();

  std::string_view text_;
  std::size_t at_ = 0;
  std::uint64_t read_ = 0;
};

/// Steps of a proof, text or binary: a byte that no text proof has makes it binary.
class DratReader {
 public:
  DratReader(std::string_view proof, std::uint64_t variables);
  /// `deletes`: the clause is taken away, not added.
  Read next(Literals& clause, bool& deletes);

  std::string problem;

 private:
  Read next_in_text(Literals& clause, bool& deletes);
  Read next_in_binary(Literals& clause, bool& deletes);
  bool binary_number(std::uint64_t& number);
  Read fail(std::string what);

  std::string_view proof_;
  std::uint64_t variables_;
  bool binary_;
  std::size_t at_ = 0;
};

}  // namespace stig::certify
