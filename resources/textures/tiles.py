"""The tiles: fields that repeat without a seam, as factors around 1 (grey 0.5 leaves a style's colour as it is).

Everything is made of what repeats by itself: noise by its spectrum, waves with whole numbers of periods, and distances
that go around the edges.
"""

import zlib

import numpy as np

SIZE = 256
_AXIS = (np.arange(SIZE) + 0.5) / SIZE
X, Y = np.meshgrid(_AXIS, _AXIS)


def generator(name):
    return np.random.Generator(np.random.PCG64(zlib.crc32(name.encode())))


def noise(name, low, high, stretch=(1, 1), angle=0.0):
    """Mean 0, standard deviation 1. low, high: waves across the tile; stretch: of the waves along the angle."""
    white = np.fft.rfft2(generator(name).standard_normal((SIZE, SIZE)))
    fy = np.fft.fftfreq(SIZE)[:, None] * SIZE
    fx = np.fft.rfftfreq(SIZE)[None, :] * SIZE
    across, along = np.cos(angle) * fx + np.sin(angle) * fy, np.cos(angle) * fy - np.sin(angle) * fx
    waves = np.hypot(across / stretch[0], along / stretch[1])
    field = np.fft.irfft2(white * np.exp(-((waves / high) ** 2)) * (1 - np.exp(-((waves / low) ** 2))), (SIZE, SIZE))
    return (field - field.mean()) / field.std()


def smoothstep(low, high, x):
    t = np.clip((x - low) / (high - low), 0, 1)
    return t * t * (3 - 2 * t)


def wave(cycles):
    """A cosine of the phase in whole turns."""
    return np.cos(2 * np.pi * cycles)


def from_points(points, count):
    """Distances from every texel to its `count` nearest points, nearest first, and which point is the nearest; edges
    of the tile join. Points must be spread well enough that none is further than four of their mean distances.
    """
    best = np.full((count, SIZE, SIZE), 9.0)
    owner = np.zeros((SIZE, SIZE), int)
    reach = np.arange(-int(4 * SIZE / np.sqrt(len(points))), int(4 * SIZE / np.sqrt(len(points))) + 1)
    for i, point in enumerate(points):
        centre = (point * SIZE).astype(int)
        columns, rows = centre[0] + reach, centre[1] + reach
        d = np.hypot((columns + 0.5) / SIZE - point[0], ((rows + 0.5) / SIZE - point[1])[:, None])
        place = np.ix_(rows % SIZE, columns % SIZE)
        owner[place] = np.where(d < best[0][place], i, owner[place])
        for k in range(count):
            known = best[k][place]
            best[k][place], d = np.minimum(known, d), np.maximum(known, d)
    return best, owner


def spread_points(name, count, rounds):
    """Points that keep away from each other: Lloyd's method around the edges of the tile."""
    points = generator(name).random((count, 2))
    for _ in range(rounds):
        _, owner = from_points(points, 1)
        owner = owner.ravel()
        share = np.maximum(np.bincount(owner, minlength=count), 1)
        for axis, place in enumerate((X, Y)):  # means of offsets that go the short way around
            offset = (place.ravel() - points[owner, axis] + 0.5) % 1 - 0.5
            points[:, axis] = (points[:, axis] + np.bincount(owner, offset, count) / share) % 1
    return points


def paper():
    return 0.055 * noise("paper", 24, 80) + 0.030 * noise("pulp", 3, 16) + 0.02 * noise("fibre", 10, 60, (0.2, 1), 0.6)


def laid_paper():
    lines = wave(32 * Y + 0.05 * noise("mould", 1, 5))
    chains = smoothstep(0.93, 1.0, wave(3 * X + 0.012 * noise("chain", 1, 4)))
    return 0.060 * lines - 0.10 * chains + 0.030 * noise("sheet", 16, 80)


def marble():
    warp = noise("drift", 1, 3.5)
    ridge = np.abs(noise("vein", 1.2, 5) + 0.35 * warp)
    fine = np.abs(noise("vein 2", 3, 12) + 0.3 * warp)
    veins = 0.30 * np.exp(-((ridge / 0.10) ** 2)) * smoothstep(-1.6, 0.6, noise("run", 1, 3))
    hair = 0.14 * np.exp(-((fine / 0.08) ** 2)) * smoothstep(0.0, 1.4, warp)
    return 0.045 * noise("cloud", 1, 5) - veins - hair


