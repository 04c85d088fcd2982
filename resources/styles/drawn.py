"""Styles of the drawing table: ink, wash, watercolour, chalk, engraving, and glass for what should stay see-through.

Paper and brush are kept to broad, faint variation: a style is looked up by the normal, so any fine grain would crawl
over the form as it turns.
"""

import numpy as np

import ball
from ball import FACING, gloss, soft_light, lambert, noise, oklab_from_srgb, hex_srgb, paint, ramp, rim, rgba, smoothstep, toward, unit


def printed(srgb, alpha=None):
    return rgba(ball.within_print(srgb), alpha)


def wobble(name, amount):
    """The hand's unsteadiness: moves tone edges a little, over broad waves."""
    return amount * noise(name, 0.8, 3.2)


def watercolour(name, paper, body, shadow, accent, depth=1.0):
    """Two washes and an accent dropped in wet; the light stays paper, pigment gathers at the edge of each wash."""
    t = soft_light() + wobble(name, 0.022)
    first = smoothstep(0.90, 0.50, t)
    second = smoothstep(0.42, 0.22, t + wobble(name + "2", 0.012))
    third = smoothstep(0.24, 0.06, t)
    dried = 0.10 * np.exp(-(((t - 0.36) / 0.024) ** 2)) + 0.07 * np.exp(-(((t - 0.80) / 0.03) ** 2))
    back = smoothstep(0.1, 1.0, ball.NORMAL @ ball.BOUNCE)
    grain = 1 + 0.03 * noise(name + "grain", 3, 12)
    edge = smoothstep(0.42, 0.08, FACING)
    wash = depth * grain * (0.07 + 0.60 * first + 0.22 * second + dried + 0.22 * edge)
    dark = depth * grain * (0.30 * second + 0.34 * third + 0.16 * edge) * (1 - 0.45 * back)
    drop = depth * 0.26 * smoothstep(0.55, 0.38, t) * smoothstep(0.10, 0.30, t) * (1 + 0.5 * noise(name + "wet", 1, 3))
    return printed(paint(paper, (wash, body), (dark, shadow), (drop, accent)))


def ink_line():
    # The outline: pen pressed on the shadow side, lifted toward the light.
    width = 0.30 - 0.13 * lambert(unit(-0.62, 0.70, 0.0)) + wobble("pen", 0.008)
    line = smoothstep(width + 0.045, width - 0.045, FACING)
    tone = 0.10 * smoothstep(0.55, 0.15, soft_light())
    return printed(paint("fbf8f1", (3.2 * line + tone, "4a4245")))


def ink_wash():
    t = soft_light() + wobble("wash", 0.020)
    washes = [(0.84, 0.14), (0.56, 0.22), (0.36, 0.36), (0.18, 0.60)]
    density = sum(share * smoothstep(at + 0.045, at - 0.035, t) for at, share in washes)
    dried = sum(0.05 * np.exp(-(((t - at + 0.030) / 0.018) ** 2)) for at, _ in washes[:3])
    back = smoothstep(0.15, 1.0, ball.NORMAL @ ball.BOUNCE)
    density = (density + dried + 0.45 * smoothstep(0.34, 0.06, FACING)) * (1 - 0.45 * back)
    return printed(paint("faf7f0", (density * (1 + 0.03 * noise("ink", 3, 12)), "5f5f68")))


def hatch(axis, lines, share):
    """Ink of lines around an axis that swell to cover `share` of the ground; every edge has one soft width."""
    height = np.clip(ball.NORMAL @ axis, -1, 1)
    along = np.arccos(height) / np.pi * lines
    from_line = np.abs(2 * (along - np.floor(along)) - 1)
    soft = 0.30  # of a line's period: sharper lines would shimmer where the form turns quickly
    return smoothstep(share + soft, share - soft, from_line) * smoothstep(0.0, 0.12, share) * smoothstep(0.98, 0.80, np.abs(height))


def engraved(axis=(0.40, 0.86, 0.26), lines=10, cross=None, light=0.0, tone=1.55, tint=None):
    """Swelling lines around the form over a faint tone; they open into white in the light.

    axis, lines: what the lines go around, and how many; cross: the axis of a second set of lines, in the shadow;
    light: how much earlier the lines open; tone: density of the tone; tint: (density, colour) of a second plate.
    """
    t = soft_light() + light
    back = smoothstep(0.15, 1.0, ball.NORMAL @ ball.BOUNCE)
    share = np.clip(0.86 - 1.10 * t - 0.22 * back, 0, 0.74)
    ink = hatch(unit(*axis), lines, share)
    if cross is not None:
        ink = ink + 0.8 * hatch(unit(*cross), lines, np.clip(share - 0.16, 0, 0.6))
    shade = 0.55 * np.clip(0.80 - 1.15 * t - 0.20 * back, 0, 1)
    outline = smoothstep(0.25, 0.12, FACING)
    plates = [(np.maximum(0.36 * ink + tone * shade, 2.2 * outline) + 0.03, "54494a")]
    if tint is not None:
        density, colour = tint
        plates.append((density * smoothstep(1.02, 0.80, t), colour))  # the second plate leaves the lights to the paper
    return printed(paint("f8f4e9", *plates))


