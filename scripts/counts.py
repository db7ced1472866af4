#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Counts what can be counted of the project's sources and prints it as a markdown table.

    counts.py [REVISION…]

One column for each revision, and one for the files as they stand. Counted are the C++ files of
lib/ and tools/ (`tests : source` sets them against tests/), by their text as clang-format lays it
out: a function begins on a line that ends in an opening brace and bears a parameter list, and
ends at the next closing brace of the same indentation.
"""

import re
import statistics
import subprocess
import sys

NOT_A_FUNCTION = re.compile(
    r"\s*(if|else|for|while|switch|do|catch|try|namespace|struct|class|enum|union|extern|return)\b|.*\[.*\]\s*\(")


def git(*arguments):
    return subprocess.run(["git", *arguments], check=True, capture_output=True,
                          text=True).stdout


def paths_at(revision):
    if revision is None:
        return git("ls-files", "--cached", "--others", "--exclude-standard").split("\n")
    return git("ls-tree", "-r", "--name-only", revision).split("\n")


def text_at(revision, path):
    if revision is None:
        with open(path, encoding="utf-8") as file:
            return file.read()
    return git("show", f"{revision}:{path}")


def is_comment(line):
    return line.lstrip().startswith(("//", "/*", "*"))


def function_lengths(lines):
    """The number of lines of each function body in a file, its braces included."""
    lengths = []
    for begin, line in enumerate(lines):
        if not line.endswith("{") or is_comment(line):
            continue
        head = begin
        while head > 0 and "(" not in lines[head] and begin - head < 6:
            head -= 1
        if "(" not in lines[head] or ")" not in line or NOT_A_FUNCTION.match(lines[head]):
            continue
        indent = len(lines[head]) - len(lines[head].lstrip())
        closing = " " * indent + "}"
        for end in range(begin + 1, len(lines)):
            if lines[end].rstrip(";),") == closing:
                lengths.append(end - begin + 1)
                break
    return lengths


def percentile(values, share):
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(share * len(ordered)))] if ordered else 0


def share(part, whole):
    return f"{100 * part / whole:.2g} %" if whole else "–"


def spread(values):
    return f"{int(statistics.median(values))} / {percentile(values, 0.95)}" if values else "–"


def bare_of(lines):
    """Comments that begin with "Of …" and so have no subject."""
    return sum(1 for before, line in zip([""] + lines, lines)
               if re.match(r"\s*///? Of\b", line) and not is_comment(before))


def counts(revision):
    own, tests = {}, 0
    for path in paths_at(revision):
        if not path.endswith((".cpp", ".h")):
            continue
        if path.startswith("tests/"):
            tests += text_at(revision, path).count("\n")
        elif path.startswith(("lib/", "tools/")):
            own[path] = text_at(revision, path).split("\n")[:-1]
    headers = {path: lines for path, lines in own.items() if path.endswith(".h")}
    sources = {path: lines for path, lines in own.items() if path.endswith(".cpp")}
    comments = {kind: (sum(is_comment(line) for lines in files.values() for line in lines),
                       sum(map(len, files.values())))
                for kind, files in (("headers", headers), ("sources", sources))}
    every = [line for lines in own.values() for line in lines]
    lengths = [length for lines in sources.values() for length in function_lengths(lines)]
    subjects = [len(line) for line in git("log", "--no-merges", "--format=%s",
                                          revision or "HEAD").split("\n") if line]
    last = subjects[:100]
    return {
        "headers": str(len(headers)),
        "sources": str(len(sources)),
        "header lines, median / 95th": spread([len(lines) for lines in headers.values()]),
        "source lines, median / 95th": spread([len(lines) for lines in sources.values()]),
        "files over 400 lines": str(sum(len(lines) > 400 for lines in own.values())),
        "functions": str(len(lengths)),
        "functions over 40 lines": share(sum(length > 40 for length in lengths), len(lengths)),
        "functions over 60 lines": share(sum(length > 60 for length in lengths), len(lengths)),
        "comment lines, headers": share(*comments["headers"]),
        "comment lines, sources": share(*comments["sources"]),
        "comments that begin with a bare Of": str(sum(map(bare_of, own.values()))),
        "asserts per 1000 lines": f"{1000 * sum(bool(re.search(r'(?<!static_)assert[(]', line)) for line in every) / len(every):.1f}",
        "tests : source": f"{tests / len(every):.2f}",
        "commit subject, last 100, median / 95th": spread(last),
    }


def main():
    if any(argument in ("-h", "--help") for argument in sys.argv[1:]):
        print(__doc__.strip())
        return
    columns = [(revision, counts(revision)) for revision in sys.argv[1:]] + [("now", counts(None))]
    print("| | " + " | ".join(name for name, _ in columns) + " |")
    print("|---|" + "---:|" * len(columns))
    for key in columns[0][1]:
        print(f"| {key} | " + " | ".join(column[key] for _, column in columns) + " |")


if __name__ == "__main__":
    main()
