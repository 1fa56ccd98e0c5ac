# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# Summarize an experiment from the results of its scans: its tables and pictures, and what was
# remarked on the scans. A rule of experiments.smk starts this in the folder of the results.

import sys
from pathlib import Path

from experiments_plan import EXPERIMENTS, ExperimentsPlan
from plan import configuration
from report import write_whole


def tell_remarks(name, remarks):
    """Write, each once, what was repaired, left out or assumed when the scans were read."""
    remarks = list(dict.fromkeys(remarks))
    path = Path(f"{name}_remarks.txt")
    write_whole(path, "".join(remark + "\n" for remark in remarks).encode())
    if remarks:
        print(f"{len(remarks)} remarks on the scans (what was repaired, left out or assumed), "
              f"with file and line: {path.resolve()}")


def tell_left_out(path, scans):
    """At the top of a page."""
    listed = "".join(f"* {scan}\n" for scan in scans)
    text = f"{len(scans)} scans failed and are not in these tables:\n\n{listed}\n"
    write_whole(path, text.encode() + path.read_bytes())


def main(config, name, partial):
    plan = ExperimentsPlan(configuration(config, partial))
    try:
        done = plan.done(name)
    except ValueError as error:
        sys.exit(str(error))
    EXPERIMENTS[name].summarize([(item, stored["result"]) for item, stored in done],
                                plan.options, Path())
    page = Path(f"{name}.md")
    left_out = plan.left_out(name)
    if left_out:
        tell_left_out(page, left_out)
    tell_remarks(name, [remark for _, stored in done for remark in stored["remarks"]])
    print(page.read_text(encoding="utf-8"), flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
