# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# The scans of a dataset: room folders of S3DIS, scan folders of ScanNet, PCD and PLY files.

import hashlib
import os
import re
from dataclasses import dataclass
from pathlib import Path

CLASS_TABLE = "scannetv2-labels.combined.tsv"


@dataclass(frozen=True)
class Scan:
    """A scan, named by its place in the dataset."""

    name: str
    path: Path
    is_scannet: bool = False

    def class_options(self):
        """What pcl_cid_evaluate has to know about its classes."""
        return ["--classes", "scannet"] if self.is_scannet else []

    def viewpoint_options(self):
        """What cid_peers has to know about its sensors: a file beside a generated scan."""
        return [option for file in truth_file(self.path) for option in ("--viewpoints", file)]

    def existing(self):
        """Its path, if it is still there: a link may have lost its file."""
        return [path for path in [str(self.path)] if os.path.exists(path)]

    def fingerprint(self):
        """Of names, sizes and times of its files: another one is another scan. Of the table
        of classes of ScanNet, too, which may be above the folder, and of the truth beside a
        generated scan."""
        files = [Path(path) for path in self.existing()]
        if self.path.is_dir():
            files = sorted(file for file in self.path.rglob("*") if file.is_file())
        table = [] if not self.is_scannet else class_table(self.path)
        seen = hashlib.sha256()
        for file in (*files, *table, *truth_file(self.path)):
            stat = file.stat()
            place = os.path.relpath(file, self.path)
            seen.update(os.fsencode(f"{place}\0{stat.st_size}\0{stat.st_mtime_ns}\0"))
        return seen.hexdigest()[:16]


def class_table(folder):
    """The nearest one in the folder or above it, as the programs find it; a list of one or none."""
    place = Path(os.path.abspath(folder))
    tables = [each / CLASS_TABLE for each in (place, *place.parents)]
    return [table for table in tables if table.exists()][:1]


def truth_file(path):
    """What is known of a generated scan beyond its fields; a list of one or none."""
    file = path.with_name(path.stem + "_truth.json")
    return [file] if file.exists() else []


def natural(text):
    """office_2 before office_10."""
    return [(int(part), "") if part.isdigit() else (-1, part)
            for part in re.split(r"(\d+)", text)]


def scan_at(path, name):
    """The scan that a path is, or None."""
    if path.is_dir():
        if any(path.glob("*_vh_clean_2.ply")):
            return Scan(name, path, is_scannet=True)
        return Scan(name, path) if (path / "Annotations").is_dir() else None
    return Scan(name, path) if path.suffix.lower() in (".pcd", ".ply") else None


def find_scans(dataset, passed_over):
    """All scans in a folder and those in it, in natural order, but not in `passed_over`."""
    found = []
    folders = [dataset]
    while folders:
        for path in folders.pop().iterdir():
            if path.name.startswith(".") or path.resolve() == passed_over.resolve():
                continue
            scan = scan_at(path, path.relative_to(dataset).as_posix())
            if scan:
                found.append(scan)
            elif path.is_dir():
                folders.append(path)
    return sorted(found, key=lambda scan: natural(scan.name))


def scans_of(dataset, passed_over):
    """Those of a dataset's folder, which may also be a single scan."""
    single = scan_at(dataset, os.path.basename(os.path.abspath(dataset)))
    return [single] if single else find_scans(dataset, passed_over)


def spread(scans, count):
    """So many of them, evenly over the whole list."""
    if not count or count >= len(scans):
        return scans
    return [scans[i * len(scans) // count] for i in range(count)]
