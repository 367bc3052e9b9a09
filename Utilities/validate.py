#!/usr/bin/python3
"""Fits every available mask with the default settings and writes the table of the results.

    Utilities/validate.py [--palpate PROGRAM] [--data FOLDER] [--output FILE]

PROGRAM is build/release/bin/palpate by default. FOLDER holds real test data (see Data/README.md);
missing data are omitted, with a remark. FILE is Documentation/Validation.md by default.
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
AAL = pathlib.Path("/usr/share/mricron/templates/aal.nii.gz")


def fit(program, masks, *options):
    """One result per structure; failures are results too, so the exit code is ignored."""
    command = [str(program), "fit", *map(str, masks), "--json", "--quiet", *options]
    run = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    return [json.loads(line) for line in run.stdout.splitlines()]


def coarsest_spacing(program, mask):
    run = subprocess.run([str(program), "info", str(mask), "--json"], stdout=subprocess.PIPE,
                         check=True, text=True)
    return max(json.loads(run.stdout.splitlines()[0])["geometry"]["spacing_mm"])


def row(*cells):
    return "| " + " | ".join(map(str, cells)) + " |"


def table(head, rows):
    return "\n".join([row(*head), row(*["---"] * len(head)), *rows])


def glands(program, folder):
    masks = sorted(folder.glob("prostate/picai/whole_gland_*")) + \
        sorted(folder.glob("prostate/whole_gland_*")) + sorted(folder.glob("prostate/promise12_*_label*"))
    rows, within, shares, dices, volumes = [], 0, [], [], []
    for result in fit(program, masks):
        name = pathlib.Path(result["input"]).name.split(".")[0]
        slice_mm = coarsest_spacing(program, result["input"])
        mask, volume = result["quality"]["mask"], result["volume_ml"]
        change = 100 * (volume["model"] / volume["mask"] - 1)
        share = mask["mean_mm"] / slice_mm
        good = share <= 0.125 and mask["dice"] >= 0.98 and abs(change) <= 1
        within += good
        shares.append(share)
        dices.append(mask["dice"])
        volumes.append(abs(change))
        to_mask = result["quality"]["surface_to_mask"]
        rows.append(row(name, f"{slice_mm:.2f}", f"{volume['mask']:.1f}", f"{mask['mean_mm']:.3f}",
                        f"1/{1 / share:.1f}", f"{mask['p95_mm']:.2f}", f"{mask['max_mm']:.2f}",
                        f"{mask['dice']:.4f}", f"{change:+.2f}", f"{to_mask['mean_mm']:.3f}",
                        f"{to_mask['max_mm']:.2f}", f"{result['star']['hidden_percent']:.2f}",
                        "yes" if good else "no"))
    if not rows:
        return "No whole-gland masks were available.\n"
    head = ["mask", "slice mm", "ml", "mean mm", "of a slice", "95 % mm", "max mm", "Dice",
            "volume %", "surface: mean mm", "surface: max mm", "hidden %", "target met"]
    return table(head, rows) + (
        f"\n\n{within} of {len(rows)} meet the target: mean distance at most an eighth of a slice, "
        f"Dice at least 0.98, volume within 1 %. Mean share of a slice 1/{len(shares) / sum(shares):.1f}, "
        f"lowest Dice {min(dices):.4f}, largest change of volume {max(volumes):.2f} %.\n")


def others(program, folder):
    masks = sorted(folder.glob("prostate/picai/zones_*")) + \
        sorted(folder.glob("prostate/picai/lesion_*")) + sorted(folder.glob("prostate/msd_*"))
    rows = []
    for result in fit(program, masks):
        name = pathlib.Path(result["input"]).name.split(".")[0]
        mask = result["quality"]["mask"]
        fitted = result["status"] == "fitted"
        rows.append(row(name, result["label"], f"{result['volume_ml']['mask']:.2f}",
                        result["status"], f"{result['star']['hidden_percent']:.1f}",
                        f"{mask['mean_mm']:.3f}" if fitted else "",
                        f"{mask['dice']:.4f}" if fitted else ""))
    if not rows:
        return "No masks of zones and lesions were available.\n"
    return table(["mask", "label", "ml", "status", "hidden %", "mean mm", "Dice"], rows) + "\n"


def atlas(program):
    if not AAL.exists():
        return "The package mricron-data is not installed.\n"
    results = fit(program, [AAL])
    fitted = [r for r in results if r["status"] == "fitted"]
    refused = [r for r in results if r["status"] == "refused"]
    other = [r for r in results if r["status"] not in ("fitted", "refused")]
    rows = [row(r["name"], f"{r['volume_ml']['mask']:.2f}", f"{r['star']['hidden_percent']:.1f}",
                f"{r['quality']['mask']['mean_mm']:.3f}", f"{r['quality']['mask']['max_mm']:.2f}",
                f"{r['quality']['mask']['dice']:.4f}") for r in fitted]
    names = ", ".join(f"{r['name']} ({r['star']['hidden_percent']:.0f} %)" for r in refused)
    return (f"Of {len(results)} structures {len(fitted)} are fitted, {len(refused)} refused because "
            f"more than 10 % of their surface is hidden from the centre, {len(other)} neither.\n\n" +
            table(["structure", "ml", "hidden %", "mean mm", "max mm", "Dice"], rows) +
            f"\n\nRefused (hidden): {names}.\n")


def phantoms(program):
    rows, errors = [], []
    spacings = [("2,2,2", 2.0), ("1,1,1", 1.0), ("0.5,0.5,0.5", 0.5), ("0.5,0.5,3", None)]
    for text, step in spacings:
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([str(program), "phantom", "--output", folder, "--spacing", text,
                            "--noise", "0", "--degree", "8", "--quiet"], check=True,
                           stdout=subprocess.DEVNULL)
            truth = json.loads(pathlib.Path(folder, "truth.json").read_text())
            center = ",".join(repr(x) for x in truth["center_mm"])
            out = pathlib.Path(folder, "out")
            result = fit(program, [pathlib.Path(folder, "mask.nii.gz")], f"--center={center}",
                         "--output", str(out))[0]
            found = json.loads((out / "model.json").read_text())["coefficients_mm"]
            exact = truth["coefficients_mm"] + [0.0] * (len(found) - len(truth["coefficients_mm"]))
            # Root mean square over the sphere of the difference of the radii, by Parseval's
            # theorem.
            error = (sum((a - b) ** 2 for a, b in zip(found, exact)) / 12.566370614359172) ** 0.5
            if step:
                errors.append((step, error))
            rows.append(row(text.replace(",", " x "), f"{error:.4f}",
                            f"{result['quality']['mask']['dice']:.4f}",
                            f"{result['quality']['mask']['mean_mm']:.3f}"))
    import math
    (h0, e0), (h1, e1) = errors[0], errors[-1]
    order = math.log(e0 / e1) / math.log(h0 / h1)
    return (table(["voxels mm", "RMS radius error mm", "Dice with the mask",
                   "mean distance to the mask mm"], rows) +
            f"\n\nOrder of convergence on cubes from 2 to 0.5 mm: {order:.2f}.\n")


def speed(program, folder):
    masks = sorted(folder.glob("prostate/picai/whole_gland_10003*"))
    if not masks:
        return "The mask to time was not available.\n"
    with tempfile.TemporaryDirectory() as out:
        runs = [fit(program, masks, "--output", out)[0] for _ in range(5)]
    best = min(runs, key=lambda r: r["seconds"]["total"])
    rows = [row(stage, f"{seconds * 1000:.0f}") for stage, seconds in best["seconds"].items()]
    return (f"Fastest of five runs of `palpate fit` on {masks[0].name} (384 x 384 x 23), with all "
            f"its files and the report; peak memory {best['peak_memory_mb']:.0f} MB.\n\n" +
            table(["stage", "ms"], rows) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--palpate", type=pathlib.Path, default=ROOT / "build/release/bin/palpate")
    parser.add_argument("--data", type=pathlib.Path, default=ROOT / "../shared/data")
    parser.add_argument("--output", type=pathlib.Path, default=ROOT / "Documentation/Validation.md")
    arguments = parser.parse_args()
    program = arguments.palpate
    if not program.exists():
        sys.exit(f"{program} is not built; run Utilities/build.sh first")
    sections = [
        ("Whole glands", "Model and surface against the mask's own half-level boundary; distances "
         "are symmetric and weighted by area, with equal weight of both directions.",
         glands(program, arguments.data)),
        ("Zones and lesions", "", others(program, arguments.data)),
        ("A whole head: the 116 structures of AAL", "", atlas(program)),
        ("Known bodies", "Prostate-like phantoms of degree 8, fitted at degree 12 around their true "
         "centre.", phantoms(program)),
        ("Time and memory", "", speed(program, arguments.data)),
    ]
    text = ["# Validation", "", "Made by `Utilities/validate.py`; default settings (degree 12, "
            "frequency 20) unless stated otherwise.", ""]
    for title, remark, body in sections:
        text += [f"## {title}", ""] + ([remark, ""] if remark else []) + [body]
    arguments.output.write_text("\n".join(text))
    print(f"wrote {arguments.output}")


if __name__ == "__main__":
    main()
