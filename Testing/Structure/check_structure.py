"""Checks the repository's structure against rooms.json.

Rooms may include only the rooms and packages that the table names, and only rooms of a lower level;
each of these permissions is used; Documentation/Architecture.md lists the same; vtk.module files name
no other rooms; every source has its header, every module its page, no file is too long, no work is
left behind in comments. Prints one line a violation; exit code 1 where there is any.
"""

import argparse
import fnmatch
import json
import pathlib
import re
import sys

INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)
# Split, so that this file does not find itself.
LEFT_BEHIND = re.compile(r"\b(TO" r"DO|FIX" r"ME|XX" r"X)\b")
SOURCE_ENDINGS = {".h", ".cxx", ".cmake", ".py", ".sh", ".txt", ".module", ".in"}
# Not headers of the project or of a package: C and C++ standard library, POSIX.
SYSTEM_HEADER = re.compile(r"^([a-z_0-9]+|(sys/)?[a-z_0-9]+\.h)$")
PAGE_ROW = re.compile(
    r"^\| (\S+) \| `((?:Modules|Applications)/\w+)` \| (.*?) \| (.*?) \| (.*?) \|$", re.MULTILINE
)


def names_in(cell):
    """The names of a cell of the table; a dash for none."""
    return set() if cell == "–" else set(cell.split(", "))


class Checker:
    def __init__(self, root):
        self.root = root
        self.table = json.loads((root / "Testing/Structure/rooms.json").read_text())
        self.rooms = self.table["rooms"]
        self.names = {pathlib.PurePath(path).name: path for path in self.rooms}
        self.violations = []
        self.headers = {}
        self.used = {path: set() for path in self.rooms}  # rooms and packages that it includes

    def report(self, path, fact):
        self.violations.append(f"{path.relative_to(self.root)}: {fact}")

    def check(self):
        self.check_table()
        self.collect_headers()
        for path in self.rooms:
            self.check_room(self.root / path)
        self.check_modules_are_in_the_table()
        self.check_permissions_are_used()
        self.check_page()
        self.check_every_source()
        return self.violations

    def check_table(self):
        for path, room in self.rooms.items():
            for used in room["rooms"]:
                if self.rooms[self.names[used]]["level"] >= room["level"]:
                    self.report(self.root / path, f"may not use {used}, which is not below it")

    def sources_of(self, room):
        """The room's own sources, without its tests."""
        return [
            path
            for path in sorted(room.rglob("*"))
            if path.suffix in {".h", ".cxx"} and "Testing" not in path.relative_to(room).parts
        ]

    def collect_headers(self):
        for path in self.rooms:
            for source in self.sources_of(self.root / path):
                if source.suffix == ".h":
                    if source.name in self.headers:
                        self.report(source, f"another room has a header of this name: {self.headers[source.name]}")
                    self.headers.setdefault(source.name, pathlib.PurePath(path).name)

    def check_room(self, room):
        if not room.is_dir():
            self.report(room, "the room is in the table but not on disk")
            return
        if room.parent.name == "Modules" and not (room / "README.md").is_file():
            self.report(room, "has no README.md")
        for source in self.sources_of(room):
            if source.suffix == ".cxx" and source.name != "main.cxx":
                if not source.with_suffix(".h").is_file():
                    self.report(source, "has no header of the same name")
            self.check_includes(source, room)
        self.check_module_file(room)

    def check_includes(self, source, room):
        allowed = self.rooms[str(room.relative_to(self.root))]
        for header in INCLUDE.findall(source.read_text()):
            owner = self.headers.get(header)
            self.used[str(room.relative_to(self.root))].add(owner or self.package_of(header))
            if owner is not None:
                if owner != room.name and owner not in allowed["rooms"]:
                    self.report(source, f"includes {header} of room {owner}, which it may not use")
                continue
            if self.is_generated(header, allowed, room):
                continue
            package = self.package_of(header)
            if package is None:
                self.report(source, f"includes {header}, which no room or package of the table has")
            elif package != "system" and package not in allowed["externals"]:
                self.report(source, f"includes {header} of {package}, which it may not use")

    def is_generated(self, header, allowed, room):
        """Export headers that VTK's module system writes: Palpate<Room>Module.h."""
        match = re.fullmatch(r"Palpate(\w+)Module\.h", header)
        return match is not None and match[1] in [room.name, *allowed["rooms"]]

    def package_of(self, header):
        for package, patterns in self.table["externals"].items():
            if any(fnmatch.fnmatchcase(header, pattern) for pattern in patterns):
                return package
        return "system" if SYSTEM_HEADER.match(header) else None

    def check_module_file(self, room):
        module = room / "vtk.module"
        allowed = self.rooms[str(room.relative_to(self.root))]
        if not module.is_file():
            return
        text = module.read_text()
        if "VTK" not in allowed["externals"]:
            self.report(module, "a room without VTK has no vtk.module")
        for used in re.findall(r"Palpate::(\w+)", text):
            self.used[str(room.relative_to(self.root))].add(used)
            if used != room.name and used not in allowed["rooms"]:
                self.report(module, f"names room {used}, which it may not use")

    def check_modules_are_in_the_table(self):
        for folder in sorted((self.root / "Modules").iterdir()):
            if folder.is_dir() and f"Modules/{folder.name}" not in self.rooms:
                self.report(folder, "is not in Testing/Structure/rooms.json")

    def check_permissions_are_used(self):
        for path, room in self.rooms.items():
            for permission in [*room["rooms"], *room["externals"]]:
                if (self.root / path).is_dir() and permission not in self.used[path]:
                    self.report(self.root / path, f"may use {permission}, and does not")

    def check_page(self):
        """The table of Architecture.md: level, room, what it does, rooms, packages."""
        page = self.root / "Documentation/Architecture.md"
        listed = []
        for level, path, _, rooms, packages in PAGE_ROW.findall(page.read_text()):
            room = self.rooms.get(path)
            listed.append(path)
            if room is None:
                self.report(page, f"lists {path}, which is not in Testing/Structure/rooms.json")
                continue
            wanted = {"level": str(room["level"]), "rooms": set(room["rooms"]), "packages": set(room["externals"])}
            given = {"level": level, "rooms": names_in(rooms), "packages": names_in(packages)}
            for what in wanted:
                if wanted[what] != given[what]:
                    self.report(page, f"has other {what} for {path} than Testing/Structure/rooms.json")
        for path in self.rooms:
            if listed.count(path) != 1:
                self.report(page, f"lists {path} {listed.count(path)} times")

    def check_every_source(self):
        limit = self.table["largest_file_lines"]
        for top in self.table["sources"]:
            for path in sorted((self.root / top).rglob("*")):
                if not path.is_file() or path.suffix not in SOURCE_ENDINGS:
                    continue
                lines = path.read_text().splitlines()
                if len(lines) > limit:
                    self.report(path, f"has {len(lines)} lines; more than {limit} belong apart")
                for number, line in enumerate(lines, 1):
                    if LEFT_BEHIND.search(line):
                        self.report(path, f"line {number} leaves work behind")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("root", type=pathlib.Path, help="the repository")
    violations = Checker(parser.parse_args().root.resolve()).check()
    for violation in violations:
        print(violation)
    print(f"{len(violations)} violations")
    return 1 if violations else 0


if __name__ == "__main__":
    sys.exit(main())
