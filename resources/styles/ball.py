"""The ball that every style is painted on: its normals, light, noise and colour arithmetic.

Colours are mixed in two ways: opaque matter in Oklab (even steps look even, and a mixture keeps its hue), transparent
pigment by its absorption, as light passes through it to the paper and back.
"""

import zlib

import numpy as np

SIZE = 512


def hex_srgb(text):
    return np.array([int(text[i : i + 2], 16) / 255 for i in (0, 2, 4)])


def linear_from_srgb(c):
    return np.where(c <= 0.04045, c / 12.92, ((np.maximum(c, 0) + 0.055) / 1.055) ** 2.4)


def srgb_from_linear(c):
    c = np.maximum(c, 0)
    return np.where(c <= 0.0031308, 12.92 * c, 1.055 * c ** (1 / 2.4) - 0.055)


# Oklab: linear sRGB -> cone responses -> lightness, green-red, blue-yellow.
_CONES = np.array([[0.4122214708, 0.5363325363, 0.0514459929],
                   [0.2119034982, 0.6806995451, 0.1073969566],
                   [0.0883024619, 0.2817188376, 0.6299787005]])
_LAB = np.array([[0.2104542553, 0.7936177850, -0.0040720468],
                 [1.9779984951, -2.4285922050, 0.4505937099],
                 [0.0259040371, 0.7827717662, -0.8086757660]])


def oklab_from_srgb(c):
    return np.cbrt(linear_from_srgb(c) @ _CONES.T) @ _LAB.T


def srgb_from_oklab(lab):
    return srgb_from_linear((lab @ np.linalg.inv(_LAB).T) ** 3 @ np.linalg.inv(_CONES).T)


def smoothstep(low, high, x):
    t = np.clip((x - low) / (high - low), 0, 1)
    return t * t * (3 - 2 * t)


def unit(x, y, z):
    v = np.array([x, y, z], float)
    return v / np.linalg.norm(v)


def _normals():
    # Texel centres; y up. Outside the disk the rim's normal goes on, so that no filter meets an edge there.
    axis = (2 * np.arange(SIZE) + 1) / SIZE - 1
    x, y = np.meshgrid(axis, -axis)
    shrink = np.minimum(1, 1 / np.maximum(np.hypot(x, y), 1e-9))
    x, y = x * shrink, y * shrink
    return np.stack([x, y, np.sqrt(np.maximum(0, 1 - x * x - y * y))], -1)


NORMAL = _normals()
FACING = NORMAL[..., 2]
# From the upper left and somewhat in front: the convention of medical illustration.
LIGHT = unit(-0.54, 0.62, 0.52)
# Where light comes back from table and neighbours: low, right, a little behind.
BOUNCE = unit(0.62, -0.62, -0.10)


def lambert(light=LIGHT):
    """n . l, from -1 to 1."""
    return NORMAL @ light


def soft_light(light=LIGHT):
    """Light from 0 to 1 that still tells forms apart in the shadow: the terminator at 0.35, what faces us at 0.66."""
    return (0.5 + 0.5 * lambert(light)) ** 1.5


def gloss(power, light=LIGHT):
    """Blinn's highlight."""
    halfway = light + np.array([0, 0, 1.0])
    return np.maximum(0, NORMAL @ (halfway / np.linalg.norm(halfway))) ** power


def rim(power):
    """0 in the middle, 1 at the rim."""
    return (1 - FACING) ** power


def ramp(t, keys, softness=0.035):
    """Oklab colours along keys [(t, 'rrggbb'), ...]; corners rounded over `softness`, so that no tone edge shows."""
    at = np.array([k[0] for k in keys], float)
    lab = oklab_from_srgb(np.array([hex_srgb(k[1]) for k in keys]))
    fine = np.linspace(-0.25, 1.25, 3073)
    reach = np.arange(-400, 401) * (fine[1] - fine[0])
    kernel = np.exp(-0.5 * (reach / softness) ** 2)
    kernel /= kernel.sum()
    table = np.stack([np.convolve(np.pad(np.interp(fine, at, lab[:, c]), 400, "edge"), kernel, "valid")
                      for c in range(3)], -1)
    t = np.clip(t, 0, 1)
    return np.stack([np.interp(t, fine, table[:, c]) for c in range(3)], -1)


def toward(lab, colour, weight):
    """Mixes Oklab colours toward one sRGB colour 'rrggbb'."""
    weight = np.asarray(weight)[..., None]
    return lab + weight * (oklab_from_srgb(hex_srgb(colour)) - lab)


def _fade(frequency, low, high):
    return np.exp(-((frequency / high) ** 2)) * (1 - np.exp(-((frequency / low) ** 2)))


def noise(name, low, high, stretch=(1, 1), angle=0.0):
    """Band-limited noise, mean 0, standard deviation 1, the same on every run. low, high: waves across the picture."""
    generator = np.random.Generator(np.random.PCG64(zlib.crc32(name.encode())))
    white = np.fft.rfft2(generator.standard_normal((SIZE, SIZE)))
    fy = np.fft.fftfreq(SIZE)[:, None] * SIZE
    fx = np.fft.rfftfreq(SIZE)[None, :] * SIZE
    across, along = np.cos(angle) * fx + np.sin(angle) * fy, np.cos(angle) * fy - np.sin(angle) * fx
    field = np.fft.irfft2(white * _fade(np.hypot(across / stretch[0], along / stretch[1]), low, high), (SIZE, SIZE))
    return (field - field.mean()) / field.std()


def absorption(colour):
    """Optical density of a pigment that turns white paper into this colour at density 1."""
    return -np.log(np.maximum(linear_from_srgb(hex_srgb(colour)), 1e-3))


def paint(paper, *layers):
    """sRGB of transparent pigments over paper: layers of (density array, 'rrggbb')."""
    light = np.broadcast_to(linear_from_srgb(hex_srgb(paper)), (SIZE, SIZE, 3)).copy()
    for density, colour in layers:
        light *= np.exp(-np.maximum(density, 0)[..., None] * absorption(colour))
    return srgb_from_linear(light)


def within_print(srgb):
    """Bends what lies near black and white back into the range, so that no tone clips."""
    knee = 0.06  # of the range at either end; tones between are left alone
    low, high = 0.012, 0.992
    s = np.asarray(srgb)
    top = high - knee
    s = np.where(s > top, top + knee * (1 - np.exp(-(s - top) / knee)), s)
    bottom = low + knee
    return np.where(s < bottom, bottom - knee * (1 - np.exp(-(bottom - s) / knee)), s)


def rgba(srgb, alpha=None):
    alpha = np.ones((SIZE, SIZE)) if alpha is None else np.broadcast_to(alpha, (SIZE, SIZE))
    srgb = np.broadcast_to(srgb, (SIZE, SIZE, 3))
    return np.concatenate([srgb, alpha[..., None]], -1)
