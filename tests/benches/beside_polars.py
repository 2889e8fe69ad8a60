"""Helps beside_polars.sh: makes the submissions, runs commands side by side, reads and writes as many bytes with nothing done."""
import csv, json, os, resource, statistics, subprocess, sys, time

PARTS = ("omega", "friction")
UNITS = {"omega": (("rad/s", 1.0), ("rpm", 0.10471975511965977), ("rev/s", 6.283185307179586), ("deg/s", 0.017453292519943295)),
         "friction": (("N", 1.0), ("kN", 1e3), ("lbf", 4.4482216152605), ("mN", 1e-3))}


def make(folder, rows):
    """The same answers for both sides, of the shape of make_answers.py, but with values of wrong methods among the wrong ones:
    60 % within the tolerance, 15 % by a wrong method, 10 % off by 3 to 30 %, 10 % of the wrong sign, 5 % blank."""
    import numpy as np, polars as pl
    stored = json.load(open(f"{folder}/set/set.json"))
    students = [s["student"] for s in stored["students"]]
    data = [s["problems"][0]["data"] for s in stored["students"]]
    m, R, r, k, theta, P = (np.array([float(d[n].split()[0]) for d in data]) for n in ("m", "R", "r", "k", "theta", "P"))
    rows_of = {(q["student"], q["part"]): float(q["value"]) for q in csv.DictReader(open(f"{folder}/set/key.csv"))}
    true = np.array([[rows_of[s, p] for p in PARTS] for s in students])
    down = m * 9.81 * np.sin(np.radians(theta))
    # A03 a point, A05 a disc, A17 half the energy forgotten; A03, A26 friction keeps it at rest, A27 the pull forgotten
    spin = lambda k2: true[:, 0] * np.sqrt((k**2 + r**2) / (k2 + r**2))
    a = (P * (R + r) - down * r) / (m * (k**2 + r**2)) * r
    wrong = np.array([[spin(0), spin(R**2 / 2), true[:, 0] / np.sqrt(2)],
                      [(P * (R + r) - down * r) / r + down - P, down - P, m * a + down]])
    rng = np.random.default_rng(7)
    variant, part, unit = rng.integers(0, len(students), rows), rng.integers(0, 2, rows), rng.integers(0, 4, rows)
    kind = rng.choice(5, rows, p=[0.60, 0.15, 0.10, 0.10, 0.05])
    key = true[variant, part]
    value = np.select([kind == 0, kind == 1, kind == 2, kind == 3],
                      [key * (1 + rng.uniform(-0.009, 0.009, rows)), wrong[part, rng.integers(0, 3, rows), variant],
                       key * (1 + rng.choice([-1, 1], rows) * rng.uniform(0.03, 0.3, rows)), -key], np.nan)
    names = np.array([[u for u, _ in UNITS[p]] for p in PARTS])
    factors = np.array([[f for _, f in UNITS[p]] for p in PARTS])
    with open(f"{folder}/key.csv", "w") as out:
        out.write("variant,omega,friction\n")
        out.writelines(f"{i},{w!r},{f!r}\n" for i, (w, f) in enumerate(true.tolist()))
    for order in ("grouped", "random"):
        at = np.argsort(variant, kind="stable") if order == "grouped" else np.arange(rows)
        scaled = (value / factors[part, unit])[at].tolist()
        unit_names = names[part[at], unit[at]].tolist()
        for name, answers in (
            ("answers", [f"{x:.4g}" if x == x else None for x in value[at].tolist()]),
            ("answers_units", [f"{x:.5g} {u}" if x == x else None for x, u in zip(scaled, unit_names)]),
        ):
            to = f"{folder}/{order}"
            os.makedirs(to, exist_ok=True)
            frame = pl.DataFrame({"submission": np.arange(rows), "variant": variant[at],
                                  "part": pl.Series(np.array(PARTS, dtype=object)[part[at]], dtype=pl.String),
                                  "answer": pl.Series(answers, dtype=pl.String)})
            frame.write_csv(f"{to}/{name}.csv")
            frame.select(student=pl.Series(np.array(students, dtype=object)[variant[at]], dtype=pl.String), problem=pl.lit(1),
                         part="part", answer="answer").write_csv(f"{to}/slipstick_{name}.csv")
        os.path.exists(f"{folder}/{order}/key.csv") or os.link(f"{folder}/key.csv", f"{folder}/{order}/key.csv")


def null(read, write, to):
    """Reads one file and writes as many bytes as the other has, in blocks of 1 MiB; nothing else."""
    block = bytearray(1 << 20)
    with open(read, "rb", buffering=0) as f:
        while f.readinto(block):
            pass
    left = os.path.getsize(write)
    with open(to, "wb", buffering=0) as f:
        while left > 0:
            left -= f.write(memoryview(block)[:min(left, len(block))])


def race(runs, *sides):
    """Runs the commands in turn and prints for each: seconds (median), least seconds, seconds of all cores (least), MiB peak."""
    seen = [[] for _ in sides]
    for _ in range(runs):
        for side, have in zip(sides, seen):
            start = time.perf_counter()
            child = subprocess.Popen(side.split("\t"), stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
            said = child.stderr.read()
            _, status, used = os.wait4(child.pid, 0)
            wall = time.perf_counter() - start
            if status:
                sys.exit(f"{side}\n{said.decode()}")
            have.append((wall, used.ru_utime + used.ru_stime, used.ru_maxrss / 1024))
    for have in seen:
        walls, cpus, peaks = zip(*have)
        print(f"{statistics.median(walls):.3f} {min(walls):.3f} {min(cpus):.3f} {max(peaks):.0f}")


if __name__ == "__main__":
    what, *rest = sys.argv[1:]
    {"make": lambda: make(rest[0], int(rest[1])), "null": lambda: null(*rest), "race": lambda: race(int(rest[0]), *rest[1:])}[what]()
