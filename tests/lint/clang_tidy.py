#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""clang_tidy.py BUILD [SOURCE…]: runs clang-tidy over the sources of core, ui, app and resources that BUILD compiles.

A source is checked again only when it, a header of ours that it includes, or the rules have changed. BUILD must have
been built, because some sources are generated. Sources without findings are recorded next to the compiler's cache, not
in BUILD, so that a fresh clone on the same machine checks only what is new.

Most of the time is spent on the headers of libraries, so the sources of a folder are checked together, in few
translation units. Only a clean result of such a unit counts: if there are findings, its sources are checked separately,
and those results count. If names clash, the later source goes into another unit. Sources given as arguments are checked
separately from the start.
"""
import collections
import concurrent.futures
import functools
import hashlib
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(sys.argv[1]).resolve()
NAMED = {str(pathlib.Path(source).resolve().relative_to(ROOT)) for source in sys.argv[2:]}
REMEMBERED = pathlib.Path(os.environ.get("XDG_CACHE_HOME", pathlib.Path.home() / ".cache")) / "proveout/clang-tidy"
UNITS = BUILD / "clang-tidy"
ROOMS = ("core/", "ui/", "app/", "resources/")
FEWEST_TOGETHER = 2
MOST_TOGETHER = 150  # about 4 GB of memory with Qt's headers
KEPT_DAYS = 30


INCLUDED = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.MULTILINE)


def sources_of(file):
    """The source itself, or the sources that CMake has combined in it."""
    if "/Unity/unity_" not in file:
        return [file]
    return INCLUDED.findall(pathlib.Path(file).read_text())


def commands():
    """Source → the compiler's arguments without its name, source and output."""
    found = {}
    for entry in json.loads((BUILD / "compile_commands.json").read_text()):
        arguments = shlex.split(entry["command"].replace("-isystem ", "-isystem"))
        output = arguments.index("-o")
        del arguments[output:output + 2]
        arguments = [a for a in arguments[1:] if a not in ("-c", entry["file"], "-Winvalid-pch")]
        if "-include" in arguments:  # headers precompiled by another compiler; the sources include what they need
            precompiled = arguments.index("-include")
            del arguments[precompiled:precompiled + 2]
        for file in sources_of(entry["file"]):
            source = os.path.relpath(file, ROOT)
            if source.startswith(ROOMS):
                found[source] = arguments
    return found


@functools.cache
def included(file):
    """The files of this repository that a file of it includes."""
    return [name for name in INCLUDED.findall((ROOT / file).read_text()) if (ROOT / name).is_file()]


def dependencies(source):
    """The source and the headers of this repository that it includes, directly or not."""
    found = [source]
    for file in found:
        found += [name for name in dict.fromkeys(included(file)) if name not in found]
    return found


def rules(compiled):
    """Everything besides the sources that affects the findings. The location of the clone does not."""
    version = subprocess.run(["clang-tidy", "--version"], check=True, capture_output=True, text=True).stdout
    options = {a.replace(f"{ROOT}/", "") for arguments in compiled.values() for a in arguments
               if re.match(r"-([DfmOW]|std)", a)}
    return (ROOT / ".clang-tidy").read_text() + version + "\n".join(sorted(options))


def key(ruling, files):
    digest = hashlib.sha256(ruling.encode())
    for file in files:
        digest.update(file.encode() + b"\0" + (ROOT / file).read_bytes())
    return REMEMBERED / digest.hexdigest()[:40]


def quoted(path):
    """Escapes for LLVM's regular expressions, which support fewer escapes than Python's."""
    return re.sub(r"([][.*+?^${}()|\\])", r"\\\1", str(path))


def tidy(*arguments):
    done = subprocess.run(["clang-tidy", "--quiet", f"--config-file={ROOT}/.clang-tidy", *arguments], cwd=ROOT, stdout=subprocess.PIPE,
                          stderr=subprocess.DEVNULL, text=True, check=False)
    return done.returncode == 0, done.stdout


