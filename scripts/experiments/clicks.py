# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# What clicks are worth, by a simulated annotator: the paper, each change to it alone, and all
# together, with proposed and with corrective clicks, and by the rules of AGILE3D.

import time
from collections import defaultdict

import paper
from programs import DEFAULT, options_beyond, read_json
from raw import has_color, place_of
from report import new_figure, save_picture, write_csv, write_markdown
from scores import mean, weighted
from work import Item

CLICKS = (50, 100, 200)
# Options of the programs; those of the paper where none is named.
PLAIN = {"density": DEFAULT, "isolated-neighbors": DEFAULT, "blind-spot": DEFAULT}
NORMALS = {"normals": 0.03}
COLOR = {"color": 0.001}
CONNECTED = {"connected": "on"}
CLEAN = {"clean-up": "on"}
SETTINGS = {
    "paper": {"subsample": paper.SUBSAMPLE},
    "all points": {},
    "raw scans": PLAIN,
    "connected": PLAIN | CONNECTED,
    "normals": PLAIN | NORMALS,
    "color": PLAIN | COLOR,
    "clean-up": PLAIN | CLEAN,
    "connected, normals": PLAIN | CONNECTED | NORMALS,
    "connected, normals, color": PLAIN | CONNECTED | NORMALS | COLOR,
    "all": PLAIN | CONNECTED | NORMALS | COLOR | CLEAN,
    "defaults": PLAIN | {name: DEFAULT for name in ("connected", "normals", "color")},
}
# Mending boundaries after each of many clicks takes long, and AGILE3D's rules ask for many.
ONLY_WITH_PROPOSALS = ("clean-up", "all")
WITH_AGILE3D = ("paper", "raw scans", "defaults")
# The first corrective click is on a random point, so that starts differ.
PROTOCOLS = {"proposals": (), "corrective": ("--proposals", 1), "agile3d": ()}
FIGURES = {"proposals": ("mean_iou", "recall25", "recall50", "recall75", "ap50")}
FIGURES["corrective"] = FIGURES["proposals"]
FIGURES["agile3d"] = ("iou5", "iou10", "iou15", "noc80", "noc85", "noc90")


def annotate(item, programs, folder):
    """The scores of a simulated annotator, by number of clicks."""
    settings = item.settings
    protocol = settings["protocol"]
    clicks = () if protocol == "agile3d" else ("--clicks", ",".join(map(str, CLICKS)))
    report = folder / "clicks.json"
    begin = time.monotonic()
    programs.run("pcl_cid_simulate", item.scan.path, "--protocol", protocol, *clicks,
                 *PROTOCOLS[protocol], "--subsample", settings.get("subsample", 0),
                 "--random-seed", settings["start"], *options_beyond(paper.LABELS, settings),
                 "--threads", programs.threads, "--quiet", "--report", report)
    return {"seconds": time.monotonic() - begin,
            "scores": read_json(report)["scans"][0]["scores"]}


def settings_of(scan):
    """By name. A scan without colors has no setting of its own for them."""
    if has_color(scan):
        return SETTINGS
    return {name: {key: value for key, value in changed.items() if key != "color"}
            for name, changed in SETTINGS.items()
            if "color" not in changed or name in ("all", "defaults")}


def is_measured(name, protocol):
    if protocol == "agile3d":
        return name in WITH_AGILE3D
    return protocol == "proposals" or name not in ONLY_WITH_PROPOSALS


def over_instances(pairs, figure, k):
    """A figure after the k-th number of clicks, over all instances of all scans and starts."""
    return weighted([result["scores"][k] for _, result in pairs], figure, "instances")


