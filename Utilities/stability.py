#!/usr/bin/python3
"""Writes Documentation/Evidence/Stability.md and its figure from the measurements of PalpateStability.

    Utilities/stability.py BORDERS [--page FILE] [--picture FILE]

BORDERS is build/release/stability.json (see Utilities/stability.sh, which calls this).
"""
import argparse
import json
import os
import pathlib

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parent.parent
DOCUMENTATION = ROOT / "Documentation"

INTRODUCTION = """# Stability

Made by `Utilities/stability.sh`. A simulated hand (`Testing/Support/StabilityProbe`) presses each structure for a
second, stroking it, and then holds still. It was *stable* if structure and mechanism together had generated no net
energy at any tick since the contact began, and if the hand came to rest. The border is the lowest stiffness that fails,
found by bisection to 1 %. Time is virtual, so every run gives the same numbers. Except in the last column, the safety
chain is off: no ramp, no limit, no energy observer.

*Claimed* is the limit of `StiffestStable`, above which `palpate touch` warns before forces start: the minimum of
(b - |B|) / (T/2 + delay), for a mechanism with damping b and a structure with damping B (Colgate and Schenkel 1997),
and 2 f / D, for friction f and encoder counts D (Diolaiti et al. 2006). The device's frame is oblique to every
structure.

![Measured borders over the claimed one]({picture})
"""

READING = """## Results

- Of {count} combinations of structure, rate, delay, damping, friction, counts and hand,
  {violations}
- Without counts and friction, energy generation begins at {low:.2g} to {high:.2g} times the claimed stiffness (median {median:.2g}).
- With counts and friction, it begins at {low_counts:.2g} to {high_counts:.2g} times (median {median_counts:.2g}): the bound of Diolaiti et al. does not include
  the energy that the mechanism's damping absorbs in addition to friction.
- In {earlier} of the {count} combinations a limit cycle at rest began below a press that generates energy ({others} of them without
  counts): counts sustain a motion of the hand that is too small to generate net energy. None began below the claimed
  border.
"""

# In the order of the legend.
KINDS = {"wall": "o", "harmonics": "s", "facets": "^", "sub-voxel, point": "D",
         "sub-voxel, 26 points": "x"}
# Borders are accurate to 1 %.
NEARLY = 0.99
SHOWN_HZ = 1000  # the rate whose rows are on the page; the figure and the results have all


def row(*cells):
    return "| " + " | ".join(map(str, cells)) + " |"


def table(head, rows):
    return "\n".join([row(*head), row(*["---"] * len(head)), *rows]) + "\n"


def number(value):
    return f"{value:.3g}"


def border(value, claimed):
    """Borders at the end of the search range were not found."""
    if value <= 0.0:
        return "none"
    return f"above {number(value)}" if value >= 63.9 * claimed else number(value)


def counts_bound(entry):
    return 2.0 * entry["friction_n"] / entry["count_mm"]


def scatter(axes, entries, bound, title, label):
    for kind, marker in KINDS.items():
        series = [e for e in entries if e["kind"] == kind]
        colour = f"C{list(KINDS).index(kind)}"
        axes.loglog([bound(e) for e in series], [e["energy_n_per_mm"] for e in series], marker,
                    color=colour, markersize=5, label=f"{kind}: energy comes out")
        axes.loglog([bound(e) * 1.04 for e in series], [e["vibration_n_per_mm"] for e in series], marker,
                    color=colour, markersize=5, fillstyle="none", alpha=0.7,
                    label=f"{kind}: limit cycle")
    low, high = min(map(bound, entries)), max(map(bound, entries))
    axes.loglog([low, high], [low, high], "k-", linewidth=1, label="the bound")
    axes.set_title(title, fontsize=9)
    axes.set_xlabel(label, fontsize=9)
    axes.set_ylabel("measured border, N/mm", fontsize=9)
    axes.grid(True, which="both", alpha=0.2)


def bars(axes, entries):
    places = {kind: i for i, kind in enumerate(KINDS)}
    usual = [e for e in entries if e["hand"] == "usual"]
    columns = [("energy_n_per_mm", "energy comes out", "C0"), ("vibration_n_per_mm", "limit cycle", "C1"),
               ("safety_n_per_mm", "limit cycle with the safety chain", "C2")]
    for i, (key, label, colour) in enumerate(columns):
        axes.bar([places[e["kind"]] + 0.27 * (i - 1) for e in usual], [e[key] for e in usual], 0.25,
                 color=colour, label=label)
    axes.set_ylim(2, 200)
    axes.axhline(usual[0]["claimed_n_per_mm"], color="k", linewidth=1, label="claimed")
    axes.set_yscale("log")
    axes.set_xticks(range(len(KINDS)), [kind.replace(", ", ",\n") for kind in KINDS], fontsize=7)
    axes.set_title("the simulated device at 1 kHz, usual hand", fontsize=9)
    axes.set_ylabel("measured border, N/mm", fontsize=9)
    axes.grid(True, axis="y", which="both", alpha=0.2)
    axes.legend(fontsize=7)


