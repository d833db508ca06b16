#!/usr/bin/env python3
"""Compiles every source of our own, and every header without one, by itself: each includes what it needs.

tools/each_file.py BUILD_FOLDER    configured without KNIT_UNITY and KNIT_PRECOMPILE; it need not be built

A build in batches does not notice a file that lives on what its neighbours include. Exits with 1 at a fault.
"""
import concurrent.futures
import json
import os
import shlex
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
OURS = tuple(os.path.join(ROOT, top) + os.sep for top in ("knit", "app", "assets"))


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
    return [*kept[:-1], "-fsyntax-only", "-x", "c++-header" if path.endswith(".h") else "c++", path]


def compile_one(arguments):
    run = subprocess.run(arguments, text=True, capture_output=True, check=False)
    return run.returncode, run.stderr.rstrip() if run.returncode != 0 else ""


def main():
    with open(os.path.join(sys.argv[1], "compile_commands.json"), encoding="utf-8") as database:
        commands = {entry["file"]: entry["command"] for entry in json.load(database)}
    tasks = []
    for top in OURS:
        for folder, _, names in sorted(os.walk(top)):
            paths = [os.path.join(folder, name) for name in sorted(names)]
            sources = [path for path in paths if path in commands]
            for path in sources:
                tasks.append(syntax_only(commands[path], path))
            for path in paths:
                # A header beside its source is the first that the source includes.
                if path.endswith(".h") and sources and path.removesuffix(".h") + ".cpp" not in commands:
                    tasks.append(syntax_only(commands[sources[0]], path))
    failed = False
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for code, text in pool.map(compile_one, tasks):
            failed = failed or code != 0
            if text:
                print(text, flush=True)
    sys.exit(1 if failed else 0)


main()
