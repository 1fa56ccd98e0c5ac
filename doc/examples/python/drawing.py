# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# What the examples draw with: points seen from above, without those near the ceiling.

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

HIGHEST = 2.2  # metres above the floor


def palette(count):
    """Colors that differ from their neighbors: steps of the golden angle."""
    hue = (np.arange(count) * 0.61803398875) % 1.0
    return plt.get_cmap("hsv")(hue)[:, :3] * 0.85


def draw_from_above(axes, points, colors, **options):
    """Later points lie on earlier ones, so the lowest come first."""
    order = np.argsort(points[:, 2])
    order = order[points[order, 2] < np.nanmin(points[:, 2]) + HIGHEST]
    drawn = axes.scatter(points[order, 0], points[order, 1], c=colors[order], s=1, lw=0,
                         rasterized=True, **options)
    axes.set_aspect("equal")
    axes.set_axis_off()
    return drawn


def save(figure, path):
    figure.savefig(path, dpi=110, bbox_inches="tight")
    plt.close(figure)
    print(path)
