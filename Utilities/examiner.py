#!/usr/bin/python3
"""Writes Documentation/Evidence/VirtualExaminer.md from the searches of PalpateExaminer.

    Utilities/examiner.py SEARCHES [--page FILE]

SEARCHES is build/release/examiner.json (see Utilities/examiner.sh, which calls this).
"""
import argparse
import json
import math
import pathlib

ROOT = pathlib.Path(__file__).resolve().parent.parent

INTRODUCTION = """# Virtual examiner

Which nodules can be found by force alone? Made by `Utilities/examiner.sh`: a simulated hand searches elastic phantoms
for a nodule, {searches} times each. It knows where it pressed and which force it felt, nothing else. Every search has its own
seed, so the same run gives the same numbers.

## What is simulated

| part | what it does | values |
| --- | --- | --- |
| organ | an ellipsoid of a prostate's size, free towards the examiner and on springs elsewhere; elastic contact as in touch ([Elasticity](../../Modules/Elasticity/README.md)) | semi-axes of {axes} mm, tissue of {tissue_kpa:g} kPa, Poisson's ratio {poisson:g}, springs of {bed_kpa_per_mm:g} kPa/mm; {elements_across} elements across, compliance of degree {degree} |
| nodule | a sphere, its top at a depth under the surface, {ratios} times as stiff as the tissue | 5 mm from the centre of the free side |
| hand | presses with a sphere | radius {ball_mm:g} mm, {depth_mm:g} mm deep |
| | errs in depth and place at each press, normally distributed (*assumed*) | standard deviations of {depth_deviation_mm:g} mm, and {place_deviation_mm:g} mm along each axis |
| | feels the force with an error | standard deviation of {percept_deviation_jnd:g} just noticeable difference (JND) (*assumed*) |
| perception | JND of force | {weber:.0f} % (Pang, Tan and Durlach 1991; Jones 1989), at least {floor:.3f} N (`ForcePerception`) |
| technique | presses a square raster, shifted and turned by each search; comes back to the hardest; reports the hardest of these if it is harder than the median (*chosen*) | {spacing_mm:g} mm apart within {reach_mm:g} mm; {sweeps} presses each; {suspects} places, {returns} presses each; from {threshold_jnd:g} JND |

A nodule is *found* if the reported place is within its radius and {found_margin_mm:g} mm of the surface above it.
"""

RESULTS = """## Results

Part of the searches that found the nodule and, in parentheses, by how many JND it raises the force right above it.

{table}
- Without a nodule, {alarms} of {searches} searches reported one ({alarm_rate}). With one, at most {elsewhere} reported another place.
- Standard error of a percentage: at most {error:.1f} points.
- At least three of four searches find each nodule of more than {sure:.1f} JND, and fewer than one of four each of less than
  {unsure:.1f} JND.
"""

PEOPLE = """## Compared with people

Gerling et al. (Cancer Epidemiology 34, 2010, 79-84): 18 people with their fingers found spheres of 4 mm, 5 mm deep in
silicone of 21 kPa, more than 75 % of the time. In tissue of {tissue_kpa:g} kPa such a nodule raises the force on a finger-sized
sphere by less than one JND, even if it is {most:g} times as stiff. Force alone does not explain what people find; skin feels
the shape of the pressure too. An exercise on a device that renders the force on one point, and that is to be as easy as
an examination by hand, needs larger, shallower or stiffer nodules, or has to say that it exaggerates.

## Limitations

- Nothing was felt by people. The technique and its numbers of presses are chosen; a threshold below {threshold_jnd:g} JND would find
  more, with more false alarms. A rate that is not above the false alarms says nothing.
- The examiner remembers perfectly, and compares with the median of all places, which large and deep nodules raise too.
- One point and no skin: no shape of the pressure, sliding, lateral force, friction or vibration.
- The organ is linear, uniform but for the nodule, and as smooth as an ellipsoid.
- The smallest nodule is about as large as the elements (2.7 mm). With 16 elements across instead of {elements_across}, the rise of
  the force changed by at most 0.7 points above five nodules of 4 to 16 mm.
"""


def row(*cells):
    return "| " + " | ".join(map(str, cells)) + " |"


def rate(entry):
    return entry["found"] / entry["searches"]


def percent(part):
    return f"{100.0 * part:.0f} %"


def table(entries, ratios):
    lines = [row("diameter, depth", *[f"{ratio:g} x" for ratio in ratios]), row(*["---"] * (1 + len(ratios)))]
    kinds = dict.fromkeys((e["diameter_mm"], e["depth_mm"]) for e in entries)
    for diameter, depth in kinds:
        cells = [e for e in entries if (e["diameter_mm"], e["depth_mm"]) == (diameter, depth)]
        assert [e["ratio"] for e in cells] == ratios
        lines.append(row(f"{diameter:g} mm, {depth:g} mm deep",
                         *[f"{percent(rate(e))} ({e['contrast_jnd']:.1f})" for e in cells]))
    return "\n".join(lines) + "\n"


def check_people(entries):
    """What the page says of nodules of 4 mm, 5 mm deep."""
    cells = [e for e in entries if (e["diameter_mm"], e["depth_mm"]) == (4.0, 5.0)]
    assert max(e["contrast_jnd"] for e in cells) < 1.0 and max(map(rate, cells)) < 0.5, "reword the page"


def page(document):
    plain, *entries = document["rows"]
    assert "diameter_mm" not in plain
    ratios = list(dict.fromkeys(e["ratio"] for e in entries))
    settings = {**document["organ"], **document["hand"], **document["technique"]}
    perception = document["perception"]
    introduction = INTRODUCTION.format(
        **settings, searches=plain["searches"], axes=" x ".join(f"{a:g}" for a in settings["semi_axes_mm"]),
        ratios=", ".join(f"{r:g}" for r in ratios), weber=100.0 * perception["weber_fraction"],
        floor=perception["weber_fraction"] * perception["smallest_weber_force_n"])
    results = RESULTS.format(
        table=table(entries, ratios), alarms=plain["elsewhere"], searches=plain["searches"],
        alarm_rate=f"{100.0 * plain['elsewhere'] / plain['searches']:.1f} %",
        elsewhere=max(e["elsewhere"] for e in entries),
        error=100.0 * 0.5 / plain["searches"] ** 0.5,
        sure=math.ceil(10.0 * max(e["contrast_jnd"] for e in entries if rate(e) < 0.75)) / 10.0,
        unsure=math.floor(10.0 * min(e["contrast_jnd"] for e in entries if rate(e) >= 0.25)) / 10.0)
    check_people(entries)
    people = PEOPLE.format(**settings, most=ratios[-1])
    return "\n".join([introduction, results, people])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("searches", type=pathlib.Path)
    parser.add_argument("--page", type=pathlib.Path, default=ROOT / "Documentation" / "Evidence" / "VirtualExaminer.md")
    arguments = parser.parse_args()
    arguments.page.write_text(page(json.loads(arguments.searches.read_text())))


if __name__ == "__main__":
    main()
