"""Draws the pictures that bundled sample figures refer to.

usage: generate.py FOLDER
"""

import os
import sys

import plate

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, "styles"))
from png16 import write_png16  # noqa: E402  (the styles' writer)


def main():
    os.makedirs(sys.argv[1], exist_ok=True)
    write_png16(os.path.join(sys.argv[1], "plate.png"), plate.plate())


if __name__ == "__main__":
    main()
