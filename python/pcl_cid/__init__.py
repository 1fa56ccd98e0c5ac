# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors

"""Convex parts, seeds and instance labels of a raw scan, by Concavity-Induced Distance.

>>> import pcl_cid
>>> scan = pcl_cid.Scan(pcl_cid.read("room.pcd"))
>>> scan.propose(100)
>>> labels = scan.labels()

The method is that of R. Wang, Y. Xue, B. Surianarayanan, D. Tian, C. Feng:
"Concavity-Induced Distance for Unoriented Point Cloud Decomposition", IEEE Robotics and
Automation Letters, 2023. Lengths are in metres, or the unit of the points.
"""

from ._pcl_cid import (
    CIDCancelled,
    CIDError,
    Cloud,
    ConvexPart,
    MergeTree,
    Scan,
    __version__,
    evaluate,
    group_cid,
    point_cid,
    read,
    save,
    settings,
    write,
)

__all__ = [
    "CIDCancelled",
    "CIDError",
    "Cloud",
    "ConvexPart",
    "MergeTree",
    "Scan",
    "evaluate",
    "group_cid",
    "point_cid",
    "read",
    "save",
    "settings",
    "write",
]

# Their names in messages are those by which users know them.
for _name in __all__:
    globals()[_name].__module__ = __name__
del _name
