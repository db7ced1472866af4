// SPDX-License-Identifier: MIT
// Generates docs/diagnostics.md from the list of codes and their examples. The page has no
// text of its own but the head and the titles of groups, so that a code is documented by
// being listed.
#include "base/diagnostic_page.h"

#include <fmt/format.h>

#include "base/diagnostic_example.h"

namespace stig {

namespace {

struct Group {
  std::string_view prefix, title, about;
};

/// Groups are in the order of the page. A code whose prefix is in no group would be missing
/// from the page.
constexpr Group kGroups[] = {
    {"R0", "R0xx: the file as bytes and YAML", "Found before any key is looked at."},
    {"R1", "R1xx: keys and values",
     "What `stigc schema` describes: an editor that knows the schema finds these too."},
    {"R2", "R2xx: drawings and symbols", "What the schema cannot see: drawings are texts to it."},
    {"R3", "R3xx: meaning of the rule set", "Found by static checks; no rule is run for them."},
    {"F4", "F4xx: structure, trace and certificate files",
     "Files that the program writes and reads back."},
    {"P7", "P7xx: what a robot cannot build",
     "Why a rule set cannot be compiled for a robot, with the figures."},
    {"C5", "C5xx: files of the command line", "Files named on the command line."},
    {"V8", "V8xx: rule sets put to the test",
     "What a scene lacks in which `stigc validate` shall build."},
    {"S6", "S6xx: scenes of physical mode",
     "Found before the first step; keys and values are R1xx."},
    {"P6", "P6xx: robots and blocks of physical mode",
     "What the keys of docs/robots.md cannot mean together; keys and values are R1xx."},
};

constexpr std::string_view kHead = R"(# Diagnostics

Everything that `stigc` has to say about a file has a code, which never changes its
meaning. A report names the place, shows the line and marks what is meant:

```
wall.yaml:18:25: error[R204]: unknown brick 'pnik'
   18 |       . . .   . * .   . pnik .
      |                         ^~~~
help: did you mean 'pink'?
1 error
```

Lines that begin with `note:` point to the other place involved, if there is one.
Errors end a command with exit status 1, or 3 where they only say that what was allowed was used
up (P701, P712); warnings do not. All problems of a file are
reported at once. `--diagnostics json` prints the same as data.

`stigc --explain R204` prints what this page has on a code, and `stigc --explain` lists the codes.
Examples are parts of a file, which say what matters alone, or command lines.

This page is generated from `lib/base/diagnostics.def` and the examples beside it.
)";

bool has_prefix(const CodeInfo& code, std::string_view prefix) {
  return code.name.substr(0, prefix.size()) == prefix;
}

}  // namespace

/// The page is written by a test's update and compared by it otherwise, so it cannot lag
/// behind the list.
std::string diagnostics_markdown() {
  std::string out(kHead);
  for (const Group& group : kGroups) {
    bool begun = false;
    for (const CodeInfo& code : all_codes()) {
      if (!has_prefix(code, group.prefix)) continue;
      if (!begun) out += fmt::format("\n## {}\n\n{}\n", group.title, group.about);
      begun = true;
      out += fmt::format("\n### {} {} ({})\n\n{}\n", code.name, code.slug,
                         code.severity == Severity::error ? "error" : "warning", code.explanation);
      out += "\n" + example_text(code, "    ");
    }
  }
  return out;
}

}  // namespace stig
