# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# The figures of the paper: R. Wang, Y. Xue, B. Surianarayanan, D. Tian, C. Feng,
# "Concavity-Induced Distance for Unoriented Point Cloud Decomposition", IEEE Robotics and
# Automation Letters, 2023, arXiv:2306.11051. Tables I and II, section V.B.

# The setting of all its experiments (section V.A).
SUBSAMPLE = 20000

# Options for raw scans that the programs have beyond the paper, as the paper is.
RAW_SCANS = {"density": "off", "isolated-neighbors": 0, "seeding": "farthest", "color": 0,
             "normals": 0, "connected": "off", "blind-spot": "off"}
# Those of them whose defaults are not the paper's.
NOT_BY_DEFAULT = ("density", "isolated-neighbors", "normals", "connected", "blind-spot")
# The same where the programs write labels.
LABELS = RAW_SCANS | {"clean-up": "off"}

# By class: AP25, AP50, AP75 of CID; AP50 of SGPN and of PointGroup, None where it has none.
S3DIS = {
    "ceiling": (0.956, 0.867, 0.639, 0.794, 0.724),
    "floor": (0.995, 0.971, 0.780, 0.663, 0.966),
    "wall": (0.903, 0.645, 0.300, 0.888, 0.454),
    "beam": (0.979, 0.861, 0.539, 0.780, 0.627),
    "column": (0.955, 0.702, 0.147, 0.607, 0.393),
    "window": (0.963, 0.814, 0.248, 0.666, 0.808),
    "door": (0.768, 0.525, 0.176, 0.568, 0.593),
    "chair": (0.877, 0.722, 0.402, 0.408, 0.887),
    "table": (0.917, 0.654, 0.234, 0.470, 0.567),
    "bookcase": (0.926, 0.697, 0.260, 0.476, 0.431),
    "board": (0.833, 0.136, 0.024, 0.111, 0.785),
    "sofa": (0.958, 0.708, 0.361, 0.064, 0.565),
    "stairs": (0.883, 0.845, 0.568, None, None),
    "clutter": (0.842, 0.524, 0.180, None, 0.522),
    "mean": (0.911, 0.691, 0.347, 0.541, 0.640),
}

SCANNET = {
    "cabinet": (0.911, 0.667, 0.257, 0.065, 0.505),
    "bed": (0.989, 0.777, 0.275, 0.390, 0.765),
    "chair": (0.942, 0.742, 0.390, 0.275, 0.797),
    "sofa": (1.000, 0.000, 0.000, 0.351, 0.756),
    "table": (0.941, 0.674, 0.276, 0.168, 0.556),
    "door": (0.890, 0.600, 0.245, 0.087, 0.441),
    "window": (0.896, 0.552, 0.157, 0.138, 0.513),
    "bookshelf": (0.911, 0.623, 0.191, 0.169, 0.624),
    "picture": (0.568, 0.082, 0.011, 0.014, 0.476),
    "counter": (0.701, 0.206, 0.031, 0.029, 0.116),
    "desk": (0.835, 0.381, 0.071, 0.000, 0.384),
    "curtain": (0.952, 0.729, 0.322, 0.069, 0.696),
    "refrigerator": (0.945, 0.779, 0.310, 0.027, 0.596),
    "shower curtain": (0.993, 0.913, 0.710, 0.000, 1.000),
    "toilet": (0.992, 0.945, 0.644, 0.438, 0.997),
    "sink": (0.837, 0.376, 0.095, 0.112, 0.666),
    "bathtub": (0.986, 0.894, 0.298, 0.208, 1.000),
    "otherfurniture": (0.868, 0.559, 0.212, 0.043, 0.559),
    "mean": (0.898, 0.583, 0.250, 0.143, 0.636),
}

# By what pcl_cid_evaluate calls the set of classes.
TABLES = {"s3dis": ("Table I, S3DIS", S3DIS), "scannet": ("Table II, ScanNet", SCANNET)}

# Median purity on S3DIS at the compactness that WCSeg has (van Kaick et al. 2014).
MEDIAN_PURITY = {"CID": 0.76, "WCSeg": 0.58}


def of_class(classes_from, name):
    """The figures of a class; None where the paper has none."""
    return TABLES.get(classes_from, ("", {}))[1].get(name, (None,) * 5)
