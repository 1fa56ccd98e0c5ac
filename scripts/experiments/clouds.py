# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# Points and fields of a PCD file as the tools write them.

import numpy as np


def read_header(file):
    """The entries of a header, each a list of words, and where the data begins."""
    header = {}
    while "DATA" not in header:
        line = file.readline()
        if not line:
            raise ValueError(f"{file.name}: its header has no end")
        words = line.decode("ascii").split()
        if words and words[0] != "#":
            header[words[0]] = words[1:]
    return header


def type_of_point(header):
    """The numpy type of a point; fields with several values are arrays."""
    letters = {"F": "f", "I": "i", "U": "u"}
    fields = zip(header["FIELDS"], header["TYPE"], header["SIZE"], header["COUNT"])
    return np.dtype([(name, f"<{letters[kind]}{size}", (int(count),)) if count != "1" else
                     (name, f"<{letters[kind]}{size}") for name, kind, size, count in fields])


def decompress(data, size):
    """LZF, the compression of PCD: runs of literal bytes, and copies of what came before."""
    out = bytearray()
    at = 0
    while len(out) < size:
        control = data[at]
        at += 1
        if control < 32:
            out += data[at:at + control + 1]
            at += control + 1
            continue
        length = control >> 5
        if length == 7:
            length += data[at]
            at += 1
        distance = ((control & 31) << 8) + data[at] + 1
        at += 1
        begin = len(out) - distance
        for i in range(begin, begin + length + 2):
            out.append(out[i])
    return bytes(out)


def from_columns(data, kind, points):
    """Compressed files have one field after the other."""
    cloud = np.empty(points, kind)
    at = 0
    for name in kind.names:
        column = np.frombuffer(data, kind[name], points, at)
        cloud[name] = column
        at += column.nbytes
    return cloud


def read_cloud(path):
    """A structured array with a row for each point."""
    with open(path, "rb") as file:
        header = read_header(file)
        points = int(header["POINTS"][0])
        kind = type_of_point(header)
        if header["DATA"] == ["ascii"]:
            return np.loadtxt(file, dtype=kind, ndmin=1)
        if header["DATA"] == ["binary"]:
            return np.fromfile(file, kind, points)
        compressed, size = np.fromfile(file, "<u4", 2)
        return from_columns(decompress(file.read(int(compressed)), int(size)), kind, points)


def positions(cloud):
    """Coordinates, a row for each point."""
    return np.stack([cloud[axis] for axis in "xyz"], axis=1).astype(float)


def finite(cloud):
    """Which points are finite, as a mask."""
    return np.isfinite(positions(cloud)).all(axis=1)


def labelled(cloud):
    """Which finite points have a true label; some must."""
    if "label" not in cloud.dtype.names:
        raise ValueError("has no field 'label', the true instances")
    mask = finite(cloud) & (cloud["label"] != 0)
    if not mask.any():
        raise ValueError("none of its finite points has a label other than 0")
    return mask
