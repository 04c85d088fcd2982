#!/usr/bin/env python3
"""The command line links no Qt, no OpenGL and no VTK: the linker's own list of needed libraries says so."""

import re
import subprocess
from pathlib import Path

from checking import finish, parser

FORBIDDEN = re.compile(r"libQt|libOpenGL|libGL\b|libGLX|libEGL|libOSMesa|libvtk")


def needed(text):
    """Names from the dynamic section as `readelf --dynamic` prints it."""
    return re.findall(r"\(NEEDED\)[^\[]*\[([^\]]+)\]", text)


def problems_of(name, libraries):
    if not libraries:
        return [f"{name}: no dynamic section was read"]
    return [f"{name}: links {library}" for library in libraries if FORBIDDEN.match(library)]


def read(program):
    text = subprocess.run(["readelf", "--dynamic", "--wide", program], capture_output=True, text=True, check=True).stdout
    return needed(text)


def self_test(build):
    line = " 0x0000000000000001 (NEEDED)             Shared library: [{}]\n"
    failures = []
    for library in ("libQt6Widgets.so.6", "libQt6Core.so.6", "libGL.so.1", "libvtkCommonCore-9.1.so.1"):
        if not problems_of("planted", needed(line.format("libc.so.6") + line.format(library))):
            failures.append(f"{library} was not reported")
    if problems_of("innocent", needed(line.format("libtbb.so.12") + line.format("libc.so.6"))):
        failures.append("libtbb was reported without cause")
    if not problems_of("empty", needed("")):
        failures.append("an empty list was taken for a clean one")
    studio = build / "bin" / "limner-studio"
    if studio.exists() and not problems_of("limner-studio", read(studio)):
        failures.append("the studio's Qt was not seen")
    return failures


def main():
    arguments = parser(__doc__)
    arguments.add_argument("--build", type=Path, required=True, help="the build folder")
    arguments = arguments.parse_args()
    if arguments.self_test:
        finish(self_test(arguments.build), "every planted violation was found")
    finish(problems_of("limner", read(arguments.build / "bin" / "limner")), "limner links neither Qt nor OpenGL")


if __name__ == "__main__":
    main()
