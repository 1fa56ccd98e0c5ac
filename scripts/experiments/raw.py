# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# What raw scans need beyond the paper: each means alone and all together, beside the paper's
# method. Scans are pooled by the folder they are in, for what helps some harms others.

import statistics
from pathlib import PurePosixPath

import paper
from programs import DEFAULT
from propagation import by_classes, propagation, scan_row
from report import new_figure, save_picture, write_csv, write_markdown
from scores import summary, weighted

ALL_POINTS = 0
# Metres for each unit of Lab.
COLOR_WEIGHT = 0.001
# What each setting changes; options that it does not name are the paper's.
DEFAULTS = dict.fromkeys(paper.NOT_BY_DEFAULT, DEFAULT)
SETTINGS = {
    "paper": {},
    "density on": {"density": "on"},
    "isolated points": {"isolated-neighbors": DEFAULT},
    "soft seeding": {"seeding": "soft"},
    "color": {"color": COLOR_WEIGHT},
    "defaults": DEFAULTS,
    "all": DEFAULTS | {"seeding": "soft", "color": COLOR_WEIGHT},
}
# So much worse than the better of off and on may auto be, in mean IoU.
TOLERANCE = 0.01


def has_color(scan):
    """Whether the header of a file names colors. Folders of S3DIS and ScanNet have them."""
    if scan.path.is_dir():
        return True
    try:
        with open(scan.path, "rb") as file:
            for line in file:
                words = set(line.split())
                if words & {b"rgb", b"rgba", b"red"}:
                    return True
                if words & {b"DATA", b"end_header"}:
                    return False
    except OSError:
        pass  # its measurements will say so
    return False


def settings_of(scan):
    """By name. A scan without colors has no setting of its own for them."""
    if has_color(scan):
        return SETTINGS
    plain = {name: {key: value for key, value in changed.items() if key != "color"}
             for name, changed in SETTINGS.items()}
    return {name: changed for name, changed in plain.items() if changed or name == "paper"}


def place_of(scan):
    """The folder of the dataset that it is in."""
    return PurePosixPath(scan.name).parent.name or "the dataset"


def mean_iou(runs):
    """Over the truth instances of (item, result) pairs."""
    return weighted([result for _, result in runs], "mean_iou", "truth_instances")


