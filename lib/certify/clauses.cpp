// SPDX-License-Identifier: MIT
// The readers of DIMACS CNF and of DRAT proofs. Both are hostile input and can be large, so
// they go through the text once, clause by clause, and copy no more than one clause.
// Solvers differ in how they lay out lines; therefore a clause ends at its 0 and not at the
// end of its line, as the DIMACS description says.
#include "certify/clauses.h"

#include <fmt/format.h>

#include <charconv>

namespace stig::certify {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

void skip_blanks(std::string_view text, std::size_t& at) {
  while (at < text.size() && is_blank(text[at])) ++at;
}

/// A number that ends at a blank or at the end; false: there is none.
bool read_number(std::string_view text, std::size_t& at, std::int64_t& number) {
  skip_blanks(text, at);
  const char* begin = text.data() + at;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(begin, end, number);
  if (error != std::errc{} || (stop != end && !is_blank(*stop))) return false;
  at = static_cast<std::size_t>(stop - text.data());
  return true;
}

/// Zero ends a clause; none stands for a malformed or too large number.
enum class Number : std::uint8_t { literal, zero, none };

/// One number of a clause.
Number read_literal(std::string_view text, std::size_t& at, std::uint64_t variables,
                    Literals& clause) {
  std::int64_t number = 0;
  if (!read_number(text, at, number)) return Number::none;
  if (number == 0) return Number::zero;
  // Negating INT64_MIN as a signed number would be undefined; two's complement of the
  // unsigned number is its magnitude.
  const bool negative = number < 0;
  const std::uint64_t variable =
      negative ? ~static_cast<std::uint64_t>(number) + 1 : static_cast<std::uint64_t>(number);
  // A variable beyond the header's count is refused, and not added: the checker's arrays
  // are sized by the header.
  if (variable > variables) return Number::none;
  clause.push_back(static_cast<Literal>(2 * variable + (negative ? 1 : 0)));
  return Number::literal;
}

/// No text proof has other characters than these, and a binary one begins with 'a' or 'd'
/// followed by bytes of numbers. A guess that is wrong can only make a proof malformed:
/// whatever is read as a lemma is checked.
bool is_binary(std::string_view proof) {
  return proof.find_first_not_of("0123456789- d\t\r\n") != std::string_view::npos;
}

}  // namespace

CnfReader::CnfReader(std::string_view text) : text_(text) {
  skip_blanks_and_comments();
  constexpr std::string_view kHeader = "p cnf ";
  std::int64_t number_of_variables = 0, number_of_clauses = 0;
  const bool header = text_.substr(at_).starts_with(kHeader);
  at_ += header ? kHeader.size() : 0;
  if (!header || !read_number(text_, at_, number_of_variables) ||
      !read_number(text_, at_, number_of_clauses) || number_of_variables < 0 ||
      number_of_clauses < 0) {
    fail("the formula has no line 'p cnf VARIABLES CLAUSES'");
    return;
  }
  // A variable that occurs takes a digit and a blank; so memory is bounded by the text.
  if (static_cast<std::uint64_t>(number_of_variables) > text_.size()) {
    fail("the formula has more variables than its text has room for");
    return;
  }
  variables = static_cast<std::uint64_t>(number_of_variables);
  clauses = static_cast<std::uint64_t>(number_of_clauses);
}

Read CnfReader::fail(std::string what) {
  problem = std::move(what);
  return Read::error;
}

void CnfReader::skip_blanks_and_comments() {
  // Solvers and generators write comments anywhere between clauses; the formulas of
  // synthesis/proof_files.h give each clause's reason so.
  for (skip_blanks(text_, at_); at_ < text_.size() && text_[at_] == 'c'; skip_blanks(text_, at_)) {
    at_ = std::min(text_.find('\n', at_), text_.size());
  }
}

Read CnfReader::next(Literals& clause) {
  clause.clear();
  if (!problem.empty()) return Read::error;
  skip_blanks_and_comments();
  // The header's number of clauses is demanded: a truncated formula has more solutions than
  // the whole one, and its refutation would still be one; but a formula with more clauses
  // than declared points to a file that was put together wrongly.
  if (at_ == text_.size()) {
    if (read_ == clauses) return Read::end;
    return fail(fmt::format("the formula has {} clauses, and its header says {}", read_, clauses));
  }
  ++read_;
  // A comment may stand even within a clause.
  for (;;) {
    skip_blanks_and_comments();
    switch (read_literal(text_, at_, variables, clause)) {
      case Number::zero:
        return Read::clause;
      case Number::none:
        return fail(fmt::format("clause {} of the formula is malformed", read_));
      case Number::literal:
        break;
    }
  }
}

DratReader::DratReader(std::string_view proof, std::uint64_t variables)
    : proof_(proof), variables_(variables), binary_(is_binary(proof)) {}

Read DratReader::next(Literals& clause, bool& deletes) {
  clause.clear();
  return binary_ ? next_in_binary(clause, deletes) : next_in_text(clause, deletes);
}

Read DratReader::fail(std::string what) {
  problem = std::move(what);
  return Read::error;
}

Read DratReader::next_in_text(Literals& clause, bool& deletes) {
  skip_blanks(proof_, at_);
  if (at_ == proof_.size()) return Read::end;
  // In text an added clause has no letter, a deleted one begins with 'd'.
  deletes = proof_[at_] == 'd';
  at_ += deletes ? 1 : 0;
  for (;;) {
    switch (read_literal(proof_, at_, variables_, clause)) {
      case Number::zero:
        return Read::clause;
      case Number::none:
        return fail("is no clause of the formula's variables, ended by 0");
      case Number::literal:
        break;
    }
  }
}

/// Seven bits a byte, the lowest first; the top bit says that more follow.
bool DratReader::binary_number(std::uint64_t& number) {
  number = 0;
  // Five bytes hold the 32 bits of a literal. Longer encodings are refused, which also
  // bounds the shift.
  for (unsigned shift = 0; shift < 35 && at_ < proof_.size(); shift += 7) {
    const auto byte = static_cast<unsigned char>(proof_[at_++]);
    number |= std::uint64_t{byte & 127U} << shift;
    if (byte < 128) return true;
  }
  return false;
}

Read DratReader::next_in_binary(Literals& clause, bool& deletes) {
  if (at_ == proof_.size()) return Read::end;
  const char kind = proof_[at_++];
  if (kind != 'a' && kind != 'd') return fail("neither adds nor deletes a clause");
  deletes = kind == 'd';
  for (;;) {
    std::uint64_t number = 0;
    // A literal is coded as 2v for v and 2v + 1 for its negation, exactly as here, so 1
    // would be the negation of no variable.
    if (!binary_number(number) || number == 1 || number / 2 > variables_) {
      return fail("is no clause of the formula's variables, ended by 0");
    }
    if (number == 0) return Read::clause;
    clause.push_back(static_cast<Literal>(number));
  }
}

}  // namespace stig::certify
