#!/usr/bin/env bash
# Grading beside a Polars script (tests/baseline/grade_polars.py) and beside reading and writing as many bytes with nothing
# done, in one run on one machine: plain numbers and numbers with units, rows grouped by student and in random order, with
# wrong methods among the answers and their diagnosis on.
# Usage: tests/benches/beside_polars.sh PYTHON [ROWS [STUDENTS [RUNS]]]   (default: 1,000,000 rows, 10,000 students, 3 runs;
# PYTHON has tests/baseline/requirements.txt installed; 10,000,000 rows take 4 GB below TMPDIR)
set -euo pipefail
cd "$(dirname "$0")/../.."
python=$(command -v "${1:-python3}")
rows=${2:-1000000} students=${3:-10000} runs=${4:-3}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cargo build --profile dist --locked --quiet
slipstick=$PWD/target/dist/slipstick
here=$PWD/tests/benches/beside_polars.py
{ echo student; seq -f 's%06g' 1 "$students"; } > "$work/roster.csv"
"$slipstick" generate wheels-on-inclines --roster "$work/roster.csv" --seed 1 --problems pulled-rolling --out "$work/set" >/dev/null
"$python" "$here" make "$work" "$rows"
row() { printf '%-46s %8s %8s %8s %6s %8s\n' "$@"; }
tab=$'\t'
echo "$rows rows, $students students, $(nproc) cores, $runs runs of each in turn; load average $(cut -d' ' -f1 /proc/loadavg)"
row "" "median s" "least s" "CPU s" "MiB" "of Polars"
for order in grouped random; do
  for kind in answers answers_units; do
    flag=""; [ $kind = answers_units ] && flag="${tab}--units"
    in="$work/$order/slipstick_$kind.csv"
    ours="$slipstick${tab}grade${tab}$work/set${tab}$in${tab}--out${tab}$work/graded${tab}--force${tab}--reports${tab}no"
    theirs="$python${tab}tests/baseline/grade_polars.py${tab}--out${tab}$work/$order$flag"
    "$slipstick" grade "$work/set" "$in" --out "$work/graded" --force --reports no >/dev/null
    null="$python${tab}$here${tab}null${tab}$in${tab}$work/graded/answers.csv${tab}$work/null"
    mapfile -t seen < <("$python" "$here" race "$runs" "$theirs" "$ours" "$null")
    names=("Polars" "slipstick grade" "the same bytes read and written, nothing done")
    base=${seen[0]%% *}
    echo "$kind, $order:"
    for i in 0 1 2; do
      read -r median least cpu peak <<< "${seen[$i]}"
      row "  ${names[$i]}" "$median" "$least" "$cpu" "$peak" "$(awk "BEGIN { printf \"%.2f\", $median / $base }")"
    done
    # The same bytes for any number of threads.
    taskset -c 0 "$slipstick" grade "$work/set" "$in" --out "$work/one" --force --reports no >/dev/null
    cmp "$work/graded/answers.csv" "$work/one/answers.csv"
  done
done