def pencil(name, depth=1.55, light=0.0, colour="6a6b70"):
    """Graphite on smooth paper, laid in strokes. depth: how soft the lead is; light: how much paper it leaves."""
    t = soft_light() - 0.10 * rim(2.0) + wobble(name + "hand", 0.012) + light
    back = smoothstep(0.1, 1.0, ball.NORMAL @ ball.BOUNCE)
    tooth = noise(name + "tooth", 7, 24)
    strokes = noise(name + "strokes", 5, 22, stretch=(1, 0.10), angle=0.75)
    density = np.clip(1.02 - 1.16 * t, 0, 1) ** 1.5 - 0.20 * back
    density = np.clip(density, 0.02, 1) * (1 + 0.025 * tooth + 0.055 * strokes)
    density += 0.30 * smoothstep(0.34, 0.10, FACING)
    return printed(paint("f6f4ef", (depth * density, colour)))


def chalk(name, colour="b4583c", depth=1.35, light=0.0, white=0.85):
    """Chalk on cream paper, heightened with white. depth: how hard it is pressed; white: of the heightening."""
    t = soft_light() + wobble(name + "chalk", 0.014) + light
    back = smoothstep(0.1, 1.0, ball.NORMAL @ ball.BOUNCE)
    tooth = noise(name + "laid", 6, 22)
    strokes = noise(name + "chalk strokes", 4, 18, stretch=(1, 0.12), angle=-0.7)
    density = np.clip(1.00 - 1.12 * t, 0, 1) ** 1.45
    density = (0.06 + density * (1 + 0.03 * tooth + 0.06 * strokes) + 0.22 * rim(3.0)) * (1 - 0.34 * back)
    lab = oklab_from_srgb(np.clip(paint("efe0c6", (depth * density, colour)), 0, 1))
    heightening = smoothstep(0.74, 0.98, t) * (1 + 0.04 * tooth)
    return printed(ball.srgb_from_oklab(toward(lab, "fffaf0", np.clip(white * heightening, 0, 1))))


def sepia():
    t = soft_light() - 0.06 * rim(2.2) + wobble("sepia", 0.014)
    back = smoothstep(0.1, 1.0, ball.NORMAL @ ball.BOUNCE)
    density = (1.35 * np.clip(1.06 - 1.10 * t, 0.02, 1) ** 1.35) * (1 - 0.34 * back)
    density *= 1 + 0.025 * noise("sepia grain", 3, 12)
    return printed(paint("f5ead2", (density, "a6794a"), (0.62 * smoothstep(0.5, 0.1, t) * (1 - 0.4 * back), "6b4a38")))


def board_chalk(name, colour="f3f1e8", body=0.80, reach=(0.30, 0.98)):
    """Chalk on a dark board: the light is drawn, the shadow is the board.

    body: how full the tone is; reach: the light where it starts, and where it is full.
    """
    t = soft_light()
    tooth = noise(name + "slate", 7, 24)
    strokes = noise(name + "stick", 4, 18, stretch=(1, 0.10), angle=0.75)
    outline = smoothstep(0.52, 0.16, FACING) * (0.72 + 0.28 * smoothstep(0.2, 0.9, t))
    tone = body * smoothstep(*reach, t) ** 1.2
    cover = np.clip(np.maximum(outline, tone) * (0.92 + 0.02 * tooth + 0.045 * strokes), 0, 0.96)
    board = np.broadcast_to(oklab_from_srgb(hex_srgb("22302c")), ball.NORMAL.shape)
    return printed(ball.srgb_from_oklab(toward(board, colour, cover)))


def cel_two_tone():
    t = soft_light()
    lit = smoothstep(0.45 - 0.012, 0.45 + 0.012, t)
    spark = smoothstep(0.955, 0.965, ball.NORMAL @ unit(-0.36, 0.44, 0.82))
    lab = toward(np.broadcast_to(oklab_from_srgb(hex_srgb("8f6f8a")), ball.NORMAL.shape), "f2d5b4", lit)
    lab = toward(lab, "fff8ea", 0.9 * spark)
    lab = toward(lab, "33222f", smoothstep(0.235, 0.185, FACING))
    return printed(ball.srgb_from_oklab(lab))


