"""What complete plates of one hand need besides bone: the other tissues in the manner of Gray's engravers, of ink,
chalk and pencil, of Haeckel's lithographers, of a blackboard and of watercolour. Themes are made of these.

Where a tissue lies over another, it is drawn as a veil: clear where one looks through it, drawn at its edge.
"""

import numpy as np

import ball
from ball import FACING, gloss, lambert, paint, ramp, rim, rgba, smoothstep, soft_light, toward, unit
from drawn import board_chalk, chalk, engraved, pencil, printed, watercolour, wobble


def veil(keys, power, least=0.05, shine=0.0):
    """A see-through skin. power: how much of the form the edge takes, less for more; least: what of it shows within."""
    lab = toward(ramp(soft_light() - 0.10 * rim(2.0), keys), "fffdf8", shine * gloss(30))
    alpha = least + (0.95 - least) * smoothstep(0.0, 1.0, rim(power)) + 0.8 * shine * gloss(30)
    return printed(ball.srgb_from_oklab(lab), np.clip(alpha, 0, 1))


def ink_brush():
    """Solid black with the light left open, and a thin light along the far edge."""
    light = smoothstep(0.70, 0.80, soft_light() + wobble("brush", 0.015))
    edge = smoothstep(0.30, 0.75, ball.NORMAL @ ball.BOUNCE) * smoothstep(0.15, 0.30, FACING)
    return printed(paint("fbf8f1", (2.7 - 2.66 * light - 1.3 * edge * (1 - light), "4a4245")))


def ink_tone(name, tone, keyline):
    """One flat wash and a second in the shadow, held by a brush line."""
    t = soft_light() + wobble(name, 0.018)
    wash = tone * smoothstep(0.93, 0.84, t) + 0.75 * tone * smoothstep(0.46, 0.39, t)
    width = 0.26 - 0.12 * lambert(unit(-0.62, 0.70, 0.0))
    line = smoothstep(width + 0.05, width - 0.05, FACING)
    return printed(paint("fbf8f1", (np.maximum(wash, keyline * line), "4a4245")))


def lithograph(keys, edge):
    """Saturated crayon on stone: the shadow has a hue of its own; a dark line holds the form."""
    back = smoothstep(0.05, 1.0, ball.NORMAL @ ball.BOUNCE)
    grain = ball.noise("stone" + edge, 5, 18)
    t = soft_light() - 0.16 * rim(2.0) + 0.10 * back + 0.010 * grain
    lab = toward(ramp(t, keys), "fffbea", 0.22 * gloss(18))
    return printed(ball.srgb_from_oklab(toward(lab, edge, 0.85 * smoothstep(0.30, 0.08, FACING))))


def stone(shadow, dark, middle, light, high):
    return [(0, shadow), (0.25, dark), (0.5, middle), (0.75, light), (1, high)]


ENGRAVED = [
    ("engraved-artery", "Engraved artery", "vessel,artery,ink",
     lambda: engraved(axis=(0.15, 0.95, 0.20), lines=12, light=0.06, tone=1.2, tint=(0.95, "d9503f"))),
    ("engraved-vein", "Engraved vein", "vessel,vein,ink",
     lambda: engraved(axis=(0.15, 0.95, 0.20), lines=12, light=0.06, tone=1.2, tint=(0.95, "6a92c4"))),
    ("engraved-muscle", "Engraved muscle", "muscle,ink",
     lambda: engraved(axis=(0.92, 0.30, 0.20), lines=16, light=-0.06, tone=1.5, tint=(0.70, "d09a80"))),
    ("engraved-organ", "Engraved organ", "organ,brain,ink",
     lambda: engraved(cross=(0.86, -0.40, 0.26), lines=13, light=0.02, tone=1.2, tint=(0.50, "dcb8a2"))),
    ("engraved-skin", "Engraved skin", "skin,soft tissue,ink",
     lambda: engraved(axis=(0.25, 0.90, 0.30), lines=12, light=0.18, tone=1.1, tint=(0.55, "f2dcbf"))),
    ("engraved-nerve", "Engraved nerve", "nerve,fat,ink",
     lambda: engraved(lines=12, light=0.14, tone=1.0, tint=(0.85, "f0d27c"))),
    ("engraved-veil", "Engraved veil", "skin,transparent,ink",
     lambda: veil([(0, "4a3f3e"), (0.5, "8b7d72"), (1, "c9bba6")], 1.9, 0.03)),
]