def draw(entries, file):
    figure, (sampling, counts, hands) = pyplot.subplots(1, 3, figsize=(14, 4.8),
                                                        constrained_layout=True)
    scatter(sampling, [e for e in entries if e["sweep"] == "sampling"], lambda e: e["claimed_n_per_mm"],
            "sampling, delay, damping: no counts, no friction", "(b - |B|) / (T/2 + delay), N/mm")
    scatter(counts, [e for e in entries if e["sweep"] == "counts"], counts_bound,
            "counts and friction: b = 0.02 N s/mm at 1 kHz", "2 f / D, N/mm")
    sampling.legend(fontsize=6)
    bars(hands, [e for e in entries if e["sweep"] == "hands"])
    figure.savefig(file, dpi=110, metadata={"Software": None})


def sampling_table(entries):
    rows = []
    for e in entries:
        if e["sweep"] == "sampling" and e["kind"] == "wall" and e["rate_hz"] == SHOWN_HZ:
            same = [o for o in entries if o["sweep"] == "sampling"
                    and all(o[key] == e[key] for key in ("rate_hz", "delay_s", "claimed_n_per_mm",
                                                         "mechanism_damping_ns_per_mm"))]
            cells = {o["kind"]: o for o in same}
            rows.append(row(number(1e3 * e["delay_s"]),
                            number(e["mechanism_damping_ns_per_mm"]), number(e["damping_ns_per_mm"]),
                            number(e["claimed_n_per_mm"]),
                            *[border(cells[k]["energy_n_per_mm"], e["claimed_n_per_mm"])
                              for k in KINDS]))
    return table(["delay, ms", "b, N s/mm", "B, N s/mm", "claimed, N/mm",
                  *KINDS], rows)


def counts_table(entries):
    rows = []
    for e in entries:
        if e["sweep"] == "counts" and e["kind"] == "wall":
            cells = {o["kind"]: o for o in entries if o["sweep"] == "counts"
                     and all(o[key] == e[key] for key in ("count_mm", "friction_n"))}
            rows.append(row(number(e["count_mm"]), number(e["friction_n"]), number(e["claimed_n_per_mm"]),
                            *[border(cells[k]["energy_n_per_mm"], e["claimed_n_per_mm"]) for k in KINDS]))
    return table(["D, mm", "f, N", "claimed, N/mm", *KINDS], rows)


def hands_table(entries):
    rows = [row(e["kind"], e["hand"], number(e["claimed_n_per_mm"]),
                border(e["energy_n_per_mm"], e["claimed_n_per_mm"]),
                border(e["vibration_n_per_mm"], e["claimed_n_per_mm"]),
                border(e["safety_n_per_mm"], e["claimed_n_per_mm"]))
            for e in entries if e["sweep"] == "hands"]
    return table(["structure", "hand", "claimed, N/mm", "energy generated", "limit cycle",
                  "limit cycle with the safety chain"], rows)


def reading(entries):
    bare, counted = (sorted(e["energy_n_per_mm"] / e["claimed_n_per_mm"] for e in entries
                            if (e["sweep"] == "sampling") == is_bare) for is_bare in (True, False))
    failed = sum(ratio < NEARLY for ratio in bare + counted)
    earlier = [e for e in entries if e["vibration_n_per_mm"] < NEARLY * e["energy_n_per_mm"]]
    violations = f"{failed or 'none'} generated energy below the claimed border."
    below = [e for e in entries if e["vibration_n_per_mm"] < NEARLY * e["claimed_n_per_mm"]]
    assert not below, "reword the page"
    return READING.format(count=len(entries), violations=violations, low=bare[0], high=bare[-1],
                          median=bare[len(bare) // 2], low_counts=counted[0],
                          high_counts=counted[-1], median_counts=counted[len(counted) // 2],
                          earlier=len(earlier),
                          others=sum(e["sweep"] == "sampling" for e in earlier))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("borders", type=pathlib.Path)
    parser.add_argument("--page", type=pathlib.Path, default=DOCUMENTATION / "Evidence" / "Stability.md")
    parser.add_argument("--picture", type=pathlib.Path,
                        default=DOCUMENTATION / "Images" / "stability.png")
    arguments = parser.parse_args()
    entries = json.loads(arguments.borders.read_text())
    draw(entries, arguments.picture)
    picture = os.path.relpath(arguments.picture, arguments.page.parent)
    parts = [INTRODUCTION.format(picture=picture), reading(entries),
             f"## Sampling, delay and damping\n\nStiffness at which energy is generated at {SHOWN_HZ} Hz, N/mm.\n",
             sampling_table(entries),
             "## Counts and friction\n\nStiffness at which energy is generated, N/mm.\n", counts_table(entries),
             "## Hands\n\nThe simulated device with its defaults, at 1 kHz, ignoring its stated limit of 3 N/mm. Hands are\n"
             "0.1 kg, 0.1 N/mm (soft), 0.25 kg, 0.5 N/mm (usual) and 0.5 kg, 2 N/mm (firm).\n",
             hands_table(entries)]
    arguments.page.write_text("\n".join(parts))


if __name__ == "__main__":
    main()
