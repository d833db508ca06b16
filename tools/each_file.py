#!/usr/bin/env python3
"""Compiles every source of our own, and every header without one, by itself: each includes what it needs.

tools/each_file.py [--record] BUILD_FOLDER [FOLDER...]
    BUILD_FOLDER: configured without KNIT_UNITY, KNIT_PRECOMPILE and KNIT_JOIN_TESTS; it need not be built

Tests have their precompiled header, and their own headers are not looked at. A build in batches does not notice a file that lives on what its neighbours include. Files that tools/clean/each_file.txt
knows as clean are not compiled again; --record writes there what this run finds clean. Exits with 1 at a fault.
"""
import concurrent.futures
import json
import os
import shlex
import subprocess
import sys

import ledger

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
OURS = tuple(os.path.join(ROOT, top) + os.sep for top in ("knit", "app", "assets", "tests"))
TESTS = os.path.join(ROOT, "tests") + os.sep


def syntax_only(command, path):
    """The same compiler and flags on `path`, without outputs."""
    words = shlex.split(command)
    kept, skip = [], False
    for word in words:
        if skip or word in ("-c", "-MD"):
            skip = False
        elif word in ("-o", "-MT", "-MF"):
            skip = True
        elif not word.startswith(("-O", "-g")):
            kept.append(word)
    if path.startswith(TESTS):
        kept.insert(-1, "-Wno-shadow")  # g++ tells true ones
    return [*kept[:-1], "-fsyntax-only", "-x", "c++-header" if path.endswith(".h") else "c++", path]


def compile_one(arguments):
    run = subprocess.run(arguments, text=True, capture_output=True, check=False)
    return run.returncode, run.stderr.rstrip() if run.returncode != 0 else ""


def tasks_of(commands):
    """For each file to compile its path and the build's command that tells how."""
    for top in OURS:
        for folder, _, names in sorted(os.walk(top)):
            paths = [os.path.join(folder, name) for name in sorted(names)]
            sources = [path for path in paths if path in commands]
            for path in sources:
                yield path, commands[path]
            for path in paths:
                # A header beside its source is the first that the source includes.
                if path.endswith(".h") and top != TESTS and sources and path.removesuffix(".h") + ".cpp" not in commands:
                    yield path, commands[sources[0]]


def precompile(commands, build):
    """The headers that the tests have precompiled."""
    for path, command in commands.items():
        if path.endswith("cmake_pch.hxx.cxx"):
            subprocess.run(shlex.split(command), check=True, cwd=build)


def main():
    words = [word for word in sys.argv[1:] if word != "--record"]
    record = len(words) < len(sys.argv) - 1
    build, wanted = words[0], words[1:]
    with open(os.path.join(build, "compile_commands.json"), encoding="utf-8") as database:
        commands = {entry["file"]: entry["command"] for entry in json.load(database)}
    known = ledger.Ledger("each_file")
    sources = ledger.Sources(build)
    settings = ledger.own_scripts(__file__)
    units, digests, waiting = set(), {}, []
    for path, command in tasks_of(commands):
        unit = os.path.relpath(path, ROOT)
        units.add(unit)
        if wanted and os.path.dirname(unit) not in wanted:
            continue
        arguments = syntax_only(command, path)
        digests[unit] = sources.digest([path], command, arguments, settings)
        if not known.knows(unit, digests[unit]):
            waiting.append((unit, arguments))
    print(f"each file: {len(digests)} files, {len(digests) - len(waiting)} known as clean", flush=True)
    if any("-include-pch" in arguments for _, arguments in waiting):
        precompile(commands, build)
    clean = set(digests) - {unit for unit, _ in waiting}
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        results = pool.map(compile_one, [arguments for _, arguments in waiting])
        for (unit, _), (code, text) in zip(waiting, results):
            if code == 0:
                clean.add(unit)
            if text:
                print(text, flush=True)
    if record:
        known.record(units, digests, clean)
    sys.exit(0 if len(clean) == len(digests) else 1)


main()
