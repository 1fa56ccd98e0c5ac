# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# The experiments of the paper, as a plan of measurements.

import json
from functools import cached_property
from pathlib import Path
from types import SimpleNamespace

from clicks import Clicks
from heatmap import HeatMap
from labels import Labels
from noise import Noise
from peers import Peers
from plan import Plan, Wanted
from purity import Purity
from raw import Raw
from seeds import SeedSweep
from tables import Tables

EXPERIMENTS = {each.name: each for each in (Tables(), SeedSweep(), Purity(), Noise(), HeatMap(),
                                            Labels(), Peers(), Raw(), Clicks())}


class ExperimentsPlan(Plan):
    """Targets are names of experiments."""

    def __init__(self, config, out=None):
        super().__init__(config, out)
        self.options = SimpleNamespace(starts=config["starts"], seeds=config["seeds"],
                                       methods=config["methods"])

    def items(self, name):
        return [item for scan in self.scans
                for item in EXPERIMENTS[name].items(scan, self.options)]

    @cached_property
    def item_of_result(self):
        """Experiments share some."""
        return {item.result(): item for name in self.targets for item in self.items(name)}

    def item(self, wildcards, kind):
        return self.item_of_result[f"results/{wildcards.scan}/{kind}-{wildcards.settings}.json"]

    def wanted(self, target):
        return [Wanted(item.scan.name, item.result(), (self.step(item.result(), item.log()),))
                for item in self.items(target)]

    def done(self, target):
        """(item, what is stored of it) pairs of the scans that a summary is made of."""
        left_out = self.left_out(target)
        return [(item, read_result(item.result())) for item in self.items(target)
                if item.scan.name not in left_out]

    def files(self, target):
        return [f"{target}{end}" for end in (".csv", "_scans.csv", ".md", "_remarks.txt")] + list(
            getattr(EXPERIMENTS[target], "more_files", ()))


def read_result(path):
    try:
        stored = json.loads(Path(path).read_text(encoding="utf-8"))
        return {"result": dict(stored["result"]), "remarks": list(stored["remarks"])}
    except (ValueError, LookupError, TypeError):
        raise ValueError(f"{Path(path).resolve()}: is broken; remove it, and run the same "
                         "command again") from None
