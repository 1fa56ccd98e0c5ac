# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# The scans that record_outputs.py runs the tools on.

import json
import random
import re
import struct
import sys
from dataclasses import dataclass
from pathlib import Path

PROJECT = Path(__file__).resolve().parent.parent

# Scans


@dataclass(frozen=True)
class Scan:
    """What the tools run on."""

    name: str  # in the record
    path: Path  # a file, or a folder of S3DIS or ScanNet
    link: str  # what it is called where the tools run
    fields: frozenset
    is_small: bool = False

    @property
    def has_label(self):
        return "label" in self.fields

    @property
    def has_semantic(self):
        return "semantic" in self.fields

    @property
    def has_color(self):
        return bool(self.fields & {"rgb", "rgba", "red"})

    @property
    def is_quick(self):
        return self.is_small or self.name == "room.pcd"

    @property
    def is_scannet(self):
        return any(self.path.glob("*_vh_clean_2.ply"))

    @property
    def class_table(self):
        """The option that says where it is, for a scan that needs one."""
        return f"--class-table {self.link}/{CLASS_TABLE}" if self.is_scannet else ""


def fields_of(path):
    """The names that the header of a PCD or PLY file gives."""
    header = path.read_bytes()[:4096].decode("latin-1")
    if path.suffix == ".ply":
        return frozenset(re.findall(r"^property \w+ (\w+)$", header, re.MULTILINE))
    names = re.search(r"^FIELDS (.*)$", header, re.MULTILINE)
    return frozenset(names.group(1).split() if names else [])


def scan_file(path, is_small=False):
    return Scan(path.name, path, "scan" + path.suffix, fields_of(path), is_small)


def scan_folder(path):
    """A small one of S3DIS or ScanNet; its name is part of its format."""
    return Scan(path.name, path, path.name, frozenset({"rgb", "label", "semantic"}), True)


def scans_to_run(given_folder, small_folder, name_part):
    """All scans whose name contains a text, those with the most work first."""
    files = [PROJECT / "data" / "room.pcd"]
    if given_folder.is_dir():
        files += sorted(given_folder.glob("*.pcd"))
    else:
        print(f"There is no folder {given_folder}: the scans in it are left out.", file=sys.stderr)
    scans = [scan_file(path) for path in files]
    scans.sort(key=lambda scan: scan.path.stat().st_size, reverse=True)
    scans += small_scans(small_folder)
    return [scan for scan in scans if name_part in scan.name]


# Small scans


# What PCD, PLY and Python's struct call a type.
PCD_TYPES = {"f": ("F", 4), "d": ("F", 8), "I": ("U", 4)}
PLY_TYPES = {"f": "float", "d": "double", "I": "uint", "B": "uchar"}

XYZ = {"x": "f", "y": "f", "z": "f"}
XYZ_DOUBLE = {"x": "d", "y": "d", "z": "d"}
LABELS = {"label": "I", "semantic": "I"}
COLORS = {"red": "B", "green": "B", "blue": "B"}

# Classes of S3DIS and labels of ScanNet for the things in the furnished corner.
FLOOR, WALL, TABLE = (1, 2), (2, 3), (3, 8)
S3DIS_NAMES = {1: "floor_1", 2: "wall_1", 3: "table_1"}
SCANNET_NAMES = {1: "floor", 2: "wall", 3: "coffee table"}
CLASS_TABLE = "scannetv2-labels.combined.tsv"
SCANNET_CLASSES = "raw_category\tnyu40id\nwall\t1\nfloor\t2\ncoffee table\t7\n"


def furnished_corner():
    """Floor, wall and table of a room: points with x, y, z, label and semantic."""
    draw = random.Random(1)

    def grid(columns, rows, place, thing):
        def noisy(value):
            return round(value + draw.uniform(-0.01, 0.01), 4)

        return [
            (*map(noisy, place(0.1 * i, 0.1 * j)), *thing)
            for i in range(columns)
            for j in range(rows)
        ]

    return (
        grid(20, 18, lambda a, b: (a, b, 0.0), FLOOR)
        + grid(18, 12, lambda a, b: (0.0, a, b), WALL)
        + grid(9, 7, lambda a, b: (1.0 + a, 0.9 + b, 0.7), TABLE)
        + grid(9, 7, lambda a, b: (1.0 + a, 0.9, b), TABLE)
    )


def hollow_floor():
    """What a scanner sees of a floor that goes on under it: nothing near its own foot."""
    places = [(0.15 * i, 0.15 * j) for i in range(-20, 21) for j in range(-20, 21)]
    return [(x, y, 0.0) for x, y in places if x * x + y * y > 1.5]


def colors_of(label):
    return (40 * label, 80 * label, 255 - 60 * label)


def packed(byte_order, fields, rows):
    row_format = struct.Struct(byte_order + "".join(fields.values()))
    return b"".join(row_format.pack(*row) for row in rows)


def text_lines(rows):
    return "".join(" ".join(map(str, row)) + "\n" for row in rows).encode()


