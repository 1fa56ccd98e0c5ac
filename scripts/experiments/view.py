# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# A look into a room from above, at a corner.

import numpy as np

from clouds import finite, positions

SHOWN_POINTS = 30000
# Shares of the extent in x, y and z.
CUT_OFF = (0.05, 0.05, 0.15)


def direction_to_viewer(azimuth):
    """In the ground plane."""
    return np.array([np.cos(np.radians(azimuth)), np.sin(np.radians(azimuth))])


def best_azimuth(places, indices):
    """From where, of four corners, these points are farthest off: at the open side nothing
    hides them."""
    middle = (np.nanmin(places, axis=0) + np.nanmax(places, axis=0))[:2] / 2
    offset = sum(places[index][:2] - middle for index in indices)
    return min((-60, 30, 120, 210), key=lambda azimuth: offset @ direction_to_viewer(azimuth))


def visible(places, azimuth):
    """Some of the points, without what would hide the room: the walls next to the viewer,
    and its top."""
    toward = np.append(direction_to_viewer(azimuth), 1.0)
    # A few stray points behind walls and windows do not count.
    low, high = np.nanpercentile(places, (1, 99), axis=0)
    margin = np.where(toward > 0, high - places, places - low) / (high - low)
    indices = np.flatnonzero((margin > CUT_OFF).all(axis=1))
    return indices[::max(1, len(indices) // SHOWN_POINTS)]


class View:
    """What is seen of a cloud, with these points at the far side."""

    def __init__(self, cloud, indices):
        self.places = np.where(finite(cloud)[:, None], positions(cloud), np.nan)
        self.azimuth = best_azimuth(self.places, indices)
        self.shown = visible(self.places, self.azimuth)

    def scatter(self, panel, title, **colors):
        """The points in a 3D panel, in colors for those that are shown."""
        panel.computed_zorder = False
        panel.set_box_aspect(np.ptp(self.places[self.shown], axis=0), zoom=1.5)
        panel.view_init(elev=45, azim=self.azimuth)
        panel.set_axis_off()
        panel.set_title(title, fontsize="medium")
        return panel.scatter(*self.places[self.shown].T, s=2, linewidth=0, depthshade=False,
                             **colors)
