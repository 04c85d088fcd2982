"""Styles of opaque matter: tissue, bone, and what models are made of."""

import numpy as np

import ball
from ball import FACING, gloss, soft_light, hex_srgb, oklab_from_srgb, ramp, rim, rgba, smoothstep, toward


def matter(keys, shade=(0.10, 3.0), bounce=(0.06, None), shine=(), tint=(), mottle=None):
    """A soft ball: tone ramp under soft light, darker toward the rim, light coming back from below.

    keys: tone ramp, shadow at 0, full light at 1; shade: (depth, power) of the darkening toward the rim;
    bounce: (strength, colour or None for the matter's own); shine: (strength, power, colour) each;
    tint: (weight array, colour) each, mixed in last; mottle: (name, strength, lowest, highest wave).
    """
    depth, power = shade
    strength, colour = bounce
    back = smoothstep(0.05, 1.0, ball.NORMAL @ ball.BOUNCE)
    t = soft_light() - depth * rim(power) + strength * back
    if mottle is not None:
        name, amount, low, high = mottle
        t = t + amount * ball.noise(name, low, high)
    lab = ramp(t, keys)
    if colour is not None:
        lab = toward(lab, colour, 3.0 * strength * back)
    for amount, exponent, light in shine:
        lab = toward(lab, light, amount * gloss(exponent))
    for weight, colour in tint:
        lab = toward(lab, colour, weight)
    return rgba(ball.within_print(ball.srgb_from_oklab(lab)))


def ivory_bone():
    keys = [(0, "5a453a"), (0.2, "8c6f57"), (0.42, "c6aa86"), (0.64, "eadab8"), (0.84, "f8efda"), (1, "fdf9ef")]
    return matter(keys, shade=(0.16, 2.4), bounce=(0.10, "b98a62"), mottle=("bone", 0.006, 2, 9))


def ochre_bone():
    keys = [(0, "33221a"), (0.2, "5f4024"), (0.42, "a0743c"), (0.64, "cfa866"), (0.84, "ecd29b"), (1, "faecc6")]
    return matter(keys, shade=(0.22, 2.0), bounce=(0.08, "7d5a5a"), mottle=("ochre", 0.009, 2, 9))


def plaster():
    keys = [(0, "55575c"), (0.25, "85878b"), (0.5, "b9b9b8"), (0.75, "dedcd8"), (1, "f7f5f0")]
    return matter(keys, shade=(0.12, 2.6), bounce=(0.10, "b2aca4"), mottle=("plaster", 0.004, 4, 14))


def tooth_enamel():
    keys = [(0, "4f4c5a"), (0.2, "837c80"), (0.42, "c0b4a2"), (0.66, "ece1ca"), (0.86, "f8f2e4"), (1, "fdfbf6")]
    return matter(keys, shade=(0.14, 2.2), bounce=(0.12, "d9b3a2"), shine=[(0.85, 60, "ffffff"), (0.35, 9, "fbfcff")],
                  tint=[(0.35 * rim(2.2), "a9bccb")])


def cartilage():
    keys = [(0, "34505f"), (0.22, "5f8494"), (0.44, "97b9c1"), (0.68, "cbdfde"), (1, "f3f8f3")]
    return matter(keys, shade=(0.10, 2.6), bounce=(0.12, "c9c3ae"), shine=[(0.55, 22, "ffffff")],
                  tint=[(0.30 * rim(1.6), "8db4c4")])


def textbook_skin():
    keys = [(0, "6d3527"), (0.2, "9c5a42"), (0.42, "cf9070"), (0.64, "ebbd9b"), (0.84, "f8dcc3"), (1, "fef1e4")]
    return matter(keys, shade=(0.13, 2.6), bounce=(0.10, "c98d86"), shine=[(0.16, 14, "fff8f0")])


def deep_skin():
    keys = [(0, "22120f"), (0.2, "44271d"), (0.42, "6f432f"), (0.64, "99643f"), (0.84, "c08d63"), (1, "e0b992")]
    return matter(keys, shade=(0.14, 2.4), bounce=(0.11, "6e4a52"), shine=[(0.30, 16, "f2dccb")])


