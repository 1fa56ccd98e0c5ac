# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# The rows that a tool wrote for each scan, as one table. A rule of batch.smk starts this in the
# folder of the results.

import csv
import sys
from pathlib import Path

from batch_plan import BatchPlan
from plan import configuration
from report import write_csv

# The table of pcl_cid_evaluate has rows of classes, too.
KIND = "kind"


def rows_of_scans(path, name):
    with open(path, newline="", encoding="utf-8") as file:
        rows = [row for row in csv.DictReader(file) if row.pop(KIND, "scan") == "scan"]
    return [row | {"name": name} for row in rows]


def main(config, tool, partial):
    plan = BatchPlan(configuration(config, partial))
    left_out = plan.left_out(tool)
    write_csv(Path(f"{tool}.csv"), [row for each in plan.wanted(tool) if each.scan not in left_out
                                    for row in rows_of_scans(each.result, each.scan)])
    print(f"{len(plan.scans) - len(left_out)} of {len(plan.scans)} scans: "
          f"{Path(tool).resolve()}.csv")


if __name__ == "__main__":
    main(*sys.argv[1:])
