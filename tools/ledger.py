"""Which units of the sources a check has seen clean, so that it need not look at the same again.

A unit (a file, a folder) is known by a digest of everything that the check's verdict can depend on: the unit's sources,
every header that they reach by #include (the project's, the libraries' and the compiler's, by content), settings,
flags, the checking tool's version, and the check's own script. Where the tree and the build lie is no part of it. Equal digest,
equal verdict; any other is checked again, so a stale ledger costs time and never lets a fault pass.

The ledger is a text, one line "unit digest" each, sorted. Only what was seen clean is written (`--record`). A unit may
have several lines after a merge of two branches: each was seen clean.
"""
import hashlib
import os
import re
import shlex
import subprocess

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
INCLUDE = re.compile(rb'^[ \t]*#[ \t]*(?:include|include_next|import)\b[ \t]*(?:"([^"\n]+)"|<([^>\n]+)>|([A-Za-z_]\w*))',
                     re.MULTILINE)
ASKED = re.compile(rb'__has_include(?:_next)?\s*\(\s*[<"]([^>"\n]+)[>"]')
# Libraries include them under macros that no flag of ours sets, and no package of ours brings them: whether they happen
# to be installed must not count.
NOT_OURS = {"omp.h", "GL/glu.h"}


class Ledger:
    def __init__(self, name):
        self.path = os.path.join(ROOT, "tools", "clean", name + ".txt")
        self.lines = set()
        if os.path.exists(self.path):
            with open(self.path, encoding="utf-8") as text:
                self.lines = {tuple(line.split()) for line in text if line.strip()}

    def knows(self, unit, digest):
        return (unit, digest) in self.lines

    def record(self, units, checked, clean):
        """units: all there are. checked: those of this run, with digests. clean: those of them without a finding."""
        kept = {(unit, digest) for unit, digest in self.lines if unit in units and unit not in checked}
        kept |= {(unit, checked[unit]) for unit in clean}
        os.makedirs(os.path.dirname(self.path), exist_ok=True)
        with open(self.path + ".new", "w", encoding="utf-8") as text:
            text.writelines(f"{unit} {digest}\n" for unit, digest in sorted(kept))
        os.replace(self.path + ".new", self.path)


def installed_version(package):
    """What Debian calls it, with its own patches counted; empty elsewhere."""
    try:
        return subprocess.run(["dpkg-query", "-W", "-f", "${Version}", package], text=True, capture_output=True,
                              check=False).stdout
    except FileNotFoundError:
        return ""


def version_of(program):
    """The first line that tells one; further ones speak of the machine."""
    text = subprocess.run([program, "--version"], text=True, capture_output=True, check=True).stdout
    return next((line.strip() for line in text.splitlines() if "version" in line), text.splitlines()[0])


def folders_of_compiler(compiler):
    """Where it looks for headers without being told."""
    told = subprocess.run([compiler, "-E", "-x", "c++", "-v", os.devnull], text=True, capture_output=True, check=True,
                          env={**os.environ, "LC_ALL": "C"}).stderr
    listed = told.partition("#include <...> search starts here:")[2].partition("End of search list.")[0]
    return [os.path.normpath(line.strip()) for line in listed.splitlines() if line.strip()]