def soft_tissue():
    keys = [(0, "7a3a44"), (0.22, "ab5e66"), (0.45, "d68e8f"), (0.68, "efb9b2"), (0.86, "f9d9d0"), (1, "feeee8")]
    return matter(keys, shade=(0.10, 2.4), bounce=(0.12, "e2a58f"), shine=[(0.45, 26, "fffaf6")])


def muscle():
    keys = [(0, "36090c"), (0.2, "641416"), (0.42, "982a25"), (0.64, "bf4d3d"), (0.84, "d97b63"), (1, "efae95")]
    grain = ball.noise("muscle", 3, 13, stretch=(1, 0.12), angle=0.5) * 0.016
    return matter(keys, shade=(0.12, 2.2), bounce=(0.11, "8d4152"), shine=[(0.40, 34, "ffe6da")],
                  tint=[(np.clip(0.10 + 3.0 * grain, 0, 0.25) * smoothstep(0.1, 0.7, FACING), "e8b59c")])


def fat():
    keys = [(0, "8a5a1c"), (0.22, "b98532"), (0.45, "dfb458"), (0.68, "f2d587"), (0.86, "faebb8"), (1, "fef8df")]
    return matter(keys, shade=(0.08, 2.2), bounce=(0.14, "e6a861"), shine=[(0.50, 18, "fffdf2")],
                  mottle=("fat", 0.012, 2, 7))


def liver():
    keys = [(0, "240b0a"), (0.2, "451612"), (0.42, "6f2a20"), (0.64, "934436"), (0.84, "b3685a"), (1, "cf9687")]
    return matter(keys, shade=(0.10, 2.4), bounce=(0.12, "5a3350"), shine=[(0.70, 70, "fff3ec"), (0.28, 10, "e7b9a9")])


def lung():
    keys = [(0, "5b4450"), (0.22, "8a6a74"), (0.45, "b9969a"), (0.68, "dbbdbb"), (0.86, "eedcd8"), (1, "f9f0ec")]
    return matter(keys, shade=(0.12, 2.2), bounce=(0.12, "9aa0b8"), mottle=("lung", 0.010, 5, 16))


def brain():
    keys = [(0, "4f3a3f"), (0.22, "84656a"), (0.45, "b8979a"), (0.68, "dcc2bf"), (0.86, "efdfd9"), (1, "faf2ec")]
    return matter(keys, shade=(0.22, 1.8), bounce=(0.09, "b47f86"), shine=[(0.40, 40, "ffffff")],
                  tint=[(0.32 * rim(1.4), "9c4f55")])


def artery():
    keys = [(0, "3d0306"), (0.2, "780a10"), (0.42, "b4161a"), (0.64, "db3a30"), (0.84, "ee7560"), (1, "f9ab98")]
    return matter(keys, shade=(0.12, 2.6), bounce=(0.14, "a2304e"), shine=[(0.85, 80, "fff4ee"), (0.20, 10, "ffc7b4")])


def vein():
    keys = [(0, "0e1638"), (0.2, "1d2f68"), (0.42, "36549a"), (0.64, "5f82bf"), (0.84, "93afd9"), (1, "c3d5ee")]
    return matter(keys, shade=(0.12, 2.6), bounce=(0.14, "54498e"), shine=[(0.80, 80, "f6faff"), (0.18, 10, "c9dcf6")])


def wax():
    keys = [(0, "7c3f1e"), (0.22, "b46a38"), (0.45, "dc9f66"), (0.68, "efc694"), (0.86, "f7dfbb"), (1, "fcf0da")]
    # Light soaks in and comes out around the terminator, redder there.
    glow = np.exp(-(((soft_light() - 0.30) / 0.17) ** 2))
    return matter(keys, shade=(0.02, 3.0), bounce=(0.20, "e58a4e"), shine=[(0.30, 12, "fff6e6"), (0.25, 40, "fffdf6")],
                  tint=[(0.28 * glow, "e0723c")])


def porcelain():
    keys = [(0, "4c5f86"), (0.2, "8798b6"), (0.42, "bfcadb"), (0.64, "e4e9ee"), (1, "fbfbf9")]
    window = smoothstep(0.950, 0.975, ball.NORMAL @ ball.unit(-0.34, 0.42, 0.84))
    return matter(keys, shade=(0.16, 2.0), bounce=(0.18, "d8d4dc"), shine=[(0.30, 8, "ffffff")],
                  tint=[(0.92 * window, "ffffff"), (0.30 * rim(3.0), "7089b8")])


