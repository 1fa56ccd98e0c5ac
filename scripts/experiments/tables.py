# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# Tables I and II of the paper: label propagation in the paper's setting and at full
# resolution, beside the paper's figures.

import paper
from propagation import COLUMNS, by_classes, propagation, scan_row, with_setting
from report import write_csv, write_markdown
from scores import THRESHOLDS, summary


class Tables:
    """Tables I and II."""

    name = "tables"

    def items(self, scan, options):
        return [propagation(scan, options.seeds, start=start, **column)
                for column in COLUMNS.values() for start in range(options.starts)]

    def summarize(self, done, options, folder):
        write_csv(folder / "tables_scans.csv", [scan_row(*pair) for pair in done])
        rows, sections = [], []
        for classes_from, pairs in by_classes(done).items():
            summaries = {name: summary(with_setting(pairs, **column))
                         for name, column in COLUMNS.items()}
            rows += self.csv_rows(classes_from, summaries)
            sections.append(self.section(classes_from, summaries, options))
        write_csv(folder / "tables.csv", rows)
        write_markdown(folder / "tables.md", sections)

    @staticmethod
    def csv_rows(classes_from, summaries):
        rows = []
        for setting, each in summaries.items():
            for name, values in each["classes"].items():
                row = {"classes_from": classes_from, "setting": setting, "class": name,
                       "truth_instances": each["truths"].get(name, sum(each["truths"].values()))}
                row |= {f"ap{t}": value for t, value in zip(THRESHOLDS, values)}
                row |= {f"paper_ap{t}": value for t, value in
                        zip(THRESHOLDS, paper.of_class(classes_from, name))}
                rows.append(row)
        return rows

    @staticmethod
    def section(classes_from, summaries, options):
        """A row for each class: the paper's figures, ours, and those of the nets."""
        first = next(iter(summaries.values()))
        rows = []
        for name in first["classes"]:
            theirs = paper.of_class(classes_from, name)
            row = {"class": name,
                   "instances": first["truths"].get(name, sum(first["truths"].values()))}
            for i, t in enumerate(THRESHOLDS):
                row[f"AP{t} paper"] = theirs[i]
                for setting in COLUMNS:
                    row[f"AP{t} {setting}"] = summaries[setting]["classes"][name][i]
            row |= {"AP50 SGPN": theirs[3], "AP50 PointGroup": theirs[4]}
            rows.append(row)
        title, _ = paper.TABLES.get(classes_from, ("Instances without classes", {}))
        spread = "; ".join(
            f"{setting}: mean AP50 of the starts {min(each['ap50_of_starts']):.3f} to "
            f"{max(each['ap50_of_starts']):.3f}, mean IoU {each['mean_iou']:.3f}"
            for setting, each in summaries.items())
        text = (f"{first['scans']} scans, {first['starts']} random starts, "
                f"{options.seeds} seeds. {spread}.")
        return title, text, rows