INK = [
    ("ink-brush", "Ink brush", "vessel,ink", ink_brush),
    ("ink-grey", "Ink grey tone", "muscle,organ,ink", lambda: ink_tone("grey", 0.62, 2.6)),
    ("ink-pale", "Ink pale tone", "skin,brain,fat,ink", lambda: ink_tone("pale", 0.17, 2.2)),
    ("ink-veil", "Ink veil", "skin,transparent,ink", lambda: veil([(0, "231f20"), (1, "4d484a")], 2.6, 0.02)),
]

CHALK = [
    ("chalk-heightened", "Heightened chalk", "bone,drawing",
     lambda: chalk("high", colour="c07a55", depth=1.05, light=0.14, white=0.95)),
    ("chalk-dark", "Dark sanguine", "vessel,muscle,drawing",
     lambda: chalk("dark", colour="8e3b2c", depth=2.0, light=-0.10, white=0.55)),
    ("chalk-black", "Black chalk", "organ,vessel,drawing",
     lambda: chalk("black", colour="6a605e", depth=1.75, light=-0.02, white=0.70)),
    ("chalk-pale", "Pale sanguine", "brain,fat,skin,drawing",
     lambda: chalk("pale", colour="d59a80", depth=1.2, light=0.02, white=0.50)),
    ("chalk-veil", "Chalk veil", "skin,transparent,drawing",
     lambda: veil([(0, "8a3a28"), (0.5, "bb6a4a"), (1, "ecd0b0")], 1.6, 0.05)),
]

PENCIL = [
    ("pencil-soft", "Soft pencil", "vessel,muscle,drawing",
     lambda: pencil("soft", depth=2.5, light=-0.16, colour="5c5d62")),
    ("pencil-hard", "Hard pencil", "skin,fat,drawing", lambda: pencil("hard", depth=0.95, light=0.14)),
    ("pencil-middle", "Middle pencil", "organ,brain,drawing",
     lambda: pencil("middle", depth=1.5, light=-0.12, colour="85868c")),
    ("pencil-veil", "Pencil veil", "skin,transparent,drawing",
     lambda: veil([(0, "55565b"), (1, "a9a9ab")], 1.8, 0.04)),
]

STONE = [
    ("haeckel-bone", "Haeckel ochre", "bone,shaded",
     lambda: lithograph(stone("2f4a4c", "68806a", "c6a962", "ecd797", "fcf2cf"), "2c3b34")),
    ("haeckel-pearl", "Haeckel pearl", "tooth,shaded",
     lambda: lithograph(stone("3f4b70", "8790ad", "cfc6c6", "efe2d2", "fdf8ea"), "38405c")),
    ("haeckel-coral", "Haeckel coral", "skin,shaded",
     lambda: lithograph(stone("5c2140", "ab4850", "e5805c", "f5b68a", "fde5c6"), "5a1e30")),
    ("haeckel-crimson", "Haeckel crimson", "vessel,artery,shaded",
     lambda: lithograph(stone("2b0b30", "701240", "bc1e3a", "e65c48", "fab78f"), "30081f")),
    ("haeckel-lagoon", "Haeckel lagoon", "vessel,vein,shaded",
     lambda: lithograph(stone("101845", "24448a", "2f7fb0", "78c0c8", "d2eee2"), "10204a")),
    ("haeckel-vermilion", "Haeckel vermilion", "muscle,shaded",
     lambda: lithograph(stone("40101f", "8f2c1e", "d25c24", "f29f4a", "fbda9a"), "451410")),
    ("haeckel-plum", "Haeckel plum", "organ,shaded",
     lambda: lithograph(stone("1d1336", "4f2c62", "8c4d89", "cb8eac", "f2d3d4"), "22153a")),
    ("haeckel-sea", "Haeckel sea green", "brain,cartilage,shaded",
     lambda: lithograph(stone("0f3539", "2d6f69", "69ab93", "b6d8b7", "f0f5dc"), "12393a")),
    ("haeckel-saffron", "Haeckel saffron", "fat,shaded",
     lambda: lithograph(stone("6e3c12", "bb791e", "e6b03b", "f6d980", "fdf4cb"), "6a3c10")),
    ("haeckel-medusa", "Haeckel medusa", "skin,transparent",
     lambda: veil([(0, "1f5a6a"), (0.4, "4f9a9c"), (0.7, "d79a92"), (1, "fbe6cf")], 1.3, 0.06, shine=0.15)),
]