def metal(stops, softness, tint=()):
    """Mirrors a studio: the ramp is read along the height from which the mirrored view ray comes."""
    mirrored_y = 2 * FACING * ball.NORMAL[..., 1]
    mirrored_x = 2 * FACING * ball.NORMAL[..., 0]
    height = 0.5 + 0.5 * np.clip(0.86 * mirrored_y - 0.42 * mirrored_x, -1, 1)
    lab = ramp(height - 0.10 * rim(3.0), stops, softness)
    for weight, colour in tint:
        lab = toward(lab, colour, weight)
    return rgba(ball.within_print(ball.srgb_from_oklab(lab)))


def brass():
    stops = [(0, "3a2208"), (0.16, "7c5315"), (0.3, "b98a2c"), (0.42, "5a380d"), (0.5, "4a2c0a"), (0.58, "a47722"),
             (0.74, "e2bb58"), (0.86, "fbe9a8"), (1, "f1d27c")]
    return metal(stops, 0.04, [(0.7 * gloss(50), "fffbe6"), (0.35 * rim(2.5), "5c3c10")])


def steel():
    stops = [(0, "2c3036"), (0.18, "70777f"), (0.32, "a4abb2"), (0.43, "474d55"), (0.5, "3a4047"), (0.6, "8f979f"),
             (0.76, "d3d9de"), (0.88, "f6f8f9"), (1, "dde2e6")]
    return metal(stops, 0.045, [(0.7 * gloss(50), "ffffff"), (0.35 * rim(2.5), "4a5058")])


def flat(colour):
    """One tone: shading is left to contours and to the plates around it."""
    return rgba(hex_srgb(colour))


STYLES = [
    ("ivory-bone", "Ivory bone", "bone,tooth,shaded", ivory_bone),
    ("ochre-bone", "Ochre bone", "bone,shaded,textbook", ochre_bone),
    ("plaster", "Plaster cast", "bone,neutral,shaded", plaster),
    ("tooth-enamel", "Tooth enamel", "tooth,bone,shaded", tooth_enamel),
    ("cartilage", "Cartilage", "cartilage,shaded", cartilage),
    ("textbook-skin", "Textbook skin", "skin,shaded,textbook", textbook_skin),
    ("deep-skin", "Deep skin", "skin,shaded,textbook", deep_skin),
    ("soft-tissue", "Soft tissue", "soft tissue,organ,skin,shaded", soft_tissue),
    ("muscle", "Muscle", "muscle,organ,shaded", muscle),
    ("fat", "Fat", "fat,soft tissue,shaded", fat),
    ("liver", "Liver", "organ,shaded", liver),
    ("lung", "Lung", "organ,lung,shaded", lung),
    ("brain", "Brain", "brain,organ,shaded", brain),
    ("artery", "Artery", "vessel,artery,shaded", artery),
    ("vein", "Vein", "vessel,vein,shaded", vein),
    ("wax", "Anatomical wax", "skin,organ,shaded,anatomical model", wax),
    ("porcelain", "Porcelain", "bone,tooth,neutral,shaded", porcelain),
    ("brass", "Brass", "industrial,metal", brass),
    ("steel", "Steel", "industrial,metal", steel),
    ("flat-paper", "Flat paper white", "flat,paper", lambda: flat("f7f3ea")),
    ("flat-bone", "Flat bone", "flat,bone", lambda: flat("e6d4ae")),
    ("flat-skin", "Flat skin", "flat,skin", lambda: flat("ecc0a2")),
    ("flat-vessel", "Flat vessel red", "flat,vessel,artery", lambda: flat("c4342d")),
    ("flat-vein", "Flat vein blue", "flat,vessel,vein", lambda: flat("4668a8")),
    ("flat-muscle", "Flat muscle", "flat,muscle,organ", lambda: flat("a6443c")),
    ("flat-ink", "Flat ink", "flat,ink,outline", lambda: flat("1d1a1c")),
]
