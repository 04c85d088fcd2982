#!/usr/bin/env python3
"""What leaving things out saves each sample figure: a table of `limner explain --savings`, and its sum.

Usage: tests/bench/savings.py LIMNER FOLDER...     the folders hold the figures' scans; a figure without one is counted
"""
import json
import pathlib
import subprocess
import sys

FIGURES = pathlib.Path(__file__).resolve().parents[2] / "resources" / "figures"
MIB = 1 << 20


def found(name, folders):
    return next((folder / name for folder in folders if (folder / name).exists()), None)


def measured(limner, name, figure, folders):
    """The savings of a figure, or nothing where its scan or labels are not there."""
    inputs = [figure["volume"]["path"]] + [figure[key]["path"] for key in ("labels",) if key in figure]
    paths = [found(path, folders) for path in inputs]
    if None in paths:
        return None
    command = [limner, "explain", paths[0], "--figure", name, "--savings", "--size", "256x256", "--json"]
    if len(paths) > 1:
        command += ["--labels", paths[1]]
    output = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    return json.loads(output)["savings"]


def most(rules, unit, scale, least):
    best = max(rules, key=lambda rule: rule[unit], default=None)
    return f"{best['name']} {best[unit] / scale:.{0 if unit == 'milliseconds' else 1}f}" \
        if best and best[unit] >= least else "-"


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    folders = [pathlib.Path(folder) for folder in sys.argv[2:]]
    sums = [0.0, 0.0, 0.0, 0.0]
    missing = 0
    print("| sample figure | picture, ms | saved, ms | most of it by | MiB | saved, MiB | most of it by |")
    print("| --- | --- | --- | --- | --- | --- | --- |")
    for file in sorted(FIGURES.glob("*.json")):
        savings = measured(sys.argv[1], file.stem, json.loads(file.read_text()), folders)
        if savings is None:
            missing += 1
            continue
        picture, with_all = savings["picture"], savings["without_any"]
        saved = with_all["milliseconds"] - picture["milliseconds"]
        less = with_all["bytes"] - picture["bytes"]
        print(f"| {file.stem} | {picture['milliseconds']:.0f} | {round(saved)} | "
              f"{most(savings['rules'], 'milliseconds', 1, 0.05 * picture['milliseconds'])} | "
              f"{picture['bytes'] / MIB:.1f} | {less / MIB:.1f} | {most(savings['rules'], 'bytes', MIB, 0.05 * MIB)} |",
              flush=True)
        sums = [a + b for a, b in zip(sums, (picture["milliseconds"], saved, picture["bytes"] / MIB, less / MIB))]
    print(f"| **all** | {sums[0]:.0f} | {sums[1]:.0f} | | {sums[2]:.1f} | {sums[3]:.1f} | |")
    print(f"\n{missing} sample figures without their scan", file=sys.stderr)


if __name__ == "__main__":
    main()