def stipple():
    distance, owner = from_points(spread_points("stipple", 420, 10), 1)
    radius = (0.0085 + 0.0035 * generator("sizes").random(420))[owner]
    return -0.34 * smoothstep(radius + 0.004, radius - 0.004, distance[0])


def hatching():
    lines = wave(10 * X + 10 * Y + 0.10 * noise("hand", 1, 4)) * 0.5 + 0.5
    width = 0.42 + 0.16 * noise("press", 1, 6, (1, 0.4), 0.785)
    strokes = smoothstep(0.72 + 0.10 * noise("lift", 1, 5), 0.3, noise("break", 2, 7, (1, 0.25), 0.785) - 1.2)
    return -0.30 * smoothstep(1 - width, 1.15 - width, lines) * (0.55 + 0.45 * strokes)


def canvas():
    count = 24
    along_x, along_y = np.abs(np.sin(np.pi * count * Y)), np.abs(np.sin(np.pi * count * X))
    over = 0.5 + 0.5 * np.sin(np.pi * count * X) * np.sin(np.pi * count * Y)  # which thread lies on top
    thread = over * along_x**0.7 + (1 - over) * along_y**0.7
    slub = 0.025 * noise("weft", 4, 30, (0.12, 1)) + 0.025 * noise("warp", 4, 30, (1, 0.12))
    return 0.34 * thread + slub + 0.02 * noise("lint", 30, 90)


def wood():
    rings = 7 * X + 0.55 * noise("growth", 0.8, 3, (1, 0.35)) + 0.03 * noise("ray", 4, 20, (1, 0.2))
    phase = rings % 1
    late = phase**3 * smoothstep(1.0, 0.93, phase)  # early wood is pale, late wood dark and sharply ended
    fibres = noise("fibres", 12, 100, (1, 0.06))
    vessels = smoothstep(1.7, 2.6, noise("vessels", 16, 90, (1, 0.10)))
    return -0.26 * late + 0.035 * fibres - 0.10 * vessels


def spongiosa():
    warp = 0.35 * noise("load", 2, 8)
    distance, _ = from_points(spread_points("marrow", 110, 3), 2)
    strut = (distance[1] - distance[0]) * np.sqrt(110)
    bone = smoothstep(0.36 + 0.10 * warp, 0.10, strut)
    return 0.42 * bone + 0.05 * noise("lamella", 6, 30) - 0.10 * smoothstep(0.5, 0.9, strut)


def leather():
    distance, _ = from_points(spread_points("hide", 300, 4), 2)
    fold = (distance[1] - distance[0]) * np.sqrt(300)
    return 0.20 * smoothstep(0.02, 0.42, fold) - 0.04 * (distance[0] * np.sqrt(300)) + 0.02 * noise("wear", 8, 50)


def skin_pores():
    distance, owner = from_points(spread_points("pores", 260, 5), 2)
    depth = (0.5 + 0.5 * generator("depths").random(260))[owner]
    pore = depth * smoothstep(0.010, 0.003, distance[0])
    lines = np.exp(-((noise("crease a", 5, 22, (1, 0.30), 0.5) / 0.16) ** 2))
    lines = np.maximum(lines, np.exp(-((noise("crease b", 5, 22, (1, 0.30), -0.6) / 0.16) ** 2)))
    return -0.26 * pore - 0.06 * lines + 0.035 * noise("tone", 2, 12)


# id, name, tags, edge of the tile on the object in mm that suits it, the field
TILES = [
    ("paper", "Paper grain", "paper,drawing", 15, paper),
    ("laid-paper", "Laid paper", "paper,drawing", 30, laid_paper),
    ("marble", "Marble veins", "stone", 60, marble),
    ("stipple", "Stipple grain", "ink,drawing", 15, stipple),
    ("hatching", "Hatching lines", "ink,drawing", 15, hatching),
    ("canvas", "Canvas", "cloth,painting", 15, canvas),
    ("wood", "Wood grain", "wood", 50, wood),
    ("spongiosa", "Spongy bone", "bone", 15, spongiosa),
    ("leather", "Leather", "skin,organ", 20, leather),
    ("skin-pores", "Skin pores", "skin", 20, skin_pores),
]