class Check:
    def __init__(self):
        self.compiled = commands()
        ruling = rules(self.compiled)
        self.keys = {source: key(ruling, dependencies(source)) for source in self.compiled}
        self.units = 0
        self.failed = 0
        self.pool = concurrent.futures.ThreadPoolExecutor(os.cpu_count())
        self.running = set()

    def pending(self):
        """Sources to be checked; records that are still in use are kept."""
        for source, remembered in sorted(self.keys.items()):
            if NAMED and source not in NAMED:
                continue
            if remembered.exists():
                remembered.touch()
            else:
                yield source

    def start(self, sources):
        """Starts units with at most MOST_TOGETHER sources of a folder each."""
        rooms = collections.defaultdict(list)
        for source in sorted(sources):
            rooms[source if NAMED else source.partition("/")[0]].append(source)
        for room in rooms.values():
            count = -(-len(room) // MOST_TOGETHER)
            for i in range(count):
                self.start_unit(room[len(room) * i // count:len(room) * (i + 1) // count])

    def start_unit(self, sources):
        if len(sources) < FEWEST_TOGETHER:
            for source in sources:
                self.running.add(self.pool.submit(self.apart, source))
        else:
            self.units += 1
            self.running.add(self.pool.submit(self.together, sources, UNITS / f"unit{self.units}.cpp"))

    def together(self, sources, unit):
        """Records sources without findings; returns those to check separately, and those for another unit."""
        arguments = list(dict.fromkeys(a for source in sources for a in self.compiled[source]))
        standing = self.without_clashes(sources, unit, arguments)
        elsewhere = [source for source in sources if source not in standing]
        if len(standing) < FEWEST_TOGETHER:
            return sources, []
        clean, output = self.unit(standing, unit, arguments)
        if not clean:
            apart = self.named(standing, output) or standing
            return apart, elsewhere + [source for source in standing if source not in apart]
        for source in standing:
            self.keys[source].touch()
        return [], elsewhere

    def without_clashes(self, sources, unit, arguments):
        """The sources that compile as one unit. Runs a single check, because the others take most of the time."""
        while sources:
            _, output = self.unit(sources, unit, arguments, "--checks=-*,modernize-use-nullptr")
            clashing = self.named(sources, output, "clang-diagnostic-error") or self.hiding(sources, output)
            if not clashing:
                break
            sources = [source for source in sources if source not in clashing]
        return sources

    def unit(self, sources, unit, arguments, *options):
        unit.write_text("".join(f'#include "{ROOT / source}" // NOLINT\n' for source in sources))
        # In a unit, a name hides that of another source. The compiler reports hidden names in each source.
        return tidy(f"--header-filter=^{quoted(ROOT)}/({'|'.join(ROOMS)})", *options, unit, "--", *arguments, "-ferror-limit=0",
                    "-Wno-shadow")

    def named(self, sources, output, check=r"[\w.-]+"):
        places = re.findall(rf"^([^:\n]+):\d+:\d+: error: .*\[{check}[\],]", output, re.MULTILINE)
        files = {os.path.relpath(path, ROOT) for path in places}
        return [source for source in sources if source in files]

    def hiding(self, sources, output):
        """Those with a name that hides that of a header: the error is in the header, its notes lead to the source."""
        places = re.findall(r"^([^:\n]+):\d+:\d+: note: ", output, re.MULTILINE)
        files = {os.path.relpath(path, ROOT) for path in places}
        return [source for source in sources if source in files]

    def apart(self, source):
        clean, output = tidy(ROOT / source, "--", *self.compiled[source])
        if clean:
            self.keys[source].touch()
        else:
            print(f"clang-tidy {source}\n{output}", flush=True)
            self.failed += 1
        return [], []

    def run(self):
        rest = list(self.pending())
        print(f"clang-tidy: {len(self.keys)} sources, {len(rest)} to check", flush=True)
        while rest:
            self.start(rest)
            rest = []
            while self.running:
                done, self.running = concurrent.futures.wait(self.running, return_when="FIRST_COMPLETED")
                for unit in done:
                    apart, elsewhere = unit.result()
                    rest += elsewhere
                    for source in apart:
                        self.running.add(self.pool.submit(self.apart, source))
        return 1 if self.failed else 0


if __name__ == "__main__":
    REMEMBERED.mkdir(parents=True, exist_ok=True)
    UNITS.mkdir(exist_ok=True)
    for old in REMEMBERED.iterdir():
        if old.stat().st_mtime < time.time() - KEPT_DAYS * 86400:
            old.unlink()
    sys.exit(Check().run())
