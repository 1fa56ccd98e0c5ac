# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# AP against noise and against thinning, at full resolution. The paper promises a picture of
# noise on its website and has no figures.

from propagation import by_classes, propagation, scan_row, with_setting
from report import new_figure, save_picture, write_csv, write_markdown
from scores import THRESHOLDS, summary

ALL_POINTS = 0
# Of each disturbance, how much: standard deviation of Gaussian noise on each coordinate in
# metres; share of the points that is kept. The first one is none.
SWEEPS = {"noise": (0, 0.002, 0.005, 0.01, 0.02, 0.05), "keep": (1, 0.5, 0.2, 0.1, 0.05, 0.02)}
LABELS = {"noise": "standard deviation of the noise, metres", "keep": "share of points kept"}


class Noise:
    """Two sweeps."""

    name = "noise"

    @staticmethod
    def disturbance(kind, amount):
        """As a setting; none for an undisturbed scan."""
        return {} if amount == SWEEPS[kind][0] else {kind: amount}

    def items(self, scan, options):
        undisturbed = [propagation(scan, options.seeds, ALL_POINTS, start)
                       for start in range(options.starts)]
        return undisturbed + [
            propagation(scan, options.seeds, ALL_POINTS, start, **{kind: amount})
            for kind, amounts in SWEEPS.items() for amount in amounts[1:]
            for start in range(options.starts)]

    def summarize(self, done, options, folder):
        write_csv(folder / "noise_scans.csv",
                  [{"noise": 0, "keep": 1, **scan_row(*pair)} for pair in done])
        rows, sections = [], []
        for classes_from, pairs in by_classes(done).items():
            curves = {kind: [summary(with_setting(pairs, **self.disturbance(kind, amount)))
                             for amount in amounts] for kind, amounts in SWEEPS.items()}
            for kind, curve in curves.items():
                table = self.rows(kind, curve)
                rows += [{"classes_from": classes_from, "disturbance": kind,
                          "amount": row[LABELS[kind]],
                          **{key: row[key] for key in list(row)[1:]}} for row in table]
                text = (f"Mean over the classes; {curve[0]['scans']} scans, "
                        f"{curve[0]['starts']} random starts, {options.seeds} seeds, all points.")
                sections.append((f"By {LABELS[kind]}, classes: {classes_from}", text, table))
            self.draw(curves, folder / f"noise_{classes_from}.png")
        write_csv(folder / "noise.csv", rows)
        write_markdown(folder / "noise.md", sections)

    @staticmethod
    def rows(kind, curve):
        return [{LABELS[kind]: str(amount),
                 **{f"AP{t}": value for t, value in zip(THRESHOLDS, each["mean"])},
                 "mean IoU": each["mean_iou"]} for amount, each in zip(SWEEPS[kind], curve)]

    def draw(self, curves, path):
        figure = new_figure(9, 3.8)
        panels = figure.subplots(1, len(SWEEPS), sharey=True)
        for axes, (kind, curve) in zip(panels, curves.items()):
            rows = self.rows(kind, curve)
            for name in list(rows[0])[1:]:
                axes.plot(SWEEPS[kind], [row[name] for row in rows], "o-", label=name)
            axes.set(xlabel=LABELS[kind], ylim=(0, 1.02))
            axes.grid(alpha=0.25)
        panels[1].set_xscale("log")
        panels[1].invert_xaxis()
        panels[1].set_xticks(SWEEPS["keep"], labels=[f"{keep:g}" for keep in SWEEPS["keep"]])
        panels[1].minorticks_off()
        panels[1].legend(fontsize="small")
        save_picture(path, figure)
