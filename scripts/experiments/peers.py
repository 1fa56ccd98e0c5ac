# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# Other methods of segmentation beside CID, each with all of its settings; see doc/peers.md.

from programs import perturbed, read_json
from peers_summary import Comparison, picture, sections
from report import write_csv, write_markdown
from work import Item

SEEDED = ("cid", "cid20k", "euclidean")
METHODS = (*SEEDED, "lccp", "wcseg", "region_growing")
# Groups of the merge tree that CID is cut from, in multiples of the number of seeds.
TREES = (1,)
# What cid_peers calls the settings of an item.
OPTIONS = {"method": "--methods", "seeds": "--seeds", "tree": "--tree-seeds",
           "start": "--random-seed"}


def compare(item, programs, folder, *arguments):
    """What cid_peers reports on the scan, in PCD as all of the methods get it."""
    copy = perturbed(item.scan, {"start": 0}, programs, folder)
    report = folder / "peers.json"
    settings = [text for name, option in OPTIONS.items() if name in item.settings
                for text in (option, item.settings[name])]
    programs.run("cid_peers", copy, *settings, *arguments, "--report", report)
    return read_json(report)


def run_method(item, programs, folder):
    """All runs of a method; with one thread, as the methods that have no more."""
    report = compare(item, programs, folder, "--compare", "none",
                     *item.scan.viewpoint_options())
    return {"instances": report["instances"], "comparable": report["comparable_parts"],
            "runs": report["runs"]}


def cid_curve(item, programs, folder):
    """The purity of CID by number of parts."""
    report = compare(item, programs, folder, "--methods", "none", "--compare", "curve",
                     "--threads", programs.threads)
    return {"curve": [[each["parts"], each["purity"]] for each in report["cid_curve"]]}


class Peers:
    """Purity at a peer's own number of parts, AP of methods with seeds, time, memory."""

    name = "peers"
    more_files = ("peers_runs.csv", "peers.png")

    def items(self, scan, options):
        starts = range(options.starts)
        curves = [Item(scan, "curve", {"tree": times * options.seeds, "start": start})
                  for times in TREES for start in starts]
        return [*curves, *(self.item(scan, method, options, start)
                           for method in options.methods
                           for start in (starts if method in SEEDED else [None]))]

    @staticmethod
    def item(scan, method, options, start):
        settings = {"method": method}
        if method in SEEDED:
            settings |= {"seeds": options.seeds, "start": start}
        return Item(scan, "peers", settings)

    def summarize(self, done, options, folder):
        comparison = Comparison(done, options.seeds)
        write_csv(folder / "peers_runs.csv", comparison.run_rows())
        write_csv(folder / "peers_scans.csv", comparison.scan_rows())
        write_csv(folder / "peers.csv", comparison.summary_rows())
        write_markdown(folder / "peers.md", sections(comparison, options))
        picture(comparison, folder / "peers.png")
