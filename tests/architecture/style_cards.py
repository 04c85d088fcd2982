#!/usr/bin/env python3
"""Every bundled style has a picture and a card that says what it is, who made it and under which licence."""

import json
import re

from checking import Planted, run

PICTURES = {".png", ".exr", ".tif", ".tiff", ".webp"}
WANTED = ("id", "name", "origin", "credit", "licence")


def problems_of_card(path, picture_stems):
    try:
        card = json.loads(path.read_text(encoding="utf-8"))
    except json.JSONDecodeError as error:
        return [f"{path.name}: no JSON: {error}"]
    problems = [f"{path.name}: {key} is missing or empty" for key in WANTED if not str(card.get(key, "")).strip()]
    if not isinstance(card.get("tags"), list) or not card["tags"]:
        problems.append(f"{path.name}: tags is missing or empty")
    if not re.fullmatch(r"[a-z0-9]+(-[a-z0-9]+)*", str(card.get("id", ""))):
        problems.append(f"{path.name}: the id is not in lower case with hyphens")
    if path.stem not in picture_stems:
        problems.append(f"{path.name}: no picture of that name")
    return problems


def check(root):
    folder = root / "resources" / "styles"
    pictures = {path.stem for path in folder.glob("*") if path.suffix in PICTURES}
    cards = sorted(folder.glob("*.json"))
    problems = [problem for card in cards for problem in problems_of_card(card, pictures)]
    problems += [f"{stem}: a picture without a card" for stem in sorted(pictures - {card.stem for card in cards})]
    ids = [str(json.loads(card.read_text(encoding="utf-8")).get("id")) for card in cards if not problems]
    problems += [f"{name}: the id is used twice" for name in sorted({name for name in ids if ids.count(name) > 1})]
    if not cards:
        problems.append(f"no cards in {folder.relative_to(root)}")
    return problems


def card(**changes):
    fields = {"id": "a", "name": "A", "tags": ["t"], "origin": "o", "credit": "c", "licence": "CC0-1.0"}
    return json.dumps({**fields, **changes})


PLANTED = (
    Planted("resources/styles/a.json", card(licence=""), "licence is missing or empty"),
    Planted("resources/styles/b.json", card(credit=" "), "credit is missing or empty"),
    Planted("resources/styles/c.json", card(id="Not This"), "the id is not in lower case"),
    Planted("resources/styles/d.json", card(), "no picture of that name"),
    Planted("resources/styles/e.json", "{", "no JSON"),
    Planted("resources/styles/f.png", "", "a picture without a card"),
    Planted("resources/README.md", "", "no cards"),
)
INNOCENT = {"resources/styles/a.json": card(), "resources/styles/a.png": ""}

if __name__ == "__main__":
    run(__doc__, check, PLANTED, INNOCENT)
