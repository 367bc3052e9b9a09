"""Checks the repository's structure against modules.json.

Modules may include only the modules and packages that the table permits, and only modules of a lower
level; each permission is used; Documentation/Architecture.md lists the same; vtk.module files name no
other modules; folders do not include each other in circles; every source has its header, every module its
README, no file and no folder is too long, no type is defined twice in a namespace, sources that may be compiled
as one share no names, public headers are few and include no others, comments hold no unfinished work, and pages
have short lines and no broken links. Prints one line per violation; exits with 1 if there is any.
"""

import argparse
import fnmatch
import json
import pathlib
import re
import sys

INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)
# Split, so that this file does not match itself.
UNFINISHED = re.compile(r"\b(TO" r"DO|FIX" r"ME|XX" r"X)\b")
SOURCE_ENDINGS = {".h", ".cxx", ".cmake", ".py", ".sh", ".txt", ".module", ".in"}
# A file's own names, and how each is declared at the start of a line: constant, type or function.
OWN_NAMES = re.compile(r"\nnamespace\n\{\n(.*?)\n\} // namespace\n", re.DOTALL)
OWN_NAME = re.compile(
    r"^(?:(?:constexpr|const) [\w:<>, ]+ (\w+)(?:\[\])? ?[={]|(?:struct|class|enum class) (\w+)"
    r"|[\w:<>,*& ]+?[ *&](\w+\([^{};]*\))(?: noexcept)?\n\{)",
    re.MULTILINE,
)
ALIAS = re.compile(r"^using (\w+) =\s*([^;]+);", re.MULTILINE)
IMPORTED = re.compile(r"^using ([\w:]+::(\w+));", re.MULTILINE)
TYPE = re.compile(r"^(?:struct|class|union|enum(?: class)?) (?:\w+_EXPORT )?(\w+)(?: final)?(?: :[^;\n]*)?$", re.MULTILINE)
PARAMETER = re.compile(r"\s*\b\w+(?=[,)])")
# Neither the project's nor a package's: C and C++ standard library, POSIX.
SYSTEM_HEADER = re.compile(r"^([a-z_0-9]+|((sys|netinet)/)?[a-z_0-9]+\.h)$")
PAGE_ROW = re.compile(
    r"^\| (\S+) \| `((?:Modules|Applications)/\w+)` \| (.*?) \| (.*?) \| (.*?) \|$", re.MULTILINE
)


LONGEST_LINE = 120  # of prose; tables, links, images and code may be longer, and CHANGELOG.md has a line for each entry
LINK = re.compile(r"\]\(([^)\s]*)\)")
LIST_ITEM = re.compile(r"^\s*([-*]|\d+\.)\s")


def prose_of(text):
    """Numbered lines of a page outside of code and tables."""
    fence, in_list = None, False
    for number, line in enumerate(text.splitlines(), 1):
        mark = re.match(r"^\s*(```+)", line)
        if fence or mark:
            fence = (None if line.strip() == fence else fence) if fence else mark[1]
            continue
        in_list = bool(LIST_ITEM.match(line)) or in_list and (not line or line.startswith(" "))
        if not line.lstrip().startswith(("|", "![")) and (in_list or not line.startswith("    ")):
            yield number, line


def anchors_in(text):
    """The anchors of a page's headings, as GitHub makes them."""
    headings = re.findall(r"^#+ (.*)$", text, re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading).strip().lower().replace(" ", "-") for heading in headings}


def names_in(cell):
    """The names of a cell of the table; a dash for none."""
    return set() if cell == "–" else set(cell.split(", "))


