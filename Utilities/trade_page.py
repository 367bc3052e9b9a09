"""The part of Documentation/Evidence/SpeedAndAccuracy.md on sample scenes: measurements of `palpate
tradeoff` (Utilities/trade.sh), as tables and a figure. Used by speed_and_accuracy.py."""
import json
import pathlib
import textwrap

from matplotlib import pyplot

SCENES = {
    "gland": "A prostate-like phantom in voxels of 0.5 x 0.5 x 3 mm, sphere of 2 mm",
    "yielding": "An elastic phantom of 20 kPa, with a nodule of 8 mm and 60 kPa, sphere of 4 mm",
    "thalamus": "The left thalamus of mricron's atlas in voxels of 1 mm, sphere of 2 mm",
    "bone": "Bone (300 and more) in a CT of 0.96 x 0.96 x 1.5 mm, sphere of 1.5 mm",
}

TEXT = """## Speed against accuracy, scene by scene

Results of `palpate tradeoff` for four sample scenes (`Utilities/trade.sh`). All settings are touched along the same
seeded path and compared with one reference. Errors are those of 99 % of the ticks, as far as they exceed the
reference's own uncertainty, which is stated with it: the mask does not distinguish settings at 0. A *JND* (just
noticeable difference) is 7 % of the force. The cost is the time to
prepare and to touch for ten minutes. In bold: the advised setting. For elastic structures, positions of the proxy are
not compared.

![Time of a tick against errors, scene by scene]({picture})
"""

FIGURE_ONLY = (" 6 tool points", " 200 tool points", "of degree 4, nearest point")  # settings that only the figure has
MARKERS = {"harmonics": "o", "facets": "s", "sub-voxel": "^", "elastic": "D"}
# Label of the axis, and the least error that its logarithmic scale shows.
ERRORS = {"beyond_position_p99_mm": ("position error of 99 %, mm", 0.001),
          "beyond_noticeable_p99_jnd": ("force error of 99 %, JND", 0.01),
          "beyond_direction_p99_degrees": ("direction error of 99 %, degrees", 0.01)}


def read(folder):
    """The measured structures, by scene; other scenes are omitted."""
    found = {}
    for name in SCENES:
        file = pathlib.Path(folder) / name / "tradeoff.json"
        if file.is_file():
            found[name] = json.loads(file.read_text())["structures"][0]
    return found


def felt(structure):
    return [row for row in structure["rows"]
            if row["outcome"] == "measured" and row["tick_p999_ns"] is not None
            and row["beyond_noticeable_p99_jnd"] is not None]


def best(rows, error):
    """Rows for which no other row is better in both time and this error."""
    def beats(a, b):
        pair = (a["tick_p999_ns"], a[error]), (b["tick_p999_ns"], b[error])
        return pair[0][0] <= pair[1][0] and pair[0][1] <= pair[1][1] and pair[0] != pair[1]
    rows = [row for row in rows if row[error] is not None]
    return [row for row in rows if not any(beats(other, row) for other in rows)]


def draw(found, file):
    figure, panels = pyplot.subplots(len(found), len(ERRORS), squeeze=False, constrained_layout=True,
                                     figsize=(13, 3.6 * len(found)))
    for panel_row, (name, structure) in zip(panels, found.items()):
        rows = felt(structure)
        for axes, (error, (label, least)) in zip(panel_row, ERRORS.items()):
            if not any(row[error] for row in rows):
                axes.set_visible(False)
                continue
            for kind, marker in MARKERS.items():
                mine = [row for row in rows
                        if row["representation"] == kind and row[error] is not None]
                axes.loglog([row["tick_p999_ns"] / 1e3 for row in mine],
                            [max(row[error], least) for row in mine], marker, label=kind, alpha=0.7)
            front = sorted(best(rows, error), key=lambda row: row["tick_p999_ns"])
            axes.loglog([row["tick_p999_ns"] / 1e3 for row in front],
                        [max(row[error], least) for row in front], "-", color="0.5", linewidth=1)
            axes.set_xlabel("tick, 99.9 %, µs")
            axes.set_ylabel(label)
            axes.tick_params(axis="x", which="minor", rotation=45, labelsize=7)
            axes.set_title(name, fontsize=9)
            axes.grid(True, which="both", alpha=0.25)
    panels[0][0].legend(fontsize=8)
    figure.savefig(file, dpi=100, metadata={"Software": None})
    pyplot.close(figure)


def wrapped(text, indent=""):
    return textwrap.fill(text, 119, subsequent_indent=indent, break_long_words=False, break_on_hyphens=False)


def number(value, scale=1.0):
    return "" if value is None else f"{scale * value:.3g}"


def table(structure):
    head = ["setting", "tick, µs: median", "99.9 %", "position, mm", "force, JND",
            "largest jump a tick, N", "cost, s"]
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    for row in felt(structure):
        is_advised = row["key"] == structure["advice"]["choose"]
        if row["setting"].endswith(FIGURE_ONLY) and not is_advised:
            continue
        name = f"**{row['setting']}**" if is_advised else row["setting"]
        cells = [name, number(row["tick_median_ns"], 1e-3), number(row["tick_p999_ns"], 1e-3),
                 number(row["beyond_position_p99_mm"]), number(row["beyond_noticeable_p99_jnd"]),
                 number(row["jump_most_n"]),
                 number(row["cost_seconds"])]
        lines.append("| " + " | ".join(cells) + " |")
    refused = [wrapped(f"- {row['setting']}: {row['message']}", "  ") for row in structure["rows"]
               if row["outcome"] == "refused"]
    return "\n".join(lines) + "\n" + ("\nRefused:\n\n" + "\n".join(refused) + "\n" if refused else "")


def section(found, picture):
    parts = [TEXT.format(picture=picture)]
    for name, structure in found.items():
        parts.append(f"### {SCENES[name]}\n\n"
                     f"{wrapped('Reference: ' + structure['reference'])}.\n\n{table(structure)}")
    return "\n".join(parts)
