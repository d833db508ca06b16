#!/usr/bin/env python3
"""Writes several sources into one, to be compiled at once: what they include is read once, not once a file.

join_files.py OUT SOURCE...

The includes come first, each once; then every file in a namespace of its own, so that equal names do not meet, and with
#line, so that warnings, failures and the debugger speak of the file itself. A source may not include under a condition
or define macros for what it includes: tests.cmake compiles such a one by itself.
"""
import sys


def split(path):
    """The file's includes, and its text with empty lines in their places."""
    includes, body, depth = [], [], 0
    with open(path, encoding="utf-8") as source:
        for number, line in enumerate(source, 1):
            word = line.lstrip()
            if word.startswith("#if"):
                depth += 1
            elif word.startswith("#endif"):
                depth -= 1
            elif word.startswith("#include"):
                if depth > 0:
                    sys.exit(f"{path}:{number}: an include under a condition; define a macro above it or include always.")
                includes.append(line)
                line = "\n"
            body.append(line)
    return includes, "".join(body)


def main():
    out, paths = sys.argv[1], sys.argv[2:]
    includes, bodies = {}, []  # a dict keeps the order
    for index, path in enumerate(paths):
        of_file, body = split(path)
        includes.update(dict.fromkeys(of_file))
        bodies.append(f'namespace joined_{index} {{\n#line 1 "{path}"\n{body}\n}}  // namespace\n')
    with open(out, "w", encoding="utf-8") as joined:
        joined.write("".join(includes) + "".join(bodies))


main()
