#!/usr/bin/env python3
"""Holds every C++ file against .clang-format with clang-format 14; other versions format a little differently."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from checking import SKIPPED, Planted, finish, parser, self_test, sources

VERSION = 14  # Debian 12's


def clang_format():
    """The program of the wanted version, or None."""
    for name in (f"clang-format-{VERSION}", "clang-format"):
        program = shutil.which(name)
        if program:
            text = subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout
            if re.search(rf"version {VERSION}\.", text):
                return program
    return None


def check(root, program):
    files = [str(path) for path in sources(root)]
    done = subprocess.run(
        ["xargs", "-0", "-r", "-P", str(os.cpu_count()), "-n", "16", program, "--dry-run", "-Werror"],
        input="\0".join(files), capture_output=True, text=True, cwd=root,
    )
    places = re.findall(r"^(\S+?):(\d+):\d+: error:", done.stderr, re.MULTILINE)
    if done.returncode != 0 and not places:
        return [done.stderr.strip() or f"clang-format ended with {done.returncode}"]
    firsts = {}
    for file, line in places:
        firsts.setdefault(file, line)
    return [f"{file}:{line}: not as .clang-format says" for file, line in sorted(firsts.items())]


PLANTED = (Planted("core/a.cpp", "int   main( ){return 0 ;}\n", "core/a.cpp:1"),)
INNOCENT = {"core/a.cpp": "int main() { return 0; }\n"}


def main():
    arguments = parser(__doc__).parse_args()
    program = clang_format()
    if program is None:
        print(f"skipped: clang-format {VERSION} is not installed")
        sys.exit(SKIPPED)
    if arguments.self_test:

        def check_planted(root):
            shutil.copy(Path(arguments.root) / ".clang-format", root)
            return check(root, program)

        finish(self_test(check_planted, PLANTED, INNOCENT), "every planted violation was found")
    finish(check(arguments.root, program), "every file is as .clang-format says")


if __name__ == "__main__":
    main()
