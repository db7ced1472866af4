#!/bin/sh
# SPDX-License-Identifier: MIT
# Stands for $STIG_COMPILER before the compiler cache, which keeps no results of -fsyntax-only: parses, and
# writes an object of one byte in place of code.
for word; do
  [ "$previous" != -o ] || object=$word
  previous=$word
done
"$STIG_COMPILER" -fsyntax-only "$@" || exit
[ -z "$object" ] || echo >"$object"
