#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""plot-figures.py FOLDER: draw figures 8.10 and 8.11 of the thesis from the tables in the folder.

Both show seconds per evaluation of the winding number at random points in the surface's box, by the number of facets:
8.10 for one surface under subdivision, 8.11 over a set of surfaces. BenchmarkWindingNumber --figures writes the tables.
"""

import csv
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402  the backend has to be chosen first

METHODS = {"naive": "tab:gray", "hierarchical": "tab:blue", "exact": "tab:red"}


def read_table(path):
    with path.open() as table:
        return sorted(csv.DictReader(table), key=lambda row: int(row["facets"]))


def draw(folder, name, title, line):
    rows = read_table(folder / f"{name}.csv")
    figure, axes = pyplot.subplots(figsize=(6, 5), constrained_layout=True)
    for method, color in METHODS.items():
        for closed, filled in (("1", color), ("0", "none")):
            chosen = [row for row in rows if row["closed"] == closed]
            if chosen:
                axes.loglog([int(row["facets"]) for row in chosen], [float(row[method]) for row in chosen],
                            linestyle=line, marker="o", markersize=5, color=color, markerfacecolor=filled,
                            label=method + ("" if closed == "1" else ", open"))
    axes.set_xlabel("facets")
    axes.set_ylabel("seconds per evaluation")
    axes.set_title(title)
    axes.grid(True, which="major", alpha=0.3)
    # Below, for the points of figure 8.11 leave no room: a column for each method.
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.13), fontsize="small", ncol=len(METHODS))
    figure.savefig(folder / f"{name}.png", dpi=150)


if __name__ == "__main__":
    folder = Path(sys.argv[1])
    draw(folder, "figure-8.10", "One surface, subdivided", "-")
    draw(folder, "figure-8.11", "A set of surfaces", "none")
    print(f"drawn: {folder}/figure-8.10.png {folder}/figure-8.11.png")
