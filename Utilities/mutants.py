"""Breaks one line of the safety code at a time, and checks that a test fails.

Testing/Mutants/mutants.toml lists the lines. They are changed in a copy of the sources, below
build/mutants, which is built and tested there; the working tree is only read.
"""

import argparse
import csv
import io
import os
import pathlib
import re
import subprocess
import sys
import time
import tomllib

ROOT = pathlib.Path(__file__).resolve().parent.parent
TABLE = ROOT / "Testing/Mutants/mutants.toml"
RESULTS = ROOT / "Testing/Mutants/mutants.csv"
PAGE = ROOT / "Testing/Mutants/README.md"
WORK = ROOT / "build/mutants"
# Fates in the results besides tests.
HARMLESS = "not run: "
NOT_RUN = "not run yet"
SURVIVES = "survives"
LIMIT = 120  # s, for a program that does not end because of a mutant

COLUMNS = ["file", "breaks", "line", "mutant", "killed by"]
SUMMARY = """# Mutants

`Utilities/mutants.sh` breaks one line of safety, servo, forces, elasticity, network, statistics and comparison at a
time and runs the tests of that code. A test that cannot fail kills nothing; a surviving mutant is a missing test.

{totals}

- [`mutants.toml`](mutants.toml): the lines and what they become. The test `Structure.Mutants` checks that each is in
  the sources exactly once.
- [`mutants.csv`](mutants.csv): the first test that failed for each, or the reason why no test can see the change.
- `Utilities/mutants.sh` writes the CSV file and this page in about two hours. A part of a path as its argument
  restricts the run to those files; `--new` runs only what is not known to be killed. It fails if a mutant survives.

| code | mutants | killed | harmless |
| --- | --- | --- | --- |
"""


def lines_of(text):
    """The lines of an entry of the table, without indentation."""
    return [line.strip() for line in text.strip("\n").split("\n") if line.strip()]


def mutated(text, mutant):
    """The text of the file with the mutant in it. Raises ValueError if it does not apply."""
    source = text.split("\n")
    wanted = lines_of(mutant["old"])
    # A line broken by clang-format still matches.
    for length in range(len(wanted), len(wanted) + 3):
        found = [
            n
            for n in range(len(source) - length + 1)
            if " ".join(line.strip() for line in source[n : n + length]) == " ".join(wanted)
        ]
        if found:
            break
    if len(found) != 1:
        raise ValueError(
            f"{mutant['file']} has the line of a mutant {len(found)} times: {wanted[-1]}"
        )
    place = found[0]
    return "\n".join(source[:place] + lines_of(mutant["new"]) + source[place + length :])


def problems_of(table, root):
    """Errors in the table: mutants that do not apply or are incomplete."""
    problems = []
    seen = set()
    for mutant in table["mutant"]:
        try:
            if not mutant["breaks"] or not group_of(table, mutant):
                raise ValueError(f"{mutant['file']} has a mutant without a reason or a group")
            key = (mutant["file"], mutant["old"], mutant["new"])
            if key in seen or mutant["old"] == mutant["new"]:
                raise ValueError(f"{mutant['file']} has a mutant twice: {mutant['breaks']}")
            seen.add(key)
            mutated((root / mutant["file"]).read_text(), mutant)
        except (OSError, ValueError) as error:
            problems.append(str(error))
    return problems


def group_of(table, mutant):
    """The programs built and run for a mutant."""
    return next((g for g in table["group"] if mutant["file"].startswith(g["files"])), None)


class Copy:
    """The sources and their build."""

    def __init__(self):
        self.sources = WORK / "sources"
        self.build = WORK / "build"
        # So that compiler caches recognize files of another checkout.
        os.environ.setdefault("CCACHE_BASEDIR", str(self.sources))

    def refresh(self):
        """Mirrors the working tree; unchanged files keep their times and are not rebuilt."""
        names = subprocess.run(
            ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
            cwd=ROOT, check=True, capture_output=True, text=True,
        ).stdout.split("\0")
        for copied in self.sources.rglob("*"):
            if copied.is_file() and not (ROOT / copied.relative_to(self.sources)).is_file():
                copied.unlink()
        for name in filter(None, names):
            source, target = ROOT / name, self.sources / name
            if source.is_file():
                content = source.read_bytes()
                if not target.is_file() or target.read_bytes() != content:
                    target.parent.mkdir(parents=True, exist_ok=True)
                    target.write_bytes(content)

    def configure(self):
        subprocess.run(
            ["cmake", "-S", self.sources, "-B", self.build, "-G", "Ninja", "--log-level=NOTICE",
             "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG",
             "-DCMAKE_LINK_DEPENDS_NO_SHARED=ON", "-DPALPATE_BUILD_VIEWER=OFF",
             "-DPALPATE_WRAP_PYTHON=OFF", "-DPALPATE_BUILD_BENCHMARKS=OFF"],
            check=True,
        )

    def make(self, programs):
        """Whether the programs build."""
        done = subprocess.run(
            ["cmake", "--build", self.build, "--parallel", "2", "--target", *programs],
            capture_output=True, text=True,
        )
        if done.returncode != 0:
            print(done.stdout[-2000:], file=sys.stderr)
        return done.returncode == 0

    def first_failure(self, tests):
        """The first test that fails; None if none does."""
        for program, chosen in tests:
            try:
                done = subprocess.run(
                    [self.build / "bin" / program, f"--gtest_filter={chosen}", "--gtest_fail_fast"],
                    capture_output=True, text=True, errors="replace", timeout=LIMIT,
                )
                code, said, how = done.returncode, done.stdout, ""
            except subprocess.TimeoutExpired as late:
                code, said, how = 1, (late.stdout or b"").decode(errors="replace"), " (never ends)"
            if code != 0:
                failed = re.search(r"^\[  FAILED  \] (\S+?)(?:,| \()", said, re.M)
                begun = re.findall(r"^\[ RUN      \] (\S+)", said, re.M)
                name = failed.group(1) if failed else (begun or ["?"])[-1]
                return name + ("" if failed else how or " (crashes)")
        return None


