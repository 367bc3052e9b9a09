"""Converts a project file of InVesalius (.inv3) to an image that Palpate reads (.nrrd).

    python3 Data/convert_invesalius.py CASE.inv3 OUTPUT.nrrd

The project is a compressed tar archive: main.plist describes the matrix of voxels (int16, slices
from below to above, rows as VTK has them, from the back to the front), which lies beside it. Rows
are written from the front to the back, so the result is in LPS with a plain direction; the place
in the scanner is not kept in the project, and the origin is the first voxel. Needs Python's
standard library only.
"""

import gzip
import pathlib
import plistlib
import sys
import tarfile


def read_project(path):
    """Shape (slices, rows, columns), spacing (x, y, z, mm) and the voxels' bytes."""
    with tarfile.open(path) as archive:
        members = {pathlib.PurePath(member.name).name: member for member in archive.getmembers()}
        main = plistlib.loads(archive.extractfile(members["main.plist"]).read())
        matrix = main["matrix"]
        if matrix["dtype"] != "int16":
            raise ValueError(f"{path}: voxels are {matrix['dtype']}, and only int16 is known")
        voxels = archive.extractfile(members[matrix["filename"]]).read()
    shape = matrix["shape"]
    if len(voxels) != 2 * shape[0] * shape[1] * shape[2]:
        raise ValueError(f"{path}: the voxels do not have the size that main.plist states")
    return shape, main["spacing"], voxels


def reverse_rows(voxels, shape):
    slices, rows, columns = shape
    row_bytes = 2 * columns
    lines = [voxels[start : start + row_bytes] for start in range(0, len(voxels), row_bytes)]
    turned = []
    for number in range(slices):
        turned += reversed(lines[number * rows : (number + 1) * rows])
    return b"".join(turned)


def write_nrrd(path, voxels, size, spacing, origin):
    """Voxels (int16, little-endian) of a grid along the patient's axes, LPS; mm."""
    directions = " ".join(
        "(" + ",".join(str(step) if axis == number else "0" for axis in range(3)) + ")"
        for number, step in enumerate(spacing)
    )
    header = (
        "NRRD0004\ntype: int16\ndimension: 3\nspace: left-posterior-superior\n"
        f"sizes: {size[0]} {size[1]} {size[2]}\nspace directions: {directions}\n"
        "kinds: domain domain domain\nendian: little\nencoding: gzip\n"
        f"space origin: ({','.join(str(place) for place in origin)})\n\n"
    )
    with open(path, "wb") as file:
        file.write(header.encode("ascii"))
        file.write(gzip.compress(voxels, 6, mtime=0))


def main(arguments):
    if len(arguments) != 2:
        sys.exit(__doc__)
    source, target = arguments
    try:
        shape, spacing, voxels = read_project(source)
    except (OSError, KeyError, ValueError, tarfile.TarError, plistlib.InvalidFileException) as error:
        sys.exit(f"{source} is no project of InVesalius that can be converted: {error}")
    write_nrrd(target, reverse_rows(voxels, shape), shape[::-1], spacing, (0, 0, 0))


if __name__ == "__main__":
    main(sys.argv[1:])
