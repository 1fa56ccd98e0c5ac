# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# A tool on every scan of a folder, as a plan.

from collections import Counter
from functools import cached_property
from pathlib import PurePosixPath

from plan import Plan, Wanted

TOOLS = ("segment", "abstract", "evaluate")
# What a tool reads that another one has made.
NEEDS = {"segment": (), "abstract": (), "evaluate": ("segment",)}
MESH_FORMATS = ("obj", "ply", "stl")


def output_name(scan):
    """What the tools call its outputs, in its place in the dataset."""
    place = PurePosixPath(scan.name)
    if scan.is_scannet:
        file = next(scan.path.glob("*_vh_clean_2.ply"))
        return str(place.with_name(file.name.removesuffix("_vh_clean_2.ply")))
    return str(place if scan.path.is_dir() else place.with_suffix(""))


class BatchPlan(Plan):
    """Targets are tools; options of each are in the configuration, as words."""

    @cached_property
    def scan_of_name(self):
        return {output_name(scan): scan for scan in self.scans}

    def same_names(self):
        """What is wrong with names that several scans would have; None if there are none."""
        counts = Counter(map(output_name, self.scans))
        name, count = counts.most_common(1)[0]
        return (f"{self.config['dataset']}: {count} scans would have outputs of the name {name}; "
                "names of files without their extension must differ") if count > 1 else None

    def scan(self, wildcards):
        return self.scan_of_name[wildcards.scan]

    def options(self, tool):
        return self.config["options"].get(tool, [])

    def scan_options(self, tool, scan):
        """Those of the configuration, and what the scan itself says."""
        options = self.options(tool)
        if tool == "evaluate" and "--classes" not in options:
            return [*options, *scan.class_options()]
        return options

    def mesh_format(self):
        """Outputs of pcl_cid_abstract end so."""
        words = self.options("abstract")
        at = words.index("--mesh-format") + 1 if "--mesh-format" in words else len(words)
        return words[at] if at < len(words) else MESH_FORMATS[0]

    def wanted(self, target):
        return [Wanted(name, f"{target}/{name}.csv",
                       tuple(self.step(f"{tool}/{name}.csv", f"logs/{tool}/{name}.log")
                             for tool in (*NEEDS[target], target)))
                for name in self.scan_of_name]

    def files(self, target):
        return [f"{target}.csv"]
