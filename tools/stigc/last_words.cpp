// SPDX-License-Identifier: MIT
// For exceptions that nobody caught, in any thread. An assertion ends in abort and says its own;
// what comes here is either the machine's limit, said as such, or a bug, of which a report is asked
// for.
#include "last_words.h"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <system_error>

#include "base/text.h"

namespace stig::cli {
namespace {

constexpr int kStatus = 3;  ///< the work failed

void complain(const char* what, const char* detail) {
  std::fprintf(stderr, "stigc: %s%s\n", what, detail);
}

/// Nothing that was printed and not yet written is kept: half a result is none.
[[noreturn]] void say_last_words() {
  constexpr const char* kBug = "a bug in stigc, please report it: ";
  try {
    // There is none when terminate was called for another reason.
    if (const auto thrown = std::current_exception()) std::rethrow_exception(thrown);
    complain(kBug, "it ended without a reason");
  } catch (const std::bad_alloc&) {
    complain("there is not enough memory for this", "");
  } catch (const std::system_error& error) {
    complain("the system gave out: ", printable(error.what()).c_str());
  } catch (const std::exception& error) {
    complain(kBug, printable(error.what()).c_str());
  } catch (...) {
    complain(kBug, "an exception of no known kind");
  }
  // No destructors and no flush: other threads may still be at work.
  std::_Exit(kStatus);
}

}  // namespace

void prepare_last_words() { std::set_terminate(say_last_words); }

}  // namespace stig::cli
