// SPDX-License-Identifier: MIT
#include "certify/certificate.h"
#include "support/uses.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

namespace stig {
namespace {

const std::string kSmall =
    "stigc-certificate 1\n"
    "rules 0123456789abcdef\n"
    "box -1 0 2 3 4 5 periodic\n"
    "stage 1 order 3\n"
    "0 0 1 2 0\n"
    "1 0 1 2 8\n"
    "2 0 1 1 2000000\n"
    "far 2 1 0\n"
    "window 2 1 4\n"
    "0 2\n"
    "1\n"
    "0 1 3 7\n"
    "stage 2 order 0\n"
    "end 4\n";

std::optional<Certificate> read(const std::string& text) {
  Diagnostics diagnostics;
  auto certificate = read_certificate("small.cert", text, diagnostics);
  CHECK(certificate.has_value() != diagnostics.has_errors());
  return certificate;
}

std::string problem_of(const std::string& text) {
  Diagnostics diagnostics;
  CHECK_FALSE(read_certificate("small.cert", text, diagnostics));
  REQUIRE(diagnostics.all().size() == 1);
  const Diagnostic& d = diagnostics.all().front();
  CHECK(d.code == Code::F470);
  const SourceFile::Position at = d.range.file->position(d.range.begin);
  return std::to_string(at.line) + ":" + std::to_string(at.column) + ": " + d.message;
}

/// kSmall with the first `what` put in place of another text.
std::string with(const std::string& what, const std::string& instead) {
  std::string text = kSmall;
  const std::size_t at = text.find(what);
  REQUIRE(at != std::string::npos);
  return text.replace(at, what.size(), instead);
}

Certificate any_certificate() {
  const auto upto = [](std::uint32_t most) { return *rc::gen::inRange(0U, most + 1); };
  Certificate certificate;
  certificate.rule_set_hash = *rc::gen::arbitrary<std::uint64_t>();
  if (*rc::gen::arbitrary<bool>()) {
    certificate.box = BoxSpec{{1, 2, 3}, Cell{-4, 5, 6}, *rc::gen::arbitrary<bool>()};
  }
  certificate.stages.resize(upto(2));
  for (CertifiedStage& stage : certificate.stages) {
    const std::uint32_t bricks = 1 + upto(80);
    for (std::uint32_t i = 0; i < bricks; ++i) {
      stage.order.push_back({{static_cast<std::int32_t>(i), -7, 1},
                             static_cast<Colour>(1 + upto(61)),
                             upto((1U << kMaxNeighbours) - 1)});
    }
    stage.far.resize(upto(2), {bricks - 1, 0});
    stage.windows.resize(upto(2));
    for (CertifiedWindow& window : stage.windows) {
      for (std::uint32_t i = 0; i < bricks; ++i) {
        (upto(1) == 0 ? window.group : window.context).push_back(i);
      }
      window.fillings.emplace_back((bricks + 63) / 64, 0);
      window.fillings.push_back(window.fillings.back());
      window.fillings.back().back() = 1;
    }
  }
  certificate.bricks = upto(1000);
  return certificate;
}

TEST_CASE("a certificate's text prints back as it was") {
  const auto certificate = read(kSmall);
  REQUIRE(certificate);
  CHECK(certificate->box->origin == Cell{-1, 0, 2});
  CHECK(certificate->stages[0].far.front() == std::vector<std::uint32_t>{2, 1, 0});
  CHECK(certificate->stages[0].windows.front().fillings.back() == Filling{7});
  CHECK(print_certificate(*certificate) == kSmall);
}

TEST_CASE("every certificate reads back as itself") {
  CHECK(rc::check("print and read", [] {
    const Certificate certificate = any_certificate();
    RC_ASSERT(read(print_certificate(certificate)) == certificate);
  }));
}

TEST_CASE("what is malformed is said with its place") {
  CHECK(problem_of("") == "1:1: 'stigc-certificate' belongs here");
  CHECK(problem_of(with("certificate 1", "certificate 2")) ==
        "1:19: a number from 1 to 1 belongs here");
  CHECK(problem_of(with("abcdef", "abcde")) == "2:7: a hexadecimal number of 64 bits belongs here");
  CHECK(problem_of(with("3 4 5", "3 0 5")) == "3:14: a number from 1 to 33554433 belongs here");
  CHECK(problem_of(with("periodic", "round")) == "3:18: 'round' is one word too many");
  CHECK(problem_of(with("order 3", "order 4")) ==
        "8:1: a number from -16777216 to 16777216 belongs here");
  CHECK(problem_of(with("0 0 1 2 0", "0 0 1 63 0")) == "5:7: a number from 1 to 62 belongs here");
  CHECK(problem_of(with("2000000", "4000000")) ==
        "7:9: a hexadecimal number of 26 bits belongs here");
  CHECK(problem_of(with("far 2 1 0", "far 2")) == "8:6: a number from 0 to 2 belongs here");
  CHECK(problem_of(with("far 2 1 0", "far 2 3")) == "8:7: a number from 0 to 2 belongs here");
  CHECK(problem_of(with("0 1 3 7", "0 3 1 7")) == "12:5: fillings rise from one to the next");
  CHECK(problem_of(with("0 1 3 7", "0 1 3 f")) ==
        "12:7: the filling has a brick that its window has not");
  CHECK(problem_of(with("0 1 3 7", "0 1 3 07")) ==
        "12:7: a filling of 1 hexadecimal digits belongs here");
  CHECK(problem_of(with("stage 2", "stage 3")) == "13:7: a number from 2 to 2 belongs here");
  CHECK(problem_of(with("order 3\n", "order 3\r\n")) ==
        "4:1: this line ends in CR LF; a certificate's lines end in LF alone");
  CHECK(problem_of(kSmall + "end 4\n") == "15:1: nothing stands after the line 'end'");
}

TEST_CASE("a certificate that is cut off anywhere is refused") {
  for (std::size_t size = 0; size + 2 < kSmall.size(); ++size) {
    CHECK_FALSE(read(kSmall.substr(0, size)));
  }
}

}  // namespace
}  // namespace stig