class Raw:
    """A table for each folder of scans, and whether the automatic decision is right."""

    name = "raw"
    more_files = ("raw_checks.csv", "raw.png")

    def items(self, scan, options):
        return [item for runs in self.by_name(scan, options).values() for item in runs]

    @staticmethod
    def by_name(scan, options):
        """For each setting, the items of its starts."""
        return {name: [propagation(scan, options.seeds, ALL_POINTS, start, **changed)
                       for start in range(options.starts)]
                for name, changed in settings_of(scan).items()}

    def summarize(self, done, options, folder):
        named = self.by_setting(done, options)
        write_csv(folder / "raw_scans.csv", [
            {"setting": name, **self.scan_row(*run)}
            for name, runs in named.items() for run in runs])
        rows, sections, checks = [], [], []
        for place, runs in self.by_place(named).items():
            table = self.rows(runs)
            rows += [{"scans": place, **row} for row in table]
            sections.append((f"Scans in {place}", self.text(runs, options), table))
            checks += self.checks(place, runs)
        sections.append(self.verdict(checks))
        write_csv(folder / "raw.csv", rows)
        write_csv(folder / "raw_checks.csv", checks)
        write_markdown(folder / "raw.md", sections)
        self.draw(rows, folder / "raw.png")

    def by_setting(self, done, options):
        """The runs of each."""
        results = {item.id(): result for item, result in done}
        scans = dict.fromkeys(item.scan for item, _ in done)
        runs = {name: [] for name in SETTINGS}
        for scan in scans:
            for name, items in self.by_name(scan, options).items():
                runs[name] += [(item, results[item.id()]) for item in items]
        return runs

    @staticmethod
    def by_place(named):
        """For each folder, and kind of classes, the runs of each setting."""
        places = {}
        for name, runs in named.items():
            for classes_from, some in by_classes(runs).items():
                for run in some:
                    place = f"{place_of(run[0].scan)} (classes: {classes_from})"
                    places.setdefault(place, {}).setdefault(name, []).append(run)
        return places

    @staticmethod
    def scan_row(item, result):
        row = scan_row(item, result)
        return {**{key: row.get(key) for key in ("scan", "seeds", "start")},
                **{key: value for key, value in row.items() if key not in item.settings},
                "purity": result["purity"], **result["density"]}

    @staticmethod
    def rows(runs):
        """A setting each, with the difference to the paper's."""
        rows = []
        for name, some in runs.items():
            results = [result for _, result in some]
            row = {"setting": name, "mean IoU": mean_iou(some), "AP50": summary(some)["mean"][1],
                   "purity": weighted(results, "purity", "labelled_points")}
            base = rows[0] if rows else row
            row |= {f"{figure}, more than paper": row[figure] - base[figure]
                    for figure in list(row)[1:]}
            row["seconds"] = statistics.fmean(result["seconds"] for result in results)
            rows.append(row)
        return rows

    @staticmethod
    def text(runs, options):
        scans = {item.scan.name for item, _ in runs["paper"]}
        return (f"{len(scans)} scans, {options.starts} random starts, {options.seeds} seeds, "
                "all points.")

    @staticmethod
    def checks(place, runs):
        """Of a folder as a whole, then of each of its scans. `auto` is what was decided for
        the scan with the defaults: the result of on or of off."""
        decided = {item.scan.name: result["density"] for item, result in runs["defaults"]}
        off, on = runs["paper"], runs["density on"]
        auto = [on[i] if decided[run[0].scan.name]["weighted"] else run
                for i, run in enumerate(off)]
        rows = []
        for name, chosen in [(place, set(decided)), *((scan, {scan}) for scan in decided)]:
            means = [mean_iou([run for run in some if run[0].scan.name in chosen])
                     for some in (off, on, auto)]
            spreads = [decided[scan]["spread"] for scan in chosen]
            rows.append({
                "scans": name, "spread": f"{min(spreads):.2f} to {max(spreads):.2f}",
                "on in": sum(decided[scan]["weighted"] for scan in chosen),
                **dict(zip(("mean IoU off", "mean IoU on", "mean IoU auto"), means)),
                "less than the better": max(means) - means[2],
                "kept": "yes" if means[2] >= max(means) - TOLERANCE else "NO"})
        return rows

    @staticmethod
    def verdict(checks):
        kept = sum(row["kept"] == "yes" for row in checks)
        return ("Is auto as good as the better of off and on?",
                f"To within {TOLERANCE} mean IoU: in {kept} of {len(checks)} rows. A folder first, "
                "then its scans; \"on in\" is the number of scans where auto is on.", checks)

    @staticmethod
    def draw(rows, path):
        """What each setting brings, for each folder."""
        places = list(dict.fromkeys(row["scans"] for row in rows))
        figure = new_figure(9, 3.8)
        axes = figure.subplots()
        names = list(SETTINGS)[1:]
        width = 0.8 / len(places)
        for i, place in enumerate(places):
            gains = {row["setting"]: row["mean IoU, more than paper"] for row in rows
                     if row["scans"] == place}
            at = [k + (i - (len(places) - 1) / 2) * width for k, name in enumerate(names)
                  if name in gains]
            axes.bar(at, [gains[name] for name in names if name in gains], width, label=place)
        axes.axhline(0, color="k", linewidth=0.8)
        axes.set_xticks(range(len(names)), labels=names)
        axes.set_ylabel("mean IoU, more than paper")
        axes.grid(axis="y", alpha=0.25)
        axes.legend(fontsize="small")
        save_picture(path, figure)
