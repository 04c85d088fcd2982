"""Draws Limner's bundled texture tiles: NAME.png (256 x 256, 16-bit RGBA, grey) and its card NAME.json.

usage: generate.py FOLDER [ID...]
"""

import json
import os
import sys

import numpy as np

import tiles

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, "styles"))
from png16 import write_png16  # noqa: E402  (the styles' writer)


def neutral(field):
    """Grey around exactly 0.5, within what a picture holds."""
    grey = field
    for _ in range(20):  # what is cut at an end moves the mean; it settles at once
        grey = np.clip(grey - grey.mean() + 0.5, 0.02, 0.98)
    return np.stack([grey, grey, grey, np.ones_like(grey)], -1)


def main():
    folder, wanted = sys.argv[1], set(sys.argv[2:])
    os.makedirs(folder, exist_ok=True)
    for identity, name, tags, size_mm, draw in tiles.TILES:
        if wanted and identity not in wanted:
            continue
        path = os.path.join(folder, identity)
        write_png16(path + ".png", neutral(draw()))
        card = {
            "id": identity,
            "name": name,
            "tags": tags.split(","),
            "size_mm": size_mm,
            "origin": "drawn by Limner's own generator resources/textures/tiles.py",
            "credit": "Limner contributors",
            "licence": "Apache-2.0",
        }
        with open(path + ".json", "w", encoding="utf-8") as out:
            json.dump(card, out, indent=2)
            out.write("\n")
    print(f"{len(tiles.TILES)} texture tiles")


if __name__ == "__main__":
    main()
