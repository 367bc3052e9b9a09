#!/usr/bin/python3
"""Writes Documentation/Evidence/Window.md from the measurements of PalpateWindow.

    Utilities/window.py MEASURES [--page FILE]

MEASURES is build/release/window.json (see Utilities/window.sh, which calls this).
"""
import argparse
import json
import pathlib

ROOT = pathlib.Path(__file__).resolve().parent.parent

INTRODUCTION = """# Servo and window

Made by `Utilities/window.sh` on {machine}, with software OpenGL and one process for all of it.
A window of 1280 x 800 shows the Colin 27 head in four views; a simulated hand strokes the left thalamus at 1 kHz
(harmonics of degree 12, a sphere of 2 mm), 1.5 mm deep, with slices following. *Hidden* is the same touch with nothing
to draw: the servo alone. Every other line is as long, with one more activity of the window. Priority: SCHED_FIFO, if
the system grants it.

"""

FIGURES = """
## Start, volumes, structures

Times are the shortest of five, *wall* time. Memory is what stays resident after three volumes (`ch2`, `ch2better`,
`ch2bet`) were opened. The structures are AAL's. Frames are those of the view that drew least, with the hand in contact
for {touching:.0f} % of the ticks.

| what | measured | aim |
| --- | --- | --- |
| start to a window that can be used | {window:.2f} s | |
| start to four views of the head | {head:.2f} s | 2.5 s |
| memory of three volumes, by the size of their voxels | {memory:.2f} | 2 |
| 116 structures: listed | {list:.0f} ms | 100 ms |
| searched | {search:.0f} ms | 100 ms |
| all shown, all hidden | {show_all:.0f}, {show_none:.0f} ms | 100 ms |
| opened from the file, all drawn in 3-D (once) | {seconds:.1f} s | 8 s |
| and all modelled | {models:.0f} s | |
| frames/s in contact, one volume | {one:.1f} | |
| with a second one blended | {two:.1f} ({cost:.0f} % fewer) | 25 % |
"""


READING = """
*Period* is from tick to tick, ms; *tick* is the computing time of a tick, µs; quantiles are from a histogram with bins
a sixteenth wide. *Frames/s* are those of the view that drew least; *times* is how often the window was resized, a
volume was opened (only the newest is read), or a model of another degree was made.

## Closing

The window was closed at {moments} moments while it opened the head and its labels, and once while touching. Forces are
switched off first. Longest: {longest:.0f} ms ({work}); all work had ended each time: {ended}.

| while | ms |
| --- | --- |
"""


def row(*cells):
    return "| " + " | ".join(map(str, cells)) + " |\n"


def line_of(stretch):
    seconds = stretch["seconds"]
    period = stretch["period"]
    tick = stretch["tick"]
    return row(
        stretch["name"],
        f"{stretch['ticks'] / seconds:.0f}",
        f"{100.0 * stretch['touching'] / stretch['ticks']:.0f} %",
        f"{1e-3 * period['p99']:.2f}",
        f"{1e-3 * period['p999']:.2f}",
        f"{1e-3 * period['largest']:.2f}",
        stretch["missed"],
        stretch["faults"],
        f"{tick['median']:.0f}",
        f"{tick['p999']:.0f}",
        f"{min(stretch['pictures']) / seconds:.1f}",
        stretch["events"] or "",
    )


def figures_of(measures):
    figures = measures["figures"]
    one, two = measures["blending"]
    return FIGURES.format(
        window=1e-3 * figures["start"]["window"],
        head=1e-3 * figures["start"]["head"],
        memory=figures["memory"]["growth"] / figures["memory"]["volumes"],
        one=one["frames"],
        two=two["frames"],
        cost=100.0 * (1.0 - two["frames"] / one["frames"]),
        touching=100.0 * min(one["touching"], two["touching"]),
        seconds=1e-3 * figures["structures"]["opened"],
        models=1e-3 * figures["structures"]["modelled"],
        **figures["structures"])


def page_of(measures):
    page = INTRODUCTION.format(machine=measures["machine"])
    page += row("the window is", "ticks/s", "in contact", "period 99 %", "99.9 %", "longest", "missed",
                "faults", "tick", "99.9 %", "frames/s", "times")
    page += row(*["---"] * 12)
    page += "".join(line_of(stretch) for stretch in measures["stretches"])
    closings = measures["closings"]
    longest = max(closings, key=lambda closing: closing["milliseconds"])
    page += READING.format(moments=len(closings) - 1, longest=longest["milliseconds"],
                           work=longest["while"],
                           ended="yes" if all(one["ended"] for one in closings) else "no")
    by_work = {}
    for closing in closings:
        by_work.setdefault(closing["while"], []).append(closing["milliseconds"])
    page += "".join(row(work, ", ".join(f"{value:.0f}" for value in values))
                    for work, values in by_work.items())
    page += figures_of(measures)
    return page


TASKS = """
## Usual tasks

Actions from what is open before: a click, a key, a drag, a dialog that is answered; movements of the pointer are free.
`TasksTest` does them by real events, and fails if one takes more. Seconds are those of a program, which does not think.

| task | actions | s |
| --- | --- | --- |
"""


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("measures", type=pathlib.Path)
    parser.add_argument("tasks", type=pathlib.Path, help="rows that TasksTest wrote")
    parser.add_argument("--page", type=pathlib.Path, default=ROOT / "Documentation" / "Evidence" / "Window.md")
    arguments = parser.parse_args()
    page = page_of(json.loads(arguments.measures.read_text()))
    arguments.page.write_text(page + TASKS + arguments.tasks.read_text())


if __name__ == "__main__":
    main()
