"""Runs the commands of a page as written, one after the other, in an empty folder.

    run_page.py PAGE PROGRAMS      PROGRAMS is build/release/bin

Commands are the blocks of ```sh; each has to end with exit code 0. What a block reads, an earlier one makes. A
comment on the line before a block excepts it:

    <!-- not run: needs a display -->   or hardware, a network, root, or the time of a build

Commands outside of such blocks, which nobody would run, are faults.
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile

FENCE = re.compile(r"^( *)(```+)(\w*)$")
MARK = re.compile(r"^ *<!-- not run: .+ -->$")
COMMAND = re.compile(r"^ *(\S*/)?(palpate(-viewer)?|sudo|cmake|ctest|xvfb-run|snakemake|Rscript|apt-get) \S")
SOURCE = pathlib.Path(__file__).resolve().parents[2]


class Block:
    def __init__(self, line, text):
        self.line, self.text = line, text


def blocks_of(text):
    """The blocks of a page that are to be run, and the numbers of lines with commands outside of ```sh."""
    blocks, strays = [], []
    lines = text.split("\n")
    number = 0
    while number < len(lines):
        fence = FENCE.match(lines[number])
        if not fence:
            if lines[number].startswith("    ") and COMMAND.match(lines[number]):
                strays.append(number + 1)
            number += 1
            continue
        start = number
        number += 1
        while not lines[number].strip() == fence[2]:
            number += 1
        inside = [line.removeprefix(fence[1]) for line in lines[start + 1 : number]]
        if fence[3] != "sh":
            strays += [start + 2 + i for i, line in enumerate(inside) if COMMAND.match(line)]
        elif not (start and MARK.match(lines[start - 1])):
            blocks.append(Block(start + 1, "\n".join(inside) + "\n"))
        number += 1
    return blocks, strays


def prepare(folder, programs):
    """The folders of the sources that pages name, seen from `folder`."""
    release = folder / "build" / "release"
    release.mkdir(parents=True)
    (release / "bin").symlink_to(programs)
    for name in ["Applications", "Data", "Documentation", "Utilities"]:
        (folder / name).symlink_to(SOURCE / name)


def run(blocks, folder, programs):
    """Runs blocks; an account of the first one that fails, or an empty text."""
    environment = dict(os.environ, PATH=f"{programs}:{os.environ['PATH']}", PALPATE_CACHE_DIR="")
    for block in blocks:
        done = subprocess.run(
            ["sh", "-eux", "-c", block.text],
            cwd=folder,
            env=environment,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
        )
        if done.returncode != 0:
            return f"line {block.line} ends with {done.returncode}:\n{done.stdout[-4000:]}"
    return ""


def main():
    page, programs = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
    blocks, strays = blocks_of(page.read_text())
    if strays:
        sys.exit(f"{page} has commands outside of ```sh in lines {strays}")
    with tempfile.TemporaryDirectory() as scratch:
        prepare(pathlib.Path(scratch), programs)
        failure = run(blocks, pathlib.Path(scratch), programs)
    if failure:
        sys.exit(f"{page}, {failure}")


if __name__ == "__main__":
    main()
