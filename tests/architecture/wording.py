#!/usr/bin/env python3
"""Finds what must not be in any text file of the project: one machine's paths and marks of unfinished work."""

import re
import subprocess
from pathlib import Path

from checking import Planted, run

# Written in pieces so that this file does not find itself.
RULES = (
    ("a path of one machine", re.compile(r"(?<![\w.}])/(" + "home|Users|root|work" + r")/\w|/tmp/" + r"\w+/\w|[A-Z]:\\" + r"\\Users")),
    ("a mark of unfinished work", re.compile(r"\b(TO" + r"DO|FIX" + r"ME|XX" + r"X|HA" + r"CK)\b")),
    ("a test that is switched off", re.compile(r"\bDIS" + r"ABLED_\w+")),
)
TEXT = {
    ".h", ".cpp", ".py", ".md", ".txt", ".cmake", ".json", ".glsl", ".yml", ".sh", ".desktop", ".xml", ".svg", ".qss", "",
}
NOT_OURS = {"LICENSE"}


def tracked(root):
    """Files under version control, or all files where there is none (the self-test)."""
    done = subprocess.run(["git", "ls-files", "-z"], cwd=root, capture_output=True, text=True)
    if done.returncode == 0 and (root / ".git").exists():
        return [Path(name) for name in done.stdout.split("\0") if name and (root / name).is_file()]
    return [path.relative_to(root) for path in root.rglob("*") if path.is_file() and "build" not in path.parts]


def check(root):
    problems = []
    for path in sorted(tracked(root)):
        if path.suffix not in TEXT or path.name in NOT_OURS:
            continue
        for number, line in enumerate((root / path).read_text(encoding="utf-8", errors="replace").splitlines(), 1):
            for what, pattern in RULES:
                if pattern.search(line):
                    problems.append(f"{path}:{number}: {what}: {line.strip()[:100]}")
    return problems


PLANTED = (
    Planted("README.md", "see /ho" + "me/anna/limner\n", "a path of one machine"),
    Planted("core/a.cpp", 'open("/ro' + 'ot/data/a.nrrd");\n', "a path of one machine"),
    Planted("tests/run", "cd /tm" + "p/x/y\n", "a path of one machine"),
    Planted("core/b.cpp", "// TO" + "DO: later\n", "a mark of unfinished work"),
    Planted("tests/b_test.cpp", "TEST(A, DIS" + "ABLED_b) {}\n", "a test that is switched off"),
)
INNOCENT = {
    "README.md": "build/release/bin/limner, /usr/share and ../shared/data\n",
    "packaging/run": "mktemp /tmp/limner.XXXXXX; $root/work\n",
}

if __name__ == "__main__":
    run(__doc__, check, PLANTED, INNOCENT)