LIT = (0.18, 0.84)  # colours are dark on the board unless they reach far

BOARD = [
    ("board-white", "White board chalk", "bone,drawing,dark ground", lambda: board_chalk("white", "fbf8ee", 1.0, LIT)),
    ("board-red", "Red board chalk", "vessel,artery,drawing,dark ground",
     lambda: board_chalk("red", "ee6a58", 1.0, LIT)),
    ("board-blue", "Blue board chalk", "vessel,vein,drawing,dark ground",
     lambda: board_chalk("blue", "74b2ee", 1.0, LIT)),
    ("board-peach", "Peach board chalk", "skin,drawing,dark ground", lambda: board_chalk("peach", "fac6a2", 0.90, LIT)),
    ("board-rose", "Rose board chalk", "muscle,drawing,dark ground", lambda: board_chalk("rose", "ee8f98", 0.95, LIT)),
    ("board-green", "Green board chalk", "organ,cartilage,drawing,dark ground",
     lambda: board_chalk("green", "9ce0a8", 0.90, LIT)),
    ("board-lilac", "Lilac board chalk", "brain,drawing,dark ground", lambda: board_chalk("lilac", "d6bbf0", 1.0, LIT)),
    ("board-yellow", "Yellow board chalk", "fat,drawing,dark ground",
     lambda: board_chalk("yellow", "fae68c", 0.95, LIT)),
    ("board-veil", "Board chalk veil", "skin,transparent,dark ground",
     lambda: veil([(0, "8a948c"), (1, "f3f1e8")], 1.7, 0.03)),
]

WASH = [
    ("watercolour-skull", "Watercolour skull", "bone,watercolour",
     lambda: watercolour("skull", "fdf9f0", "e8d2a8", "5f6496", "cf8f86", 1.20)),
    ("watercolour-muscle", "Watercolour muscle", "muscle,watercolour",
     lambda: watercolour("muscle", "fcf6ec", "cc6a52", "6b2c34", "c24a4a", 1.25)),
    ("watercolour-brain", "Watercolour brain", "brain,organ,watercolour",
     lambda: watercolour("brain", "fcf7ef", "dfb3b4", "6f6a8c", "c79ab8", 1.10)),
    ("watercolour-fat", "Watercolour fat", "fat,watercolour",
     lambda: watercolour("fat", "fdf9ea", "f2d268", "b07d3c", "eaa64a", 1.05)),
    ("watercolour-cartilage", "Watercolour cartilage", "cartilage,watercolour",
     lambda: watercolour("cartilage", "fbf9f2", "a6d0cc", "4f7f90", "8fb8d8", 1.05)),
    ("watercolour-grey", "Watercolour grey", "industrial,neutral,watercolour",
     lambda: watercolour("grey", "fbf9f4", "b0b6c0", "4a5366", "8f98b0", 1.25)),
    ("watercolour-veil", "Watercolour veil", "skin,transparent,watercolour",
     lambda: veil([(0, "6f6a9e"), (0.4, "b493b0"), (0.75, "e9c3b6"), (1, "fdf2e6")], 1.35, 0.06)),
]

STYLES = ENGRAVED + INK + CHALK + PENCIL + STONE + BOARD + WASH
