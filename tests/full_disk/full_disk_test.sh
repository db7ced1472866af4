#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A disk that is full, and one that may only be read, end searches, studies, ensembles and
# validations with words and status 3; what was done stays, and the same command goes on with it once
# there is room. The disk is a tmpfs in a mount namespace of its own. Exits with 77 where there can
# be none.
#
#     full_disk_test.sh STIGC SOURCES
set -euo pipefail
stigc=$1 sources=$2
if [[ ${3-} != mounted ]]; then
  unshare --mount true 2>/dev/null ||
    { printf 'left out: no mount namespace of its own\n'; exit 77; }
  exec unshare --mount "$0" "$stigc" "$sources" mounted
fi
work=$(mktemp -d)
trap 'umount "$work/disk" 2>/dev/null || true; rm -rf "$work"' EXIT
cd "$work"
mkdir disk
mount -t tmpfs -o size=4m none disk 2>/dev/null || { printf 'left out: no tmpfs\n'; exit 77; }

fail() {
  printf '%s\n' "$*" >&2
  cat error.txt >&2
  exit 1
}
# refused WORDS COMMAND…: ends with status 3, and says WORDS.
refused() {
  local words=$1 code=0
  shift
  "$@" >out.txt 2>error.txt || code=$?
  [[ $code -eq 3 ]] || fail "status $code in place of 3: $*"
  grep -qE "$words" error.txt || fail "not said: $words"
}
resize() { mount -o "remount,size=$1" disk; }

# A search keeps the batches that were done, and goes on.
plan() {
  cat <<PLAN
stigc_search: 1
name: full
method: genetic
score: [{objective: modules}]
rules: 10
box: 12
deposits: 200
batch: 64
evaluations: $1
PLAN
}
plan 1280 >plan.yaml
evaluated() { "$stigc" archive "$1" --json | sed -n 's/^  "evaluated": \([0-9]*\),$/\1/p'; }
resize 300k
refused 'disk/found: .*full' "$stigc" search plan.yaml -q -o disk/found
done=$(evaluated disk/found)
[[ $done -ge 64 && $done -lt 1280 ]] || fail "$done evaluations are kept"
resize 8m
"$stigc" search plan.yaml -q -o disk/found >found.txt
"$stigc" search plan.yaml -q -o whole >whole.txt
cmp found.txt whole.txt

# Studies and ensembles go on from their journals, and end in the same bytes.
cat >sweep.yaml <<PLAN
stigc_sweep: 1
command: explore
file: $sources/rulesets/wall.yaml
options: {agents: 1, box: [60, 60, 60], steps: 100000}
vary: {seed: 1..400}
PLAN
study() { "$stigc" sweep sweep.yaml --threads 1 -o "$1"; }
ensemble() {
  "$stigc" explore "$sources/rulesets/wall.yaml" --agents 1 --box 60,60,60 --steps 100000 \
    --runs 600 --threads 1 -o "$1"
}
for work_of in study ensemble; do
  rm -f disk/* whole.jsonl
  resize 150k
  refused 'disk/some.jsonl.journal.*No space left' "$work_of" disk/some.jsonl
  # After the journal's first line, whole lines are what was done; a torn one may follow.
  kept=$(wc -l <disk/some.jsonl.journal)
  [[ $kept -gt 2 ]] || fail "$work_of: $kept lines are kept"
  [[ ! -e disk/some.jsonl ]] || fail "$work_of: half an output"
  resize 8m
  "$work_of" disk/some.jsonl >/dev/null 2>error.txt
  # None of them is done again.
  grep -qE "going on after $((kept - 1)) " error.txt || fail "$work_of: $((kept - 1)) are not kept"
  "$work_of" whole.jsonl >/dev/null 2>&1
  cmp whole.jsonl disk/some.jsonl
done

# A validation keeps the runs that are over, and its files are as those of one that had room.
validation() {
  "$stigc" validate "$sources/rulesets/staircase.yaml" --runs 3 --duration 4 -o "$1"
}
rm -rf disk/*
resize 150k
refused 'disk/runs.*No space left' validation disk/runs
grep -q 'the same command goes on' error.txt || fail 'not said that runs are kept'
# What had room is whole: which files that are depends on their sizes.
[[ ! -e disk/runs/report.html || $(tail -n 1 disk/runs/report.html) == *'</html>' ]] ||
  fail 'half a report'
resize 16m
code=0
validation disk/runs >/dev/null 2>&1 || code=$?
[[ $code -eq 1 ]] || fail "validation: status $code"  # in four seconds nothing is built
validation room >/dev/null 2>&1 || true
diff -r room disk/runs || fail 'not the same files'
rm -rf disk/runs room

# What may only be read is refused before the work, and still read.
rm -f disk/some.jsonl
"$stigc" search plan.yaml -q -o disk/found >/dev/null
plan 2560 >more.yaml
mount -o remount,ro disk
refused 'disk/found.*Read-only' "$stigc" search more.yaml -q -o disk/found
refused 'disk/some.jsonl.*Read-only' study disk/some.jsonl
refused 'disk/some.jsonl.*Read-only' ensemble disk/some.jsonl
refused 'disk/runs.*Read-only' validation disk/runs
[[ $(evaluated disk/found) -eq 1280 ]] || fail 'a file that may only be read is not read'
printf 'nothing lost\n'
