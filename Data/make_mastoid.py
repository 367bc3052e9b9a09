"""Makes a scene to drill: the right mastoid of InVesalius' CT head, and a hand that opens it.

    python3 Data/make_mastoid.py CASE.inv3 FOLDER

Writes mastoid.nrrd (a box of the head without the scanner's head rest), mastoid.scene.json,
hand.csv and drill.json, for `palpate touch FOLDER/mastoid.scene.json --path FOLDER/hand.csv --drill
FOLDER/drill.json`. Lengths are mm of the whole head's frame. Needs Python's standard library only.
"""

import json
import math
import pathlib
import plistlib
import sys
import tarfile

from convert_invesalius import read_project, reverse_rows, write_nrrd

FIRST = (45, 105, 5)  # voxels: from the right, the front and below
SIZE = (70, 100, 60)
MIDDLE = (146.0, 28.0)  # mm, of the opening: from the front, from below
RADIUS = 8.0  # mm, of the hand's spirals
LAYERS = 6
DEPTH = 3.0  # mm, of a layer
OUTSIDE, SURFACE = 44.0, 62.0  # mm, from the right


def box_of(voxels, shape):
    """The bytes of a box of the head's voxels (int16, columns first)."""
    _, rows, columns = shape
    lines = []
    for k in range(FIRST[2], FIRST[2] + SIZE[2]):
        for j in range(FIRST[1], FIRST[1] + SIZE[1]):
            start = 2 * ((k * rows + j) * columns + FIRST[0])
            lines.append(voxels[start : start + 2 * SIZE[0]])
    return b"".join(lines)


def hand():
    """Places over time (s, mm), and when the pedal is pressed and let go."""
    y, z = MIDDLE
    places = [(0.0, OUTSIDE, y, z), (1.0, SURFACE - 8.0, y, z)]
    time = 1.0
    for layer in range(LAYERS):
        steps = 160
        for step in range(steps):
            part = step / (steps - 1)
            radius = RADIUS * math.sqrt(part) * (1.0 - 0.06 * layer)
            angle = 8.0 * math.pi * part
            time += 0.05
            places.append((time, SURFACE + DEPTH * layer, y + radius * math.cos(angle),
                           z + radius * math.sin(angle)))
        time += 0.3
        places.append((time, SURFACE + DEPTH * layer, y, z))
    places.append((time + 1.5, OUTSIDE, y, z))
    return places, (0.8, time + 0.2)


def main(arguments):
    if len(arguments) != 2:
        sys.exit(__doc__)
    source, folder = arguments[0], pathlib.Path(arguments[1])
    try:
        shape, spacing, voxels = read_project(source)
    except (OSError, KeyError, ValueError, tarfile.TarError, plistlib.InvalidFileException) as error:
        sys.exit(f"{source} is no project of InVesalius that can be converted: {error}")
    folder.mkdir(parents=True, exist_ok=True)
    origin = [first * step for first, step in zip(FIRST, spacing)]
    write_nrrd(folder / "mastoid.nrrd", box_of(reverse_rows(voxels, shape), shape), SIZE, spacing,
               origin)
    bone = {"name": "bone", "file": "mastoid.nrrd", "iso": 300, "stiffness_n_per_mm": 1.0,
            "drill": {"wear_mm_per_nm": 0.5, "drag_s_per_mm": 0.002, "vibration": 0.25}}
    scene = {"format": "palpate-scene", "structures": [bone], "scale": 1.5,
             "tool": {"shape": "sphere", "radius_mm": 3, "points": 0}}
    (folder / "mastoid.scene.json").write_text(json.dumps(scene, indent=2) + "\n")
    places, (start, stop) = hand()
    lines = ["%.3f,%.3f,%.3f,%.3f" % place for place in places]
    (folder / "hand.csv").write_text("time_s,x_mm,y_mm,z_mm\n" + "\n".join(lines) + "\n")
    actions = [{"time_s": start, "do": "start"}, {"time_s": round(stop, 3), "do": "stop"}]
    script = {"format": "palpate-drill", "actions": actions}
    (folder / "drill.json").write_text(json.dumps(script, indent=2) + "\n")


if __name__ == "__main__":
    main(sys.argv[1:])
