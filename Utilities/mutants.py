"""Breaks one line of the safety code at a time, and checks that a test fails.

Testing/Mutants/mutants.toml lists the lines. They are changed in a copy of the sources, below
build/mutants, which is built and tested there; the working tree is only read.
"""

import argparse
import os
import pathlib
import re
import subprocess
import sys
import time
import tomllib

ROOT = pathlib.Path(__file__).resolve().parent.parent
TABLE = ROOT / "Testing/Mutants/mutants.toml"
PAGE = ROOT / "Documentation/Mutants.md"
WORK = ROOT / "build/mutants"
# Fates on the page besides tests.
HARMLESS = "not run: "
NOT_RUN = "not run yet"
SURVIVES = "**survives**"
LIMIT = 120  # s, for a program that does not end because of a mutant

INTRODUCTION = """# Mutants

Each row is one line that was broken on purpose, and the first test that failed. A test that cannot fail kills nothing;
a surviving mutant is a missing test. Written by `Utilities/mutants.sh` from
[`Testing/Mutants/mutants.toml`](../Testing/Mutants/mutants.toml); the test `Structure.Mutants` checks that table against
the sources.
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


def code_of(text):
    """Code for a cell of a table."""
    return "`" + " ".join(lines_of(text)).replace("|", "\\|") + "`" if text.strip() else "(nothing)"


def row_of(mutant):
    """Its row of the page, without its fate."""
    return f"| {mutant['breaks']} | {code_of(mutant['old'])} | {code_of(mutant['new'])} |"


def killers_on(page, table):
    """Mutants whose row is on the page already, and what killed them there; None if nothing did."""
    fates = {}
    for line in page.split("\n"):
        row, _, fate = line.removesuffix(" |").rpartition(" | ")
        fates[row + " |"] = fate
    known = {id(m): fates[row_of(m)] for m in table["mutant"] if row_of(m) in fates}
    return {
        key: None if fate == SURVIVES else fate
        for key, fate in known.items()
        if fate != NOT_RUN and not fate.startswith(HARMLESS)
    }


def page_of(table, killers):
    """The page: mutants and the test that killed each."""
    page = [INTRODUCTION]
    run = [m for m in table["mutant"] if not m.get("equivalent") and id(m) in killers]
    harmless = sum(1 for m in table["mutant"] if m.get("equivalent"))
    killed = sum(1 for m in run if killers[id(m)])
    waiting = len(table["mutant"]) - harmless - len(run)
    page.append(
        f"{killed} of {len(run)} mutants are killed; {harmless} more are listed with the reason why none needs to be"
        + (f", {waiting} were not run yet.\n" if waiting else ".\n")
    )
    file = None
    for mutant in table["mutant"]:
        if mutant["file"] != file:
            file = mutant["file"]
            page.append(f"\n## {pathlib.Path(file).name}\n")
            page.append("| it breaks | line | mutant | killed by |\n| --- | --- | --- | --- |")
        fate = mutant.get("equivalent")
        fate = HARMLESS + fate if fate else killers.get(id(mutant), NOT_RUN) or SURVIVES
        page.append(f"{row_of(mutant)} {fate} |")
    return "\n".join(page).replace("\n\n\n", "\n\n") + "\n"


def run(table, parts, is_new_only):
    """Runs all mutants whose file's path contains one of `parts`; returns the survivors."""
    known = killers_on(PAGE.read_text(), table)
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
        # After each, since a run may be cut off; another may have written in the meantime.
        PAGE.write_text(page_of(table, {**killers_on(PAGE.read_text(), table), **killers}))
    return [mutant for mutant in chosen if not killers[id(mutant)]]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument(
        "parts", nargs="*", default=[""], help="only files whose path contains one of these"
    )
    parser.add_argument(
        "--new", action="store_true", help="only those that the page does not have as killed"
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