def cool_warm():
    keys = [(0, "1f3a7a"), (0.25, "4a69a6"), (0.5, "9a9aa2"), (0.75, "e0b36a"), (1, "fbe3a4")]
    lab = toward(ramp(soft_light(), keys, 0.08), "ffffff", 0.75 * gloss(46))
    return printed(ball.srgb_from_oklab(toward(lab, "1c2030", smoothstep(0.22, 0.10, FACING))))


def glass():
    # Clear where one looks through it, denser where its wall is seen edge-on.
    rims = smoothstep(0.0, 1.0, rim(1.7))
    lab = ramp(soft_light() - 0.25 * rim(2.5), [(0, "2d5560"), (0.4, "7fb0b8"), (0.75, "cfe8ea"), (1, "f6fdfd")], 0.06)
    window = smoothstep(0.950, 0.972, ball.NORMAL @ unit(-0.40, 0.48, 0.78))
    lower = 0.55 * smoothstep(0.6, 1.0, ball.NORMAL @ unit(0.62, -0.66, 0.42)) ** 3
    lab = toward(toward(lab, "ffffff", window), "f2fffe", lower)
    alpha = np.clip(0.05 + 0.95 * rims + 0.90 * window + 0.35 * lower, 0, 1)
    return printed(ball.srgb_from_oklab(lab), alpha)


def xray_rim():
    # Path length through a thin shell: bright where it is cut edge-on.
    thickness = 1 / np.sqrt(FACING**2 + 0.045)
    glow = np.clip((thickness - 1) / (1 / np.sqrt(0.045) - 1), 0, 1) ** 1.2
    lab = ramp(glow, [(0, "3f78a6"), (0.3, "7fb5d8"), (0.7, "cfe6f3"), (1, "fbfdff")], 0.06)
    return printed(ball.srgb_from_oklab(lab), np.clip(0.05 + 0.95 * glow**0.85, 0, 1))


def ghost_skin():
    t = soft_light() - 0.10 * rim(2.0)
    keys = [(0, "8d4f3c"), (0.4, "d69b7c"), (0.7, "f1c8ab"), (1, "fdeee0")]
    lab = toward(ramp(t, keys), "fffaf4", 0.5 * gloss(30))
    alpha = 0.07 + 0.86 * smoothstep(0.0, 1.0, rim(1.25)) + 0.22 * gloss(30)
    return printed(ball.srgb_from_oklab(lab), np.clip(alpha, 0, 1))


STYLES = [
    ("watercolour-skin", "Watercolour skin", "skin,soft tissue,watercolour",
     lambda: watercolour("skin", "fcf6ec", "eebb97", "a8685c", "d97f72", 0.95)),
    ("watercolour-vessel", "Watercolour vessel", "vessel,organ,watercolour",
     lambda: watercolour("vessel", "fcf6ee", "d9705c", "7d3a58", "a84a80", 1.05)),
    ("watercolour-artery", "Watercolour artery", "vessel,artery,watercolour",
     lambda: watercolour("artery", "fcf6ec", "e2533f", "8a2430", "e88a3a", 1.10)),
    ("watercolour-vein", "Watercolour vein", "vessel,vein,watercolour",
     lambda: watercolour("vein", "fbf7ef", "7d9fd2", "34437f", "7a5ea6", 1.10)),
    ("watercolour-bone", "Watercolour bone", "bone,watercolour",
     lambda: watercolour("watercolour bone", "fcf8ee", "e6cb98", "80695f", "b5906a", 1.20)),
    ("ink-line", "Ink line", "outline,ink,bone", ink_line),
    ("ink-wash", "Ink wash", "ink,bone,organ,neutral", ink_wash),
    ("engraving", "Engraving", "ink,bone,outline", engraved),
    ("graphite", "Graphite", "drawing,bone,neutral", lambda: pencil("")),
    ("red-chalk", "Red chalk", "drawing,muscle,skin", lambda: chalk("")),
    ("sepia", "Sepia wash", "drawing,bone,organ", sepia),
    ("blackboard-chalk", "Blackboard chalk", "drawing,outline,dark ground", lambda: board_chalk("")),
    ("cel-two-tone", "Cel, two tones", "bone,skin,organ,graphic", cel_two_tone),
    ("cool-warm", "Cool to warm", "neutral,organ,industrial,graphic", cool_warm),
    ("glass", "Glass", "skin,transparent", glass),
    ("xray-rim", "X-ray rim", "skin,organ,transparent,outline,dark ground", xray_rim),
    ("ghost-skin", "Ghost skin", "skin,transparent", ghost_skin),
]
