"""What the architecture checks share: the list of sources, the report, and the self-test on planted violations.

A check is a function from a root folder to a list of problems, one line each. With --self-test the script does not
look at the project: every planted violation is written into an empty folder, alone, and must be found there; the
innocent files must not be reported.
"""

import argparse
import re
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

SOURCE_FOLDERS = ("core", "renderer", "widgets", "app", "tests")
SKIPPED = 77  # the exit status that CTest is told to read as "skipped"


@dataclass
class Planted:
    """A file with a violation, and a part of the message that must report it."""

    path: str
    text: str
    message: str


def sources(root, endings=(".h", ".cpp")):
    """Our C++ files, relative to the root, sorted."""
    found = []
    for folder in SOURCE_FOLDERS:
        found += [p.relative_to(root) for p in (root / folder).rglob("*") if p.suffix in endings and p.is_file()]
    return sorted(found)


def without_comments_and_strings(text):
    """The text with comments and the insides of literals blanked; line breaks stay, so line numbers stay right."""
    pattern = re.compile(
        r'//[^\n]*|/\*.*?\*/|R"(?P<mark>[^(\s]*)\(.*?\)(?P=mark)"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'', re.DOTALL
    )
    digits = re.compile(r"(?<=[0-9a-fA-F])'(?=[0-9a-fA-F])")  # 1'000 is a number, not a literal

    def blank(match):
        return re.sub(r"[^\n]", " ", match.group())

    return pattern.sub(blank, digits.sub("0", text))


def self_test(check, planted, innocent):
    failures = []
    for plant in planted:
        with tempfile.TemporaryDirectory() as folder:
            write(Path(folder), plant.path, plant.text)
            problems = check(Path(folder))
            if not any(plant.message in problem for problem in problems):
                failures.append(f"{plant.path}: the planted violation was not reported as '{plant.message}': {problems}")
    with tempfile.TemporaryDirectory() as folder:
        for path, text in innocent.items():
            write(Path(folder), path, text)
        failures += [f"reported without cause: {problem}" for problem in check(Path(folder))]
    print(f"{len(planted)} planted violations, {len(innocent)} innocent files")
    return failures


def write(root, path, text):
    file = root / path
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text, encoding="utf-8")


def parser(description):
    arguments = argparse.ArgumentParser(description=description)
    arguments.add_argument("--root", type=Path, default=Path(__file__).resolve().parents[2], help="the repository")
    arguments.add_argument("--self-test", action="store_true", help="check the check on planted violations")
    return arguments


def finish(problems, passed):
    """Prints the outcome and ends the script."""
    for problem in problems:
        print(problem)
    print(f"{len(problems)} problems" if problems else passed)
    sys.exit(1 if problems else 0)


def run(description, check, planted, innocent):
    """The whole script of a check that needs nothing but the root."""
    arguments = parser(description).parse_args()
    if arguments.self_test:
        finish(self_test(check, planted, innocent), "every planted violation was found")
    finish(check(arguments.root), "nothing to report")