class Sources:
    """Digests of sources with all that they include.

    Every #include counts, also one under a condition that does not hold, and so does every folder that has the name,
    as nobody knows here which the compiler would take. So a digest may change without need, and never stays by mistake.
    """

    def __init__(self, build):
        self.build = os.path.abspath(build)
        self.folders = {}     # of a compiler
        self.contents = {}    # path -> (digest of its bytes, names in quotes, names in brackets), None: no such file
        self.found = {}       # (search folders, name) -> paths
        self.reached = {}     # (search folders, path) -> all paths from there, itself first

    def neutral(self, text):
        """Without the places where tree and build lie."""
        return text.replace(self.build, "$BUILD").replace(ROOT, "$ROOT")

    def _read(self, path):
        if path not in self.contents:
            try:
                with open(path, "rb") as source:
                    text = source.read()
            except (FileNotFoundError, NotADirectoryError, IsADirectoryError):
                self.contents[path] = None
            else:
                included = INCLUDE.findall(text)
                quoted = [os.fsdecode(quote) for quote, _, _ in included if quote]
                bracketed = [os.fsdecode(bracket) for _, bracket, _ in included if bracket]
                bracketed += [os.fsdecode(name) for name in ASKED.findall(text)]
                if any(macro for _, _, macro in included) and path.startswith((ROOT + os.sep, self.build + os.sep)):
                    # What it includes stands nowhere: never equal to anything.
                    text += os.urandom(16)
                if path.startswith(self.build + os.sep):
                    text = os.fsencode(self.neutral(os.fsdecode(text)))  # what CMake writes may name places
                self.contents[path] = (hashlib.sha256(text).hexdigest(), quoted, bracketed)
        return self.contents[path]

    def _find(self, folders, name):
        key = (folders, name)
        if key not in self.found:
            paths = [] if name in NOT_OURS else [os.path.normpath(os.path.join(folder, name)) for folder in folders]
            self.found[key] = [path for path in paths if self._read(path) is not None]
        return self.found[key]

    def _reach(self, folders, start):
        """All files that `start` includes, directly or not."""
        key = (folders, start)
        if key not in self.reached:
            seen, waiting = {start}, [start]
            while waiting:
                path = waiting.pop()
                read = self._read(path)
                if read is None:
                    continue
                _, quoted, bracketed = read
                for name in quoted:
                    beside = os.path.normpath(os.path.join(os.path.dirname(path), name))
                    for other in [beside, *self._find(folders, name)]:
                        if other not in seen and self._read(other) is not None:
                            seen.add(other)
                            waiting.append(other)
                for name in bracketed:
                    fresh = set(self._find(folders, name)) - seen
                    seen |= fresh
                    waiting += fresh
            self.reached[key] = frozenset(seen)
        return self.reached[key]

    def digest(self, paths, command, flags, settings):
        """paths: the unit's files in order. command: the build's, for its compiler and include folders.
        flags: what the checking tool is given. settings: further texts that count."""
        words = shlex.split(command)
        compiler = words[0]
        if compiler not in self.folders:
            self.folders[compiler] = (folders_of_compiler(compiler), version_of(compiler))
        standard, version = self.folders[compiler]
        told = [words[at + 1] for at, word in enumerate(words[:-1]) if word in ("-isystem", "-I", "-iquote")]
        told += [word[2:] for word in words if word.startswith("-I") and word != "-I"]
        told += [word[8:] for word in words if word.startswith("-isystem") and word != "-isystem"]
        folders = tuple(dict.fromkeys(os.path.normpath(folder) for folder in [*told, *standard]))

        total = hashlib.sha256()

        def add(*texts):
            for text in texts:
                total.update(text.encode() + b"\0")

        add(version, self.neutral("\n".join(flags)), *settings)
        everything = set()
        for path in [*paths, *included_by(words)]:
            add(self.neutral(path))
            everything |= self._reach(folders, path)
        for path in sorted(everything, key=self.neutral):
            read = self._read(path)
            add(self.neutral(path), read[0] if read is not None else "missing")
        return total.hexdigest()[:32]


def included_by(words):
    """What a command includes before the source, without what only clang's own option says."""
    plain = [word for word in words if word != "-Xclang"]
    return [plain[at + 1] for at, word in enumerate(plain[:-1]) if word == "-include"]


def text_of(path):
    with open(path, encoding="utf-8") as source:
        return source.read()


def own_scripts(script):
    """The texts of a check's script and of this one."""
    return [text_of(os.path.abspath(script)), text_of(os.path.abspath(__file__))]
