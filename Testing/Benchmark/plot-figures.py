#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""plot-figures.py FOLDER: draw figures 8.10 and 8.11 of the thesis from the tables in the folder.

Both show seconds per evaluation of the winding number at random points in the surface's box, by the number of facets:
8.10 for one surface under subdivision, 8.11 over a set of surfaces. BenchmarkWindingNumber --figures writes the tables. Naive and
hierarchical are the thesis's methods; the expansion of Barill et al. (2018), approximate, and ours, exact, are of today. The slope
of each is that of log seconds over log facets, by least squares: 1 is as the number of facets, 0 does not grow.
"""

import csv
import sys
from pathlib import Path

import matplotlib
import numpy as np

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402  the backend has to be chosen first

METHODS = {"naive": "tab:gray", "hierarchical": "tab:blue", "approximate": "tab:green", "exact": "tab:red"}


def read_table(path):
    with path.open() as table:
        return sorted(csv.DictReader(table), key=lambda row: int(row["facets"]))


def fitted(facets, seconds):
    """The slope in the logarithms, and the seconds that it gives."""
    slope, least = np.polyfit(np.log(facets), np.log(seconds), 1)
    return slope, np.exp(least) * np.asarray(facets, float) ** slope


def draw(folder, name, title, line):
    rows = read_table(folder / f"{name}.csv")
    figure, axes = pyplot.subplots(figsize=(6, 5), constrained_layout=True)
    for method, color in METHODS.items():
        for closed, filled in (("1", color), ("0", "none")):
            chosen = [row for row in rows if row["closed"] == closed]
            if not chosen:
                continue
            facets, seconds = ([float(row[column]) for row in chosen] for column in ("facets", method))
            label = method if closed == "1" else f"{method}, open"
            if len(set(facets)) > 2:
                slope, line_of_slope = fitted(facets, seconds)
                label = f"{label}: slope {round(slope, 2) + 0.0:.2f}"  # -0 is 0
                axes.loglog(facets, line_of_slope, linestyle="-" if closed == "1" else ":", color=color, linewidth=0.8)
                print(f"{name}: {label}")
            axes.loglog(facets, seconds, linestyle=line, marker="o", markersize=5, color=color, markerfacecolor=filled, label=label)
    axes.set_xlabel("facets")
    axes.set_ylabel("seconds per evaluation")
    axes.set_title(title)
    axes.grid(True, which="major", alpha=0.3)
    # Below, for the points of figure 8.11 leave no room: a column for each method.
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.13), fontsize="small", ncol=2)
    figure.savefig(folder / f"{name}.png", dpi=150)


if __name__ == "__main__":
    folder = Path(sys.argv[1])
    draw(folder, "figure-8.10", "One surface, subdivided", "-")
    draw(folder, "figure-8.11", "A set of surfaces", "none")
    print(f"drawn: {folder}/figure-8.10.png {folder}/figure-8.11.png")
