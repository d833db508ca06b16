#!/usr/bin/env python3
"""clang-tidy over all sources, a folder at a time.

tools/tidy.py [--record] BUILD_FOLDER [FOLDER...]    BUILD_FOLDER: configured without KNIT_UNITY; it need not be built

The files of a folder are put one after the other, so that a header is read and checked once a folder instead of once
a file: a third of the time. (An including file would not do: the analyzer looks at functions of the main file only.)
Findings are told at their places in the files themselves. Exits with 1 if there are any.

Folders that tools/clean/tidy.txt knows as clean are not checked again; --record writes there what this run finds clean.
"""
import concurrent.futures
import json
import os
import re
import shlex
import subprocess
import sys

import ledger

BUILT_ELSEWHERE = ["app/web"]  # for the page alone (tools/web.sh)
ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


def folders_with_sources(tops):
    for top in tops:
        for folder, _, names in sorted(os.walk(os.path.join(ROOT, top))):
            files = sorted(os.path.join(folder, name) for name in names if name.endswith(".cpp"))
            if files:
                yield os.path.relpath(folder, ROOT), files


def arguments_of(command):
    """What the compiler is told about language and include folders; warnings and outputs are not clang-tidy's."""
    words = shlex.split(command)
    kept = []
    for at, word in enumerate(words):
        if word in ("-isystem", "-I") and at + 1 < len(words):
            kept += [word, words[at + 1]]
        elif word.startswith(("-I", "-D", "-std=")) and word != "-I":
            kept.append(word)
    return kept


def join(files, out):
    """Writes the files one after the other; gives for each line of `out` the file and line that it came from."""
    places = []
    included = set()
    with open(out, "w", encoding="utf-8") as joined:
        for path in files:
            with open(path, encoding="utf-8") as source:
                for number, line in enumerate(source, 1):
                    if line.startswith("#include") and line in included:
                        line = "\n"
                    elif line.startswith("#include"):
                        included.add(line)
                    joined.write(line)
                    places.append((os.path.relpath(path, ROOT), number))
    return places


def check(folder, files, arguments, build):
    work = os.path.join(build, "tidy")
    os.makedirs(os.path.join(work, folder), exist_ok=True)
    out = os.path.join(work, folder, "joined.cpp")
    places = join(files, out)
    # The folder's own settings, as clang-tidy would find them beside a file.
    config = os.path.join(ROOT, folder)
    while not os.path.exists(os.path.join(config, ".clang-tidy")):
        config = os.path.dirname(config)
    dump = subprocess.run(["clang-tidy-14", "--dump-config", os.path.join(config, "any.cpp"), "--"], text=True,
                          capture_output=True, check=True, cwd=ROOT).stdout
    config_file = os.path.join(work, folder, "config.yaml")
    with open(config_file, "w", encoding="utf-8") as written:
        written.write(dump)
    run = subprocess.run(["clang-tidy-14", "--quiet", f"--config-file={config_file}", out, "--", *arguments],
                         text=True, capture_output=True, check=False, cwd=ROOT)

    def place(match):
        path, line = places[int(match[1]) - 1]
        return f"{path}:{line}:"

    text = re.sub(re.escape(out) + r":(\d+):", place, run.stdout + run.stderr)
    text = "\n".join(line for line in text.splitlines()
                     if not re.fullmatch(r"\d+ warnings?( and \d+ errors?)? (generated|treated as errors?)\.?", line))
    return run.returncode, text


def settings_of(folder):
    """The texts of every .clang-tidy that may bear on it, the nearest first."""
    texts = []
    while True:
        path = os.path.join(ROOT, folder, ".clang-tidy")
        texts.append(ledger.text_of(path) if os.path.exists(path) else "none")
        if not folder:
            return texts
        folder = os.path.dirname(folder)


def main():
    words = [word for word in sys.argv[1:] if word != "--record"]
    record = len(words) < len(sys.argv) - 1
    build, wanted = os.path.abspath(words[0]), words[1:]
    with open(os.path.join(build, "compile_commands.json"), encoding="utf-8") as database:
        commands = {entry["file"]: entry["command"] for entry in json.load(database)}
    known = ledger.Ledger("tidy")
    sources = ledger.Sources(build)
    settings = [ledger.version_of("clang-tidy-14"), ledger.installed_version("clang-tidy-14"),
                *ledger.own_scripts(__file__)]
    folders = dict(folders_with_sources(["knit", "app", "assets"]))
    for folder in BUILT_ELSEWHERE:
        folders.pop(folder, None)
    digests, tasks = {}, []
    for folder, files in folders.items():
        if wanted and folder not in wanted:
            continue
        missing = [path for path in files if path not in commands]
        if missing:
            sys.exit(f"tidy: {missing[0]} is not built in {build}; configure that without KNIT_UNITY.")
        command = commands[files[0]]
        arguments = arguments_of(command)
        digests[folder] = sources.digest(files, command, arguments, [*settings, *settings_of(folder)])
        if not known.knows(folder, digests[folder]):
            tasks.append((folder, files, arguments))
    print(f"clang-tidy: {len(digests)} folders, {len(digests) - len(tasks)} known as clean", flush=True)
    clean, failed = set(digests) - {task[0] for task in tasks}, False
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        largest_first = sorted(tasks, key=lambda task: -sum(os.path.getsize(path) for path in task[1]))
        results = pool.map(lambda task: check(*task, build), largest_first)
        for (folder, _, _), (code, text) in zip(largest_first, results):
            failed = failed or code != 0
            if code == 0 and not text:
                clean.add(folder)
            if text:
                print(text, flush=True)
    if record:
        known.record(folders, digests, clean)
    sys.exit(1 if failed else 0)


main()
