"""Draws Limner's bundled lit-sphere styles: NAME.png (512 x 512, 16-bit RGBA) and its card NAME.json.

usage: generate.py FOLDER [ID...]
"""

import json
import os
import sys
import time

import drawn
import matter
import plates
from png16 import write_png16


def card(identity, name, tags, source):
    return {
        "id": identity,
        "name": name,
        "tags": tags.split(","),
        "origin": f"drawn by Limner's own generator resources/styles/{source}.py",
        "credit": "Limner contributors",
        "licence": "Apache-2.0",
    }


def main():
    folder, wanted = sys.argv[1], set(sys.argv[2:])
    os.makedirs(folder, exist_ok=True)
    started, count = time.monotonic(), 0
    for source in (matter, drawn, plates):
        for identity, name, tags, draw in source.STYLES:
            if wanted and identity not in wanted:
                continue
            path = os.path.join(folder, identity)
            write_png16(path + ".png", draw())
            with open(path + ".json", "w", encoding="utf-8") as out:
                json.dump(card(identity, name, tags, source.__name__), out, indent=2)
                out.write("\n")
            count += 1
    print(f"{count} styles in {time.monotonic() - started:.1f} s")


if __name__ == "__main__":
    main()