class Checker:
    def __init__(self, root):
        self.root = root
        self.table = json.loads((root / "Testing/Structure/modules.json").read_text())
        self.modules = self.table["modules"]
        self.names = {pathlib.PurePath(path).name: path for path in self.modules}
        self.violations = []
        self.headers = {}
        self.used = {path: set() for path in self.modules}  # modules and packages that it includes

    def report(self, path, fact):
        self.violations.append(f"{path.relative_to(self.root)}: {fact}")

    def check(self):
        self.check_table()
        self.collect_headers()
        for path in self.modules:
            self.check_module(self.root / path)
            self.check_folder_circles(self.root / path)
            self.check_own_names(self.root / path)
        self.check_types_are_defined_once()
        self.check_public_headers()
        self.check_modules_are_in_the_table()
        self.check_permissions_are_used()
        self.check_page()
        self.check_prose_and_links()
        self.check_every_source()
        self.check_folder_sizes()
        return self.violations

    def check_table(self):
        for path, module in self.modules.items():
            for used in module["modules"]:
                if self.modules[self.names[used]]["level"] >= module["level"]:
                    self.report(self.root / path, f"may not use {used}, which is not below it")

    def sources_of(self, module):
        """The module's own sources, without its tests."""
        return [
            path
            for path in sorted(module.rglob("*"))
            if path.suffix in {".h", ".cxx"} and "Testing" not in path.relative_to(module).parts
        ]

    def collect_headers(self):
        for path in self.modules:
            for source in self.sources_of(self.root / path):
                if source.suffix == ".h":
                    if source.name in self.headers:
                        self.report(source, f"another module has a header of this name: {self.headers[source.name]}")
                    self.headers.setdefault(source.name, pathlib.PurePath(path).name)

    def check_module(self, module):
        if not module.is_dir():
            self.report(module, "the module is in the table but not on disk")
            return
        if module.parent.name == "Modules" and not (module / "README.md").is_file():
            self.report(module, "has no README.md")
        for source in self.sources_of(module):
            if source.suffix == ".cxx" and source.name != "main.cxx":
                if not source.with_suffix(".h").is_file():
                    self.report(source, "has no header of the same name")
            self.check_includes(source, module)
        self.check_module_file(module)

    def check_includes(self, source, module):
        allowed = self.modules[str(module.relative_to(self.root))]
        for header in INCLUDE.findall(source.read_text()):
            owner = self.headers.get(header)
            self.used[str(module.relative_to(self.root))].add(owner or self.package_of(header))
            if owner is not None:
                if owner != module.name and owner not in allowed["modules"]:
                    self.report(source, f"includes {header} of module {owner}, which it may not use")
                continue
            if self.is_generated(header, allowed, module):
                continue
            package = self.package_of(header)
            if package is None:
                self.report(source, f"includes {header}, which no module or package of the table has")
            elif package != "system" and package not in allowed["externals"]:
                self.report(source, f"includes {header} of {package}, which it may not use")

    def is_generated(self, header, allowed, module):
        """Export headers that VTK's module system writes: Palpate<Name>Module.h."""
        match = re.fullmatch(r"Palpate(\w+)Module\.h", header)
        return match is not None and match[1] in [module.name, *allowed["modules"]]

    def package_of(self, header):
        for package, patterns in self.table["externals"].items():
            if any(fnmatch.fnmatchcase(header, pattern) for pattern in patterns):
                return package
        return "system" if SYSTEM_HEADER.match(header) else None

    def check_module_file(self, module):
        module_file = module / "vtk.module"
        allowed = self.modules[str(module.relative_to(self.root))]
        if not module_file.is_file():
            return
        text = module_file.read_text()
        with_vtk = [used for used in allowed["modules"] if (self.root / self.names[used] / "vtk.module").is_file()]
        if "VTK" not in allowed["externals"] and not with_vtk:
            self.report(module_file, "a module without VTK must not have a vtk.module")
        for used in re.findall(r"Palpate::(\w+)", text):
            self.used[str(module.relative_to(self.root))].add(used)
            if used != module.name and used not in allowed["modules"]:
                self.report(module_file, f"names module {used}, which it may not use")

    def check_modules_are_in_the_table(self):
        for folder in sorted((self.root / "Modules").iterdir()):
            if folder.is_dir() and f"Modules/{folder.name}" not in self.modules:
                self.report(folder, "is not in Testing/Structure/modules.json")

    def check_permissions_are_used(self):
        for path, module in self.modules.items():
            for permission in [*module["modules"], *module["externals"]]:
                if (self.root / path).is_dir() and permission not in self.used[path]:
                    self.report(self.root / path, f"may use {permission}, but does not")

    def check_page(self):
        """The table of Architecture.md: level, module, purpose, modules, packages."""
        page = self.root / "Documentation/Architecture.md"
        listed = []
        for level, path, _, modules, packages in PAGE_ROW.findall(page.read_text()):
            module = self.modules.get(path)
            listed.append(path)
            if module is None:
                self.report(page, f"lists {path}, which is not in Testing/Structure/modules.json")
                continue
            wanted = {"level": str(module["level"]), "modules": set(module["modules"]), "packages": set(module["externals"])}
            given = {"level": level, "modules": names_in(modules), "packages": names_in(packages)}
            for what in wanted:
                if wanted[what] != given[what]:
                    self.report(page, f"has other {what} for {path} than Testing/Structure/modules.json")
        for path in self.modules:
            if listed.count(path) != 1:
                self.report(page, f"lists {path} {listed.count(path)} times")

    def check_prose_and_links(self):
        for page in self.pages():
            text = page.read_text()
            for number, line in prose_of(text):
                if len(LINK.sub("]()", line)) > LONGEST_LINE and page.name != "CHANGELOG.md":
                    self.report(page, f"line {number} is longer than {LONGEST_LINE} characters")
            for target in LINK.findall(text):
                self.check_link(page, target)

    def pages(self):
        """The pages of the repository, without those of builds."""
        tops = [self.root / top for top in (*self.table["sources"], "Documentation", "Data")]
        return sorted(self.root.glob("*.md")) + [page for top in tops for page in sorted(top.rglob("*.md"))]

    def check_link(self, page, target):
        path, _, anchor = target.partition("#")
        if re.match(r"\w+:", target):
            return
        file = page.parent / path if path else page
        if not file.exists():
            self.report(page, f"links to {target}, which does not exist")
        elif anchor and anchor not in anchors_in(file.read_text()):
            self.report(page, f"links to {target}, which has no such heading")

    def folder_includes(self, module):
        """For each folder of a module, its other folders that it includes headers of, with an example."""
        sources = self.sources_of(module)
        folder_of = {source.name: source.parent for source in sources if source.suffix == ".h"}
        includes = {source.parent: {} for source in sources}
        for source in sources:
            for header in INCLUDE.findall(source.read_text()):
                target = folder_of.get(header, source.parent)
                if target != source.parent:
                    includes[source.parent].setdefault(target, f"{source.name} includes {header}")
        return includes

    def check_folder_circles(self, module):
        """Removes folders that include none, or are included by none, of those left; circles remain."""
        left = self.folder_includes(module)
        ends = True
        while ends:
            included = {target for targets in left.values() for target in targets}
            ends = [folder for folder in left if folder not in included or not set(left[folder]) & set(left)]
            left = {folder: targets for folder, targets in left.items() if folder not in ends}
        for folder, targets in left.items():
            for target in targets:
                if target in left:
                    fact = f"is in a circle of includes with {target.relative_to(self.root)}: {targets[target]}"
                    self.report(folder, fact)

    def check_own_names(self, module):
        """Sources that may be compiled as one declare no name of their own alike, nor for things of two sorts."""
        build = module / "CMakeLists.txt"
        if build.is_file() and "UNITY_BUILD OFF" in build.read_text():
            return
        declared = {}
        sorts = {}
        aliases = {}
        for source in self.sources_of(module):
            text = source.read_text()
            outer = tuple(re.findall(r"^namespace ([\w:]+)", text, re.MULTILINE))
            for names in OWN_NAMES.findall(text):
                own = [(kind, "a type of its own") for _, kind, _ in OWN_NAME.findall(names) if kind]
                own += [(name, meaning) for meaning, name in IMPORTED.findall(names)]
                for name, meaning in ALIAS.findall(names) + own:
                    other, place = aliases.setdefault((outer, name), (meaning, source))
                    if other != meaning:
                        self.report(source, f"gives {name} another meaning than {place.name} does; both may be compiled as one")
                for constant, kind, function in OWN_NAME.findall(names):
                    name = constant or kind or " ".join(PARAMETER.sub("", function).split())
                    first = declared.setdefault((outer, name), source)
                    if first != source:
                        self.report(source, f"declares {name}, as {first.name} does; both may be compiled as one")
                    sort = "a constant" if constant else "a type" if kind else "a function"
                    bare = name.split("(")[0]
                    other, place = sorts.setdefault((outer, bare), (sort, source))
                    if other != sort and place != source:
                        self.report(source, f"declares {bare} as {sort}, {place.name} as {other}; both may be compiled as one")

    def check_types_are_defined_once(self):
        """Two types of one name in a namespace share their destructors, and the linker says nothing."""
        defined = {}
        for module in self.modules:
            for source in self.sources_of(self.root / module):
                text = OWN_NAMES.sub("\n", source.read_text())
                outer = tuple(re.findall(r"^namespace ([\w:]+)", text, re.MULTILINE))
                for name in TYPE.findall(text):
                    first = defined.setdefault((outer, name), source)
                    if first != source:
                        self.report(source, f"defines {name}, as {first.relative_to(self.root)} does")

    def check_public_headers(self):
        """Those of CMake/PalpatePublicHeaders.cmake and the VTK classes."""
        page = self.root / "CMake/PalpatePublicHeaders.cmake"
        listed = re.search(r"set\(PALPATE_PUBLIC_HEADERS\s([^)]*)\)", page.read_text())[1].split()
        sources = {path.name: path for module in self.modules for path in self.sources_of(self.root / module)}
        public = {f"{name}.h" for name in listed}
        for name in sorted(public - sources.keys()):
            self.report(page, f"lists {name}, which does not exist")
        public |= {name for name in sources if name.startswith("vtk") and name.endswith(".h")}
        if len(public) > self.table["most_public_headers"]:
            self.report(page, f"makes {len(public)} headers public; the limit is {self.table['most_public_headers']}")
        for name in sorted(public & sources.keys()):
            for included in INCLUDE.findall(sources[name].read_text()):
                if included in sources and included not in public:
                    self.report(sources[name], f"is public and includes {included}, which is not")

    def check_folder_sizes(self):
        """The lines of a folder's own sources, without those of its sub-folders."""
        limit = self.table["largest_folder_lines"]
        for top in self.table["sources"]:
            for folder in [self.root / top, *sorted((self.root / top).rglob("*/"))]:
                sources = [path for path in folder.glob("*") if path.suffix in {".h", ".cxx", ".py"}]
                lines = sum(len(path.read_text().splitlines()) for path in sources)
                if lines > limit:
                    self.report(folder, f"has {lines} lines; the limit is {limit}")

    def check_every_source(self):
        limit = self.table["largest_file_lines"]
        for top in self.table["sources"]:
            for path in sorted((self.root / top).rglob("*")):
                if not path.is_file() or path.suffix not in SOURCE_ENDINGS:
                    continue
                lines = path.read_text().splitlines()
                if len(lines) > limit:
                    self.report(path, f"has {len(lines)} lines; the limit is {limit}")
                for number, line in enumerate(lines, 1):
                    if UNFINISHED.search(line):
                        self.report(path, f"line {number} holds unfinished work")


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
