#!/usr/bin/env python3
"""Keeps functions to 60 lines, files to 600 (nine in ten to 350) and public headers to 200."""

import re

from checking import Planted, run, sources, without_comments_and_strings

FUNCTION_LINES = 60
FILE_LINES = 600
USUAL_FILE_LINES = 350  # nine files in ten stay below
HEADER_LINES = 200

TYPE_OR_NAMESPACE = re.compile(r"\b(namespace|class|struct|union|enum)\b")
INITIALISER = re.compile(r"=\s*[\w:<>,\s*&]*$")
# `: member_` or `, member_` before a brace, after the parameters: a member's initialiser, not the body
MEMBER_INITIALISER = re.compile(r"\)\s*(?:noexcept\s*)?:(?!:).*[\w>]\s*$", re.DOTALL)


def functions(text):
    """(first line, last line, head) of every outermost function body of C++ text without comments and strings."""
    text = re.sub(r"^[ \t]*#(?:.*\\\n)*.*$", lambda m: re.sub(r"[^\n]", " ", m.group()), text, flags=re.MULTILINE)
    found = []
    head_start = 0
    at = 0
    while at < len(text):
        char = text[at]
        if char in ";}":
            head_start = at + 1
        elif char == "{":
            head = text[head_start:at]
            if is_function(head):
                end = matching_brace(text, at)
                found.append((text.count("\n", 0, at) + 1, text.count("\n", 0, end) + 1, " ".join(head.split())))
                at = end
                head_start = at + 1
            elif MEMBER_INITIALISER.search(head) or INITIALISER.search(head):
                at = matching_brace(text, at)  # stay in the same head
            else:
                head_start = at + 1
        at += 1
    return found


def is_function(head):
    before_parameters = head.split("(")[0]
    while "<" in before_parameters:  # template parameters: `template <class T>` declares no class
        shorter = re.sub(r"<[^<>]*>", " ", before_parameters)
        if shorter == before_parameters:
            break
        before_parameters = shorter
    if "(" not in head or TYPE_OR_NAMESPACE.search(before_parameters):
        return False
    return not MEMBER_INITIALISER.search(head) and not INITIALISER.search(head)


def matching_brace(text, at):
    depth = 0
    for end in range(at, len(text)):
        depth += {"{": 1, "}": -1}.get(text[end], 0)
        if depth == 0:
            return end
    return len(text) - 1


def problems_of(root, path):
    text = (root / path).read_text(encoding="utf-8")
    lines = text.count("\n")
    problems = []
    if lines > FILE_LINES:
        problems.append(f"{path}: {lines} lines, at most {FILE_LINES} are allowed")
    if path.suffix == ".h" and path.parts[0] != "tests" and lines > HEADER_LINES and not is_private(path):
        problems.append(f"{path}: {lines} lines, a public header has at most {HEADER_LINES}")
    for first, last, head in functions(without_comments_and_strings(text)):
        if last - first + 1 > FUNCTION_LINES:
            problems.append(f"{path}:{first}: function of {last - first + 1} lines, at most {FUNCTION_LINES}: {head[-90:]}")
    return problems


def is_private(path):
    """Headers of a backend's inside: only their own folder may include them."""
    return path.parts[:2] in {("renderer", "cpu"), ("renderer", "gl"), ("renderer", "reference"), ("renderer", "scene")}


def check(root):
    paths = sources(root)
    problems = [problem for path in paths for problem in problems_of(root, path)]
    lengths = sorted((root / path).read_text(encoding="utf-8").count("\n") for path in paths)
    if lengths and lengths[int(0.9 * (len(lengths) - 1))] > USUAL_FILE_LINES:
        problems.append(f"more than one file in ten has over {USUAL_FILE_LINES} lines")
    return problems


def body(lines):
    return "    x = 1;\n" * lines


PLANTED = (
    Planted("core/a.cpp", f"int f(int x) {{\n{body(59)}}}\n", "function of 61 lines"),
    Planted("core/b.cpp", f"namespace a {{\nA::A(int x) : y_(x), z_{{x}} {{\n{body(70)}}}\n}}\n", "function of 72 lines"),
    Planted("core/c.cpp", f"struct B {{\n  void f() const {{\n{body(70)}}}\n}};\n", "function of 72 lines"),
    Planted("core/d.cpp", f"std::vector<int> f(struct B b) {{\n{body(70)}}}\n", "function of 72 lines"),
    Planted("core/h.cpp", f"template <class T>\nvoid f(T t) {{\n{body(70)}}}\n", "function of 72 lines"),
    Planted("tests/a_test.cpp", f"TEST(A, b) {{\n{body(70)}}}\n", "function of 72 lines"),
    Planted("core/e.cpp", "int a;\n" * 601, "601 lines, at most 600"),
    Planted("core/f.cpp", "int a;\n" * 351, "over 350 lines"),
    Planted("core/g.h", "int a;\n" * 201, "a public header has at most 200"),
)
INNOCENT = {
    "core/a.cpp": f"int f(int x) {{\n{body(58)}}}\n",
    "core/b.cpp": "namespace a {\n" + "int f() { return '{'; } // {\n" * 80 + "} // namespace a\n",
    "core/c.cpp": "const std::vector<int> table = {\n" + "    1,\n" * 90 + "};\n",
    "core/d.cpp": 'const char* text = R"(\n' + "{ void f() {\n" * 80 + ')";\n',
    "core/e.h": "struct A {\n" + "    int f() { return 1'000; }\n" * 80 + "};\n",
    "renderer/cpu/a.h": "int a;\n" * 210,
}

if __name__ == "__main__":
    run(__doc__, check, PLANTED, INNOCENT)
