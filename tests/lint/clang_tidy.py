#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""clang_tidy.py BUILD [SOURCE…]: runs clang-tidy over the sources of core, ui, app and resources that BUILD compiles.

A source is checked again only when it, a header of ours that it includes, or the rules have changed: the dependencies
are those Ninja has recorded, so BUILD must have been built. What was found clean is remembered beside the compiler's
cache, not in BUILD, so that a fresh clone on the same machine checks what is new only.

Most of the time goes into the headers of libraries, so sources that are compiled alike are checked together, as one
translation unit. That may only acquit: where something is found, or sources do not stand together because names
clash, they are checked apart, and that counts. Sources that are named are checked apart at once.
"""
import collections
import concurrent.futures
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
FEWEST_TOGETHER = 3
MOST_TOGETHER = 20  # about 1 GB of memory with Qt's headers
KEPT_DAYS = 30


def commands():
    """Source → (compiler's arguments without source and output, object's folder)."""
    found = {}
    for entry in json.loads((BUILD / "compile_commands.json").read_text()):
        source = os.path.relpath(entry["file"], ROOT)
        if not source.startswith(ROOMS):
            continue
        arguments = shlex.split(entry["command"])
        output = arguments.index("-o")
        folder = os.path.dirname(arguments[output + 1])
        del arguments[output:output + 2]
        found[source] = ([a for a in arguments if a not in ("-c", entry["file"])], folder)
    return found


def dependencies():
    """Source → itself and the headers below this repository, outside of the build tree."""
    found = {}
    listing = subprocess.run(["ninja", "-C", BUILD, "-t", "deps"], check=True, capture_output=True, text=True).stdout
    for entry in listing.split("\n\n"):
        paths = [os.path.normpath(BUILD / line.strip()) for line in entry.split("\n")[1:] if line.strip()]
        ours = [os.path.relpath(path, ROOT) for path in paths
                if path.startswith(f"{ROOT}/") and not path.startswith(f"{BUILD}/")]
        if ours and ours[0].startswith(ROOMS) and ours[0].endswith(".cpp"):
            found[ours[0]] = ours
    return found


def rules(compiled):
    """What besides the sources decides what is found. Where the clone lies does not."""
    version = subprocess.run(["clang-tidy", "--version"], check=True, capture_output=True, text=True).stdout
    options = {a.replace(f"{ROOT}/", "") for arguments, _ in compiled.values() for a in arguments
               if re.match(r"-([DfmOW]|std)", a)}
    return (ROOT / ".clang-tidy").read_text() + version + "\n".join(sorted(options))


def key(ruling, files):
    digest = hashlib.sha256(ruling.encode())
    for file in files:
        digest.update(file.encode() + b"\0" + (ROOT / file).read_bytes())
    return REMEMBERED / digest.hexdigest()[:40]


def quoted(path):
    """For LLVM's regular expressions, which know fewer escapes than Python's."""
    return re.sub(r"([][.*+?^${}()|\\])", r"\\\1", str(path))


def tidy(*arguments):
    done = subprocess.run(["clang-tidy", "--quiet", f"--config-file={ROOT}/.clang-tidy", *arguments], cwd=ROOT, stdout=subprocess.PIPE,
                          stderr=subprocess.DEVNULL, text=True, check=False)
    return done.returncode == 0, done.stdout


class Check:
    def __init__(self):
        self.compiled = commands()
        self.files = dependencies()
        ruling = rules(self.compiled)
        self.keys = {source: key(ruling, files) for source, files in self.files.items() if source in self.compiled}
        self.units = 0
        self.failed = 0
        self.pool = concurrent.futures.ThreadPoolExecutor(os.cpu_count())
        self.running = set()

    def pending(self):
        """Sources to be checked; what is still in use stays remembered."""
        for source, remembered in sorted(self.keys.items()):
            if NAMED and source not in NAMED:
                continue
            if remembered.exists():
                remembered.touch()
            else:
                yield source

    def batches(self):
        groups = collections.defaultdict(list)
        for source in self.pending():
            arguments, folder = self.compiled[source]
            groups[(folder if not NAMED else source, *arguments)].append(source)
        for sources in groups.values():
            count = -(-len(sources) // MOST_TOGETHER)
            for i in range(count):
                yield sources[i::count]

    def start(self, sources):
        if len(sources) < FEWEST_TOGETHER:
            for source in sources:
                self.running.add(self.pool.submit(self.apart, source))
        elif sources:
            self.units += 1
            self.running.add(self.pool.submit(self.together, sources, UNITS / f"unit{self.units}"))

    def together(self, sources, folder):
        """Remembers the sources if nothing is found; else says which ones to check again in what company."""
        folder.mkdir(parents=True, exist_ok=True)
        unit = folder / "unit.cpp"
        unit.write_text("".join(f'#include "{ROOT / source}" // NOLINT\n' for source in sources))
        arguments = [*self.compiled[sources[0]][0], "-c", str(unit)]
        (folder / "compile_commands.json").write_text(
            json.dumps([{"directory": str(BUILD), "arguments": arguments, "file": str(unit)}]))
        clean, output = tidy("-p", folder, f"--header-filter=^{quoted(ROOT)}/({'|'.join(ROOMS)})",
                             "--extra-arg=-ferror-limit=0", unit)
        if clean:
            for source in sources:
                self.keys[source].touch()
            return []
        findings = re.findall(r"^([^:\n]+):\d+:\d+: error: .*\[([\w.-]+)", output, re.MULTILINE)
        clashes = [finding for finding in findings if finding[1] == "clang-diagnostic-error"]
        named = {os.path.relpath(path, ROOT) for path, _ in clashes or findings}
        rest = [source for source in sources if source not in named]
        accused = [source for source in sources if source in named]
        if not rest or not accused:
            return [[source] for source in sources]
        return [rest, accused] if clashes else [rest, *([source] for source in accused)]

    def apart(self, source):
        clean, output = tidy("-p", BUILD, source)
        if clean:
            self.keys[source].touch()
        else:
            print(f"clang-tidy {source}\n{output}", flush=True)
            self.failed += 1
        return []

    def run(self):
        batches = sorted(self.batches(), key=len, reverse=True)
        print(f"clang-tidy: {len(self.keys)} sources, {sum(map(len, batches))} to check", flush=True)
        for batch in batches:
            self.start(batch)
        while self.running:
            done, self.running = concurrent.futures.wait(self.running, return_when="FIRST_COMPLETED")
            for again in done:
                for batch in again.result():
                    self.start(batch)
        return 1 if self.failed else 0


if __name__ == "__main__":
    REMEMBERED.mkdir(parents=True, exist_ok=True)
    for old in REMEMBERED.iterdir():
        if old.stat().st_mtime < time.time() - KEPT_DAYS * 86400:
            old.unlink()
    sys.exit(Check().run())
