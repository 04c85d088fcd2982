#!/usr/bin/env python3
"""Compiles headers alone, twice in one file, with the flags of the target that they belong to.

Those that a source includes first are left out: the build compiles them alone already.
"""

import json
import os
import shlex
import subprocess
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from checking import Planted, finish, parser, self_test, sources


def commands_by_folder(build):
    """Folder of a source file -> its compiler and flags, from CMake's compile_commands.json."""
    commands = {}
    for entry in json.loads((build / "compile_commands.json").read_text(encoding="utf-8")):
        words = shlex.split(entry["command"]) if "command" in entry else entry["arguments"]
        while Path(words[0]).name in ("cmake", "-E", "env", "ccache") or "=" in words[0]:
            words = words[1:]
        flags = []
        skip = False
        for word in words[1:]:
            if skip or word in ("-c", entry["file"]):
                skip = False
            elif word in ("-o", "-include"):  # a precompiled header would stand in for what is missing
                skip = True
            elif not word.startswith(("-O", "-g", "-fsanitize", "-Winvalid-pch")):
                flags.append(word)
        file = Path(entry["file"])
        commands.setdefault(file.parent, [words[0], *flags])
        if file.name.startswith("kernel_"):  # one of the files that are built for several instruction sets
            commands[file.parent / "-inl.h"] = [words[0], *flags]
    return commands


def command_for(header, commands):
    """The flags of the nearest folder, upwards first, then anywhere below; of a kernel for what only kernels include."""
    if header.name.endswith("-inl.h") and header.parent / "-inl.h" in commands:
        return commands[header.parent / "-inl.h"]
    for folder in header.parents:
        if folder in commands:
            return commands[folder]
        below = sorted(path for path in commands if folder in path.parents)
        if below:
            return commands[below[0]]
    return None


def problem_of(root, path, command):
    if command is None:
        return f"{path}: no target compiles anything near it"
    text = f'#include "{path}"\n#include "{path}"\n'
    done = subprocess.run(
        [*command, "-I", str(root), "-fsyntax-only", "-x", "c++", "-"], input=text, capture_output=True, text=True, cwd=root
    )
    if done.returncode == 0:
        return None
    errors = [line for line in done.stderr.splitlines() if "error" in line]
    return f"{path}: {(errors or done.stderr.splitlines())[0]}"


def first_includes(root):
    """What some source includes before anything else: that it compiles is the header's proof."""
    first = set()
    for path in sources(root, (".cpp",)):
        if path.parts[0] == "tests":
            continue  # they are compiled with a precompiled header in front
        for line in (root / path).read_text(encoding="utf-8").splitlines():
            if line.startswith("#include"):
                first.add(line.removeprefix("#include ").strip('"'))
                break
    return first


def proven(root, path, first):
    """Headers that are read anew for every instruction set have to be compiled twice all the same."""
    names = (str(path), str(path).removeprefix("tests/"))  # tests include from the tree's root and from their own
    return any(name in first for name in names) and "#pragma once" in (root / path).read_text(encoding="utf-8")


def check(root, commands):
    first = first_includes(root)
    headers = [path for path in sources(root, (".h",)) if not proven(root, path, first)]
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        found = pool.map(lambda path: problem_of(root, path, command_for(root / path, commands)), headers)
        return [problem for problem in found if problem], len(headers)


PLANTED = (
    Planted("core/a.h", "#pragma once\nstd::string name();\n", "core/a.h"),
    Planted("core/b.h", "struct B {};\n", "core/b.h"),  # no include guard
    Planted("widgets/c.h", '#pragma once\n#include "core/gone.h"\n', "core/gone.h"),
)
INNOCENT = {"core/a.h": "#pragma once\n#include <string>\nstd::string name();\n"}


def main():
    arguments = parser(__doc__)
    arguments.add_argument("--build", type=Path, help="a build folder with compile_commands.json")
    arguments = arguments.parse_args()
    if arguments.self_test:

        def check_planted(root):
            return check(root, {root: ["c++", "-std=c++20"]})[0]

        finish(self_test(check_planted, PLANTED, INNOCENT), "every planted violation was found")
    problems, headers = check(arguments.root, commands_by_folder(arguments.build))
    finish(problems, f"{headers} headers without a source that begins with them compile alone")


if __name__ == "__main__":
    main()