def try_mutant(copy, table, mutant):
    """The test that kills it; None if it survives. The copy is restored afterwards."""
    path = copy.sources / mutant["file"]
    before = path.read_text()
    tests = group_of(table, mutant)["tests"]
    path.write_text(mutated(before, mutant))
    try:
        if not copy.make([program for program, _ in tests]):
            raise SystemExit(f"A mutant of {mutant['file']} does not compile: {mutant['breaks']}")
        return copy.first_failure(tests)
    finally:
        path.write_text(before)


def row_of(mutant):
    """Its row of the results, without its fate."""
    return [mutant["file"], mutant["breaks"]] + [" ".join(lines_of(mutant[key])) for key in ("old", "new")]


def killers_in(results, table):
    """Mutants whose row is in the results (CSV) already, and what killed them there; None if nothing did."""
    fates = {tuple(cells[:-1]): cells[-1] for cells in csv.reader(io.StringIO(results)) if cells}
    known = {id(m): fates[tuple(row_of(m))] for m in table["mutant"] if tuple(row_of(m)) in fates}
    return {
        key: None if fate == SURVIVES else fate
        for key, fate in known.items()
        if fate != NOT_RUN and not fate.startswith(HARMLESS)
    }


def results_of(table, killers):
    """The results as CSV: mutants and the test that killed each."""
    results = io.StringIO()
    writer = csv.writer(results, lineterminator="\n")
    writer.writerow(COLUMNS)
    for mutant in table["mutant"]:
        fate = mutant.get("equivalent")
        fate = HARMLESS + fate if fate else killers.get(id(mutant), NOT_RUN) or SURVIVES
        writer.writerow(row_of(mutant) + [fate])
    return results.getvalue()


def counts_of(mutants, killers):
    """How many were run, are killed, and need no test."""
    run = [m for m in mutants if not m.get("equivalent") and id(m) in killers]
    return len(run), sum(1 for m in run if killers[id(m)]), sum(1 for m in mutants if m.get("equivalent"))


def page_of(table, killers):
    """The page: totals, and those of each folder."""
    run, killed, harmless = counts_of(table["mutant"], killers)
    waiting = len(table["mutant"]) - harmless - run
    totals = f"{killed} of {run} mutants are killed; {harmless} more are harmless, with the reason" + (
        f"; {waiting} were not run yet." if waiting else "."
    )
    folders = {}
    for mutant in table["mutant"]:
        folders.setdefault(str(pathlib.PurePath(mutant["file"]).parent), []).append(mutant)
    rows = []
    for folder, mutants in folders.items():
        _, killed, harmless = counts_of(mutants, killers)
        rows.append(f"| `{folder}` | {len(mutants)} | {killed} | {harmless} |\n")
    return SUMMARY.format(totals=totals) + "".join(rows)


def write(table, killers):
    """Writes what is new into the results and the page; another run may have written since."""
    known = killers_in(RESULTS.read_text(), table) | killers
    RESULTS.write_text(results_of(table, known))
    PAGE.write_text(page_of(table, known))


def run(table, parts, is_new_only):
    """Runs all mutants whose file's path contains one of `parts`; returns the survivors."""
    known = killers_in(RESULTS.read_text(), table)
    chosen = [
        m for m in table["mutant"]
        if any(part in m["file"] for part in parts) and not m.get("equivalent")
        and not (is_new_only and known.get(id(m)))
    ]
    copy = Copy()
    copy.refresh()
    copy.configure()
    for group in table["group"]:
        if any(group_of(table, mutant) is group for mutant in chosen):
            if not copy.make([program for program, _ in group["tests"]]):
                raise SystemExit("The sources themselves do not build.")
            failure = copy.first_failure(group["tests"])
            if failure:
                raise SystemExit(f"{failure} fails without any mutant.")
    killers = {}
    for mutant in chosen:
        start = time.monotonic()
        killers[id(mutant)] = killer = try_mutant(copy, table, mutant)
        spent = time.monotonic() - start
        print(f"{killer or 'SURVIVES':<70} {mutant['breaks']} ({spent:.0f} s)", flush=True)
        write(table, killers)  # after each, since a run may be cut off
    return [mutant for mutant in chosen if not killers[id(mutant)]]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument(
        "parts", nargs="*", default=[""], help="only files whose path contains one of these"
    )
    parser.add_argument(
        "--new", action="store_true", help="only those that are not known to be killed"
    )
    parser.add_argument("--check", action="store_true", help="only check whether every mutant applies")
    arguments = parser.parse_args()
    table = tomllib.loads(TABLE.read_text())
    problems = problems_of(table, ROOT)
    if problems:
        raise SystemExit("\n".join(problems) + f"\nBring {TABLE.relative_to(ROOT)} up to date.")
    if arguments.check:
        return
    survivors = run(table, arguments.parts, arguments.new)
    if survivors:
        raise SystemExit(f"{len(survivors)} mutants survive: write the missing tests.")


if __name__ == "__main__":
    main()
