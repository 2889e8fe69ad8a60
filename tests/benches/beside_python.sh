#!/usr/bin/env bash
# slipstick beside the Python script that an instructor would otherwise write (tests/baseline), in one run on one machine.
# Usage: tests/benches/beside_python.sh PYTHON   (a Python with tests/baseline/requirements.txt installed)
set -euo pipefail
cd "$(dirname "$0")/../.."
python=$(command -v "${1:-python3}")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cargo build --profile dist --locked --quiet
cargo bench --locked --no-run --bench one_file 2>/dev/null
one_file=$(ls -t target/release/deps/one_file-* | grep -v '\.d$' | head -1)
slipstick=target/dist/slipstick
seconds() { # seconds CPUS COMMAND...: wall seconds and peak MiB of a whole process, median of five by time
  local cpus=$1; shift
  for _ in 1 2 3 4 5; do
    "$python" - "$cpus" "$@" <<'PY'
import os, resource, subprocess, sys, time
cpus = {int(c) for c in sys.argv[1].split(",")}
start = time.perf_counter()
subprocess.run(sys.argv[2:], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
               preexec_fn=lambda: os.sched_setaffinity(0, cpus))
wall = time.perf_counter() - start
print(f"{wall:.3f} {resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024:.0f}")
PY
  done | sort -n | sed -n 3p
}
row() { printf '%-58s %9s %9s\n' "$@"; }
row "task" "seconds" "MiB peak"

# 100,000 variants of one problem, statements in one file, and the key.
row "100,000 variants: the script (numpy + Jinja2), 1 core" $(seconds 0 "$python" tests/baseline/generate.py -n 100000 --out "$work")
row "100,000 variants: slipstick, 1 core" $(seconds 0 "$one_file" 100000 1 "$work/ours")
row "100,000 variants: slipstick, 2 cores" $(seconds 0,1 "$one_file" 100000 2 "$work/ours")

# 1,000,000 plain answers to a set of 1,000 students.
"$python" tests/baseline/generate.py -n 1000 --out "$work" >/dev/null
"$python" tests/baseline/make_answers.py -n 1000000 --key "$work/key.csv" --out "$work"
{ echo student; seq -f '%04g' 1 1000; } > "$work/roster.csv"
"$slipstick" generate wheels-on-inclines --roster "$work/roster.csv" --seed 1 --problems pulled-rolling --out "$work/set" >/dev/null
"$python" - "$work" <<'PY'
import csv, random, sys
work = sys.argv[1]
key = {(r["student"], r["part"]): float(r["value"]) for r in csv.DictReader(open(f"{work}/set/key.csv"))}
random.seed(7)
with open(f"{work}/submissions.csv", "w") as out:
    out.write("student,problem,part,answer\n")
    for _ in range(1_000_000):
        student, part = f"{random.randint(1, 1000):04d}", random.choice(("omega", "friction"))
        true, kind = key[student, part], random.random()
        value = (true * (1 + random.uniform(-0.009, 0.009)) if kind < 0.60 else
                 true * (1 + random.choice((-1, 1)) * random.uniform(0.03, 0.3)) if kind < 0.85 else -true)
        out.write(f"{student},1,{part},{'' if kind > 0.95 else format(value, '.4g')}\n")
PY
row "1,000,000 answers: the script (Polars), 2 cores" $(seconds 0,1 "$python" tests/baseline/grade_polars.py --out "$work")
row "1,000,000 answers: slipstick grade, 2 cores" $(seconds 0,1 "$slipstick" grade "$work/set" "$work/submissions.csv" --out "$work/graded" --force)
row "1,000,000 answers: slipstick grade, 1 core" $(seconds 0 "$slipstick" grade "$work/set" "$work/submissions.csv" --out "$work/graded" --force)
wc -c "$work/submissions.csv" "$work/graded/answers.csv" | head -2