def write_pcd(path, fields, rows, data="ascii", height=1, viewpoint="0 0 0 1 0 0 0"):
    types = [PCD_TYPES[letter] for letter in fields.values()]
    header = f"""VERSION 0.7
FIELDS {" ".join(fields)}
SIZE {" ".join(str(size) for _, size in types)}
TYPE {" ".join(letter for letter, _ in types)}
COUNT {" ".join("1" for _ in types)}
WIDTH {len(rows) // height}
HEIGHT {height}
VIEWPOINT {viewpoint}
POINTS {len(rows)}
DATA {data}
"""
    body = text_lines(rows) if data == "ascii" else packed("<", fields, rows)
    path.write_bytes(header.encode() + body)


def write_ply(path, fields, rows, data="ascii"):
    properties = "".join(f"property {PLY_TYPES[t]} {name}\n" for name, t in fields.items())
    header = f"ply\nformat {data} 1.0\nelement vertex {len(rows)}\n{properties}end_header\n"
    orders = {"binary_little_endian": "<", "binary_big_endian": ">"}
    body = text_lines(rows) if data == "ascii" else packed(orders[data], fields, rows)
    path.write_bytes(header.encode() + body)


def write_degenerate_scans(folder):
    nan = float("nan")
    corner = [row[:3] for row in furnished_corner()]
    grid = [(0.05 * i, 0.05 * j, 1.0) for i in range(30) for j in range(30)]
    holed = [(nan, nan, nan) if i % 3 == 0 else row for i, row in enumerate(grid)]
    write_pcd(folder / "one_point.pcd", XYZ, [(1, 2, 3)])
    write_pcd(folder / "three_points.pcd", XYZ, [(0, 0, 0), (1, 0, 0), (0, 1, 0)])
    write_pcd(folder / "equal_points.pcd", XYZ, [(1, 2, 3)] * 50)
    write_pcd(folder / "points_on_a_line.pcd", XYZ, [(0.1 * i, 0, 0) for i in range(60)])
    write_pcd(folder / "flat_grid.pcd", XYZ, grid, "binary")
    write_pcd(folder / "nan_among_points.pcd", XYZ, holed, height=30)
    write_pcd(folder / "no_finite_point.pcd", XYZ, [(nan, nan, nan)] * 9)
    write_pcd(folder / "no_point.pcd", XYZ, [])
    write_pcd(folder / "far_from_origin.pcd", XYZ_DOUBLE,
              [(x + 524288.25, y + 4194304.5, z + 102.125) for x, y, z in corner], "binary")
    write_pcd(folder / "blind_spot.pcd", XYZ, hollow_floor(), viewpoint="0 0 1.5 1 0 0 0")
    whole = (folder / "flat_grid.pcd").read_bytes()
    (folder / "cut_off.pcd").write_bytes(whole[: len(whole) // 2])


def write_scans_of_each_format(folder):
    corner = furnished_corner()
    colored = [row[:3] + colors_of(row[3]) + row[3:] for row in corner]
    write_pcd(folder / "text.pcd", XYZ | LABELS, corner)
    write_ply(folder / "text.ply", XYZ | COLORS | LABELS, colored)
    write_ply(folder / "little_endian.ply", XYZ | COLORS | LABELS, colored,
              "binary_little_endian")
    write_ply(folder / "big_endian.ply", XYZ_DOUBLE, [row[:3] for row in corner],
              "binary_big_endian")


def write_s3dis_room(folder):
    (folder / "Annotations").mkdir(parents=True)
    corner = furnished_corner()
    for label, name in S3DIS_NAMES.items():
        rows = [row[:3] + colors_of(label) for row in corner if row[3] == label]
        (folder / "Annotations" / f"{name}.txt").write_bytes(text_lines(rows))
    everything = [row[:3] + colors_of(row[3]) for row in corner]
    (folder / f"{folder.name}.txt").write_bytes(text_lines(everything))


def write_scannet_scan(folder):
    folder.mkdir()
    corner = furnished_corner()
    colored = [row[:3] + colors_of(row[3]) for row in corner]
    segments = {"segIndices": [10 * row[3] for row in corner]}
    groups = [{"objectId": label - 1, "label": name, "segments": [10 * label]}
              for label, name in SCANNET_NAMES.items()]
    beginning = str(folder / folder.name)
    write_ply(Path(beginning + "_vh_clean_2.ply"), XYZ | COLORS, colored,
              "binary_little_endian")
    Path(beginning + "_vh_clean_2.0.010000.segs.json").write_text(json.dumps(segments))
    Path(beginning + ".aggregation.json").write_text(json.dumps({"segGroups": groups}))
    (folder / CLASS_TABLE).write_text(SCANNET_CLASSES)


def small_scans(folder):
    write_degenerate_scans(folder)
    write_scans_of_each_format(folder)
    files = [scan_file(path, is_small=True) for path in sorted(folder.iterdir())]
    room, scene = folder / "room_1", folder / "scene0000_00"
    write_s3dis_room(room)
    write_scannet_scan(scene)
    return files + [scan_folder(room), scan_folder(scene)]
