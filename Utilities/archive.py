#!/usr/bin/python3
"""Makes the relocatable archive: the installed programs, the libraries that they need, and their licences.

  Utilities/archive.py BUILD-TREE ARCHIVE.tar.gz

The C and C++ libraries, OpenGL and X come from the system it is unpacked on, which has to be at least as new as the one it
was made on. The folder that is packed stays, next to the archive.
"""
import pathlib
import re
import shutil
import subprocess
import sys

import licences

# Of the system: they match its kernel, graphics card, X server or services, or are also loaded by its graphics
# driver, which may need newer ones than ours.
FOREIGN = re.compile(
    r"^(ld-linux|linux-vdso|lib(c|m|dl|rt|pthread|resolv|util|anl)\.so"
    r"|lib(GL|GLX|GLdispatch|OpenGL|EGL|drm|gbm|X11|X11-xcb|xcb|Xau|Xdmcp|ICE|SM)\.so"
    r"|lib(stdc\+\+|gcc_s|z|zstd|expat)\.so"
    r"|lib(udev|uuid|systemd|dbus-1|cap|gcrypt|gpg-error|fontconfig)\.so)"
)
# libtiff of VTK and ITK needs it, it is under the GPL, and we read no TIFF.
STUB = "libjbig.so.0"
PLUGINS = ["platforms/libqxcb.so", "platforms/libqoffscreen.so", "xcbglintegrations/libqxcb-glx-integration.so"]


def run(*words):
    subprocess.run(words, check=True, stdout=subprocess.DEVNULL)


def is_elf(path):
    return not path.is_symlink() and path.is_file() and path.open("rb").read(4) == b"\x7fELF"


def needed(files):
    """Libraries of the system that these files load, directly or through others: {name: path}."""
    found = {}
    for path in files:
        lines = subprocess.run(["ldd", path], capture_output=True, text=True).stdout.splitlines()
        for line in lines:
            match = re.match(r"\s*(\S+) => (/\S+)", line)
            if match and "libPalpate" not in match[1] and not FOREIGN.match(match[1]):
                found[match[1]] = match[2]
            elif "not found" in line:
                raise SystemExit(f"archive.py: {path}: {line.strip()}")
    return found


def bundle(folder):
    plugins = [licences.SYSTEM / "qt5/plugins" / plugin for plugin in PLUGINS]
    programs = [path for path in (folder / "bin").iterdir() if is_elf(path)]
    for name, source in needed(programs + plugins).items():
        if name == STUB:
            stub = pathlib.Path(__file__).parent.parent / "Packaging/jbig_stub.c"
            run("cc", "-shared", "-fPIC", "-O2", f"-Wl,-soname,{STUB}", "-o", folder / "lib" / STUB, stub)
        else:
            shutil.copy(pathlib.Path(source).resolve(), folder / "lib" / name)
            run("patchelf", "--set-rpath", "$ORIGIN", folder / "lib" / name)
    for plugin, source in zip(PLUGINS, plugins):
        target = folder / "lib/qt5/plugins" / plugin
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(source, target)
        run("patchelf", "--set-rpath", "$ORIGIN/../../..", target)
    (folder / "bin/qt.conf").write_text("[Paths]\nPrefix = ..\nPlugins = lib/qt5/plugins\n")


def add_licences(folder):
    target = folder / "share/doc/Palpate/licences"
    target.mkdir(parents=True, exist_ok=True)
    for path in licences.bundled(folder):
        package = licences.package_of(licences.origin(path.name))
        shutil.copy(licences.copyright_of(package), target / package)


def main():
    build, archive = sys.argv[1], pathlib.Path(sys.argv[2])
    folder = archive.parent / archive.name.removesuffix(".tar.gz")
    shutil.rmtree(folder, ignore_errors=True)
    for component in ["kernels", "runtime", "viewer"]:
        run("cmake", "--install", build, "--prefix", folder, "--component", component, "--strip")
    bundle(folder)
    add_licences(folder)
    run("tar", "--create", "--gzip", "--owner=0", "--group=0", "--sort=name", "--file", archive,
        "--directory", archive.parent, folder.name)


if __name__ == "__main__":
    main()
