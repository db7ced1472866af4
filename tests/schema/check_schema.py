#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Holds the JSON Schema and the reader to the same verdict.

Usage: check_schema.py PROBE rules|scenes|robots FILE...

Codes R1xx are about shape: the schema must reject such a file. All other codes
are about meaning, which a schema cannot see: it must accept. Files that are no YAML of
this language (R0xx) have no JSON to check.
"""
import json
import subprocess
import sys

import jsonschema


def main():
    out = json.loads(subprocess.run(sys.argv[1:], check=True, capture_output=True).stdout)
    jsonschema.Draft7Validator.check_schema(out["schema"])
    validator = jsonschema.Draft7Validator(out["schema"])
    failures = checked = rejected = 0
    for path, file in sorted(out["files"].items()):
        if not file["parsed"]:
            continue
        checked += 1
        errors = [f"{list(e.absolute_path)}: {e.message}" for e in validator.iter_errors(file["content"])]
        expected = any(code.startswith("R1") for code in file["codes"])
        rejected += expected
        if bool(errors) != expected:
            failures += 1
            print(f"{path}: reader says {file['codes']}, schema says {errors or 'accepted'}")
    print(f"{checked} files, {rejected} of them of wrong shape, {failures} disagreements")
    return 1 if failures or not rejected or rejected == checked else 0


if __name__ == "__main__":
    sys.exit(main())
