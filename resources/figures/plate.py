"""A plate for the figure "spheres of a plate": three balls of bundled styles on old paper, as an artist's study sheet."""

import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, "styles"))
import drawn  # noqa: E402  (the bundled styles)

SIZE = 768
RADIUS = 0.125  # of the plate's edge
BALLS = [("engraving", 0.19), ("red-chalk", 0.5), ("sepia", 0.81)]  # style, place across
HEIGHT = 0.19  # of the balls' centres, from the top
PAPER = np.array([0.957, 0.925, 0.847])
INK = np.array([0.23, 0.19, 0.16])


def blend(plate, colour, cover):
    plate += (colour - plate) * cover[..., None]


def paper(x, y):
    """Browner toward the edges, with the fibres' faint unevenness."""
    edge = np.minimum(np.minimum(x, 1 - x), np.minimum(y, 1 - y))
    fibres = np.random.default_rng(7).normal(0, 1, (SIZE // 8, SIZE // 8)).repeat(8, 0).repeat(8, 1)
    for _ in range(3):  # boxes of 8 to a soft mottle
        for axis in (0, 1):
            fibres = (fibres + np.roll(fibres, 4, axis) + np.roll(fibres, -4, axis)) / 3
    tone = 1 - 0.10 * np.exp(-edge / 0.05) + 0.006 * fibres
    return PAPER * tone[..., None] ** np.array([0.8, 1.0, 1.5])


def frame(plate, x, y):
    """A double rule, as around a printed plate."""
    edge = np.minimum(np.minimum(x, 1 - x), np.minimum(y, 1 - y)) * SIZE
    for at, width in ((24, 1.4), (30, 0.6)):
        blend(plate, INK, 0.8 * np.clip(width + 0.5 - abs(edge - at), 0, 1))


def shadow(plate, x, y, across):
    u = (x - across - 0.15 * RADIUS) / (0.9 * RADIUS)
    v = (y - HEIGHT - 0.98 * RADIUS) / (0.22 * RADIUS)
    blend(plate, INK, 0.42 * np.exp(-1.6 * (u * u + v * v)))


def ball(plate, picture, across):
    """The style's disk, each pixel the mean of 3 x 3 places."""
    size = picture.shape[0]
    total = np.zeros((SIZE, SIZE, 4))
    places = (np.arange(3) - 1) / 3
    rows, columns = np.mgrid[0:SIZE, 0:SIZE] + 0.5
    for dx in places:
        for dy in places:
            u = ((columns + dx) / SIZE - across) / RADIUS
            v = ((rows + dy) / SIZE - HEIGHT) / RADIUS
            inside = u * u + v * v < 1
            i = np.clip(((v + 1) * size / 2).astype(int), 0, size - 1)
            j = np.clip(((u + 1) * size / 2).astype(int), 0, size - 1)
            texel = picture[i, j]
            alpha = texel[..., 3] * inside
            total += np.concatenate([texel[..., :3] * alpha[..., None], alpha[..., None]], -1)
    total /= places.size**2
    plate *= 1 - total[..., 3:]
    plate += total[..., :3]


def plate():
    """(SIZE, SIZE, 4): sRGB and alpha, 0..1."""
    rows, columns = (np.mgrid[0:SIZE, 0:SIZE] + 0.5) / SIZE
    drawn_styles = {identity: draw for identity, _, _, draw in drawn.STYLES}
    picture = paper(columns, rows)
    frame(picture, columns, rows)
    for identity, across in BALLS:
        shadow(picture, columns, rows, across)
        ball(picture, drawn_styles[identity](), across)
    return np.concatenate([np.clip(picture, 0, 1), np.ones((SIZE, SIZE, 1))], -1)
