#!/usr/bin/python3
"""Lists every library of other projects in the archive, its Debian package and licence, and fails on the GPL.

  Utilities/licences.py FOLDER    the unpacked archive

The licence is the one that the package's copyright file gives for most files ("Files: *"), or one of JUDGED where
that file is not machine-readable. LGPL libraries may be bundled, since they are separate files that a
user can replace; of alternatives ("LGPL-3 or GPL-2") the one that is not the GPL counts.
"""
import pathlib
import re
import subprocess
import sys

SYSTEM = pathlib.Path("/usr/lib/x86_64-linux-gnu")

# As those files say, read by hand (Debian 12).
RUNTIME = "GPL-3+ with GCC Runtime Library Exception"
JUDGED = {
    "libgfortran5": RUNTIME,
    "libquadmath0": "LGPL-2.1+",
    "libbsd0": "BSD-3-clause",
    "libmd0": "BSD-3-clause",
    "libhwloc15": "BSD-3-clause",
    "libopenmpi3": "BSD-3-clause",
    "libusb-1.0-0": "LGPL-2.1+",
    "libopenigtlink1.11": "BSD-3-clause",
    "libwebp7": "BSD-3-clause",
    "libjpeg62-turbo": "BSD-3-clause and IJG",
    "libopenjp2-7": "BSD-2-clause",
    "libxcb": "MIT",
    "libxkbcommon0": "MIT",
    "libxkbcommon-x11-0": "MIT",
    "libxrender1": "MIT",
}


def origin(name):
    """The file of Debian that a bundled file is a copy of."""
    for path in [SYSTEM / name, SYSTEM.parent / name, *SYSTEM.glob(f"*/{name}"), *SYSTEM.glob(f"qt5/plugins/*/{name}")]:
        if path.exists():
            return path.resolve()
    raise SystemExit(f"licences.py: {name} is no library of Debian")


def package_of(path):
    # Debian 12 lists some files under /lib, which is a link to /usr/lib.
    for listed in [str(path), str(path).removeprefix("/usr")]:
        found = subprocess.run(["dpkg", "-S", listed], capture_output=True, text=True)
        if found.returncode == 0:
            return found.stdout.split(":")[0]
    raise SystemExit(f"licences.py: {path} belongs to no package of Debian")


def copyright_of(package):
    return pathlib.Path("/usr/share/doc") / package / "copyright"


def licence_of(package):
    if package in JUDGED:
        return JUDGED[package]
    if package.startswith("libxcb-"):
        return JUDGED["libxcb"]
    for paragraph in re.split(r"\n\s*\n", copyright_of(package).read_text(errors="replace")):
        if re.search(r"^Files:\s*\*\s*$", paragraph, re.M):
            licence = re.search(r"^License:\s*(\S.*)$", paragraph, re.M)
            if licence:
                return licence[1].strip()
    return "unknown"


def is_allowed(licence):
    alternatives = re.split(r"\bor\b", licence)
    return licence != "unknown" and any(
        re.search(r"\bA?GPL", alternative) is None or "Runtime Library Exception" in alternative
        for alternative in alternatives
    )


def bundled(folder):
    """Every library of others in the archive, by its name."""
    for path in sorted(folder.rglob("*.so*")):
        if not path.is_symlink() and not path.name.lower().startswith(("libpalpate", "libjbig")):
            yield path


def main():
    folder = pathlib.Path(sys.argv[1])
    refused = []
    packages = {}
    for path in bundled(folder):
        packages.setdefault(package_of(origin(path.name)), []).append(path.name)
    for package, names in sorted(packages.items()):
        licence = licence_of(package)
        if not is_allowed(licence):
            refused.append(package)
        print(f"{package:24} {licence:44} {' '.join(names)}")
    if refused:
        print(f"licences.py: not to be bundled, or unknown: {', '.join(refused)}", file=sys.stderr)
    return 1 if refused or not packages else 0


if __name__ == "__main__":
    sys.exit(main())
