# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# What is measured on a scan, and where its result is.

from dataclasses import dataclass, field

from scans import Scan

# What a measurement that draws leaves in its folder.
PICTURE = "picture.png"


@dataclass(frozen=True)
class Item:
    """A measurement of a scan; the same settings give the same result."""

    scan: Scan
    kind: str
    settings: dict = field(hash=False)

    def name(self):
        values = [f"{key}{value}" for key, value in self.settings.items()]
        return "-".join([self.kind, *values])

    def id(self):
        return f"{self.scan.name}/{self.name()}"

    def result(self):
        """Below the folder of the results."""
        return f"results/{self.id()}.json"

    def log(self):
        return f"logs/{self.id()}.log"
