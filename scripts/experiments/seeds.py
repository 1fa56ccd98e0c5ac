# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# AP against the number of seeds: the paper's figure on their effects.

import paper
from propagation import COLUMNS, by_classes, propagation, scan_row, with_setting
from report import new_figure, save_picture, write_csv, write_markdown
from scores import THRESHOLDS, summary


class SeedSweep:
    """AP50 against the number of seeds: the figure on their effects."""

    name = "seeds"

    @staticmethod
    def numbers(options):
        """10, 20 ... up to the number of seeds."""
        return list(range(10, options.seeds, 10)) + [options.seeds]

    def items(self, scan, options):
        return [propagation(scan, seeds, start=start, **column) for column in COLUMNS.values()
                for seeds in self.numbers(options) for start in range(options.starts)]

    def summarize(self, done, options, folder):
        write_csv(folder / "seeds_scans.csv", [scan_row(*pair) for pair in done])
        rows, sections = [], []
        for classes_from, pairs in by_classes(done).items():
            curves = {
                (setting, seeds): summary(with_setting(pairs, seeds=seeds, **column))
                for setting, column in COLUMNS.items() for seeds in self.numbers(options)}
            rows += [{"classes_from": classes_from, "setting": setting, "seeds": seeds,
                      "class": name, "ap50": values[1]}
                     for (setting, seeds), each in curves.items()
                     for name, values in each["classes"].items()]
            sections.append(self.section(classes_from, curves, options))
            self.draw(curves, options, folder / f"seeds_{classes_from}.png")
        write_csv(folder / "seeds.csv", rows)
        write_markdown(folder / "seeds.md", sections)

    def section(self, classes_from, curves, options):
        rows = []
        for seeds in self.numbers(options):
            row = {"seeds": seeds}
            for setting in COLUMNS:
                ap = curves[setting, seeds]["mean"]
                row |= {f"AP{t} {setting}": value for t, value in zip(THRESHOLDS, ap)}
            row["AP50 paper"] = (paper.of_class(classes_from, "mean")[1]
                                 if seeds == 100 else None)
            rows.append(row)
        some = next(iter(curves.values()))
        text = f"Mean over the classes; {some['scans']} scans, {some['starts']} random starts."
        return f"Number of seeds, classes: {classes_from}", text, rows

    def draw(self, curves, options, path):
        figure = new_figure(14, 4.2)
        panels = figure.subplots(1, len(COLUMNS), sharey=True)
        numbers = self.numbers(options)
        for axes, setting in zip(panels, COLUMNS):
            names = [name for name, values in curves[setting, numbers[-1]]["classes"].items()
                     if values[1] is not None and name != "mean"]
            for i, name in enumerate([*names, "mean"]):
                values = [curves[setting, seeds]["classes"][name][1] for seeds in numbers]
                style = (dict(color="k", linewidth=3) if name == "mean" else
                         dict(color=f"C{i % 10}", linestyle="-" if i < 10 else "--"))
                axes.plot(numbers, values, label=name, **style)
            axes.set(title=setting, xlabel="seeds", ylim=(0, 1.02))
            axes.grid(alpha=0.25)
        panels[0].set_ylabel("AP50")
        panels[-1].legend(fontsize="small", loc="upper left", bbox_to_anchor=(1, 1))
        save_picture(path, figure)