class Clicks:
    """A table for each folder of scans and way to click; mean IoU against clicks."""

    name = "clicks"
    more_files = ("clicks.png",)

    def items(self, scan, options):
        return [item for _, item in self.named(scan, options)]

    @staticmethod
    def named(scan, options):
        """(name of the setting, item) pairs."""
        return [(name, Item(scan, "clicks", {"protocol": protocol, "start": start, **changed}))
                for protocol in PROTOCOLS for name, changed in settings_of(scan).items()
                if is_measured(name, protocol)
                # By the rules of AGILE3D, nothing is drawn.
                for start in range(1 if protocol == "agile3d" else options.starts)]

    def summarize(self, done, options, folder):
        runs = self.by_table(done, options)
        write_csv(folder / "clicks_scans.csv", [
            {"setting": name, "scan": item.scan.name, "protocol": protocol,
             "start": item.settings["start"], **row}
            for (_, protocol), named in runs.items() for name, pairs in named.items()
            for item, result in pairs for row in self.scan_rows(result, protocol)])
        rows, sections = [], []
        for (place, protocol), named in runs.items():
            table = [self.row(name, pairs, protocol) for name, pairs in named.items()]
            rows += [{"scans": place, "protocol": protocol, "setting": row["setting"],
                      "figure": figure, "value": value}
                     for row in table for figure, value in row.items() if figure != "setting"]
            scans = {item.scan.name for item, _ in next(iter(named.values()))}
            sections.append((f"{protocol}: scans in {place}", self.text(scans, protocol, options),
                             table))
        write_csv(folder / "clicks.csv", rows)
        write_markdown(folder / "clicks.md", sections)
        self.draw(runs, folder / "clicks.png")

    def by_table(self, done, options):
        """For each folder and protocol, the runs of each setting."""
        results = {item.id(): result for item, result in done}
        tables = defaultdict(lambda: defaultdict(list))
        for scan in dict.fromkeys(item.scan for item, _ in done):
            for name, item in self.named(scan, options):
                table = tables[place_of(scan), item.settings["protocol"]]
                table[name].append((item, results[item.id()]))
        return tables

    @staticmethod
    def scan_rows(result, protocol):
        """Rows with the same keys, whatever the protocol."""
        every = dict.fromkeys(FIGURES["proposals"] + FIGURES["agile3d"])
        return [{"clicks": each["clicks"], "used": each["used"], "instances": each["instances"],
                 **every, **{name: each[name] for name in FIGURES[protocol]},
                 "seconds": result["seconds"]} for each in result["scores"]]

    @staticmethod
    def row(name, pairs, protocol):
        """Of a setting."""
        seconds = mean(result["seconds"] for _, result in pairs)
        if protocol == "agile3d":
            scores = [result["scores"][0] for _, result in pairs]
            figures = {figure: mean(score[figure] for score in scores)
                       for figure in FIGURES[protocol]}
        else:
            figures = {f"{figure} at {clicks}": over_instances(pairs, figure, k)
                       for figure in FIGURES[protocol] for k, clicks in enumerate(CLICKS)}
        return {"setting": name, **figures, "seconds": seconds}

    @staticmethod
    def text(scans, protocol, options):
        if protocol == "agile3d":
            return f"{len(scans)} scans; means over the scans."
        return (f"{len(scans)} scans, {options.starts} random starts; over all instances. Seconds "
                f"are of a run of {CLICKS[-1]} clicks, beside other runs.")

    @staticmethod
    def draw(runs, path):
        """Mean IoU against clicks."""
        tables = {key: named for key, named in runs.items() if key[1] != "agile3d"}
        figure = new_figure(4.6 * len(tables), 4)
        for axes, ((place, protocol), named) in zip(
                figure.subplots(1, len(tables), sharey=True, squeeze=False)[0], tables.items()):
            for name, pairs in named.items():
                i = list(SETTINGS).index(name)
                axes.plot(CLICKS, [over_instances(pairs, "mean_iou", k)
                                   for k in range(len(CLICKS))],
                          label=name, color=f"C{i % 10}", linestyle="-" if i < 10 else "--")
            axes.set(title=f"{protocol}: {place}", xlabel="clicks", ylim=(0, 1.02))
            axes.grid(alpha=0.25)
        figure.axes[0].set_ylabel("mean IoU")
        lines, names = figure.axes[0].get_legend_handles_labels()  # proposals have them all
        figure.axes[-1].legend(lines, names, fontsize="small", loc="upper left",
                               bbox_to_anchor=(1, 1))
        save_picture(path, figure)
