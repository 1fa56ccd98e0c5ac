#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# The experiments on rooms in the layouts of S3DIS and ScanNet: their scores against those of
# pcl_cid_evaluate, runs that are killed, scans that fail.
#
#   experiments_test.py PROGRAMS_FOLDER

import csv
import json
import math
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

SCRIPTS = Path(__file__).resolve().parents[2] / "scripts" / "experiments"
sys.path.insert(0, str(SCRIPTS))
sys.dont_write_bytecode = True

import clicks  # noqa: E402
from programs import raw_scan_options  # noqa: E402
from raw import SETTINGS  # noqa: E402
from scans import scans_of  # noqa: E402

PROGRAMS = Path(sys.argv.pop()).resolve()
SEEDS = 20
AS_IN_THE_PAPER = raw_scan_options({})


def command(*arguments):
    return [sys.executable, str(SCRIPTS / "main.py"), "--programs", str(PROGRAMS),
            "--seeds", str(SEEDS), "--starts", "2", *map(str, arguments)]


def experiment(*arguments):
    return subprocess.run(command(*arguments), capture_output=True, text=True, timeout=300)


def tool(name, *arguments):
    subprocess.run([PROGRAMS / name, *map(str, arguments), "--quiet"], check=True)


def rows_of(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def stamps(folder):
    """When each result was written, in this order."""
    times = {path: path.stat().st_mtime_ns for path in folder.rglob("results/**/*.json")}
    return dict(sorted(times.items(), key=lambda pair: pair[1]))


class OnADataset(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.made = tempfile.TemporaryDirectory()
        cls.dataset = Path(cls.made.name) / "dataset"
        cls.dataset.mkdir()
        subprocess.run([PROGRAMS / "make_dataset_folders", cls.dataset], check=True)
        cls.room = cls.dataset / "Area_1" / "office_1"
        # A second room: the same one with other points.
        thin = [cls.room, cls.dataset / "thin.pcd", "--keep", "0.7"]
        subprocess.run([PROGRAMS / "cid_perturb", *thin], check=True)
        cls.run_all(Path(cls.made.name))

    @classmethod
    def run_all(cls, folder):
        """All experiments on a room with a corrupt line."""
        cls.office, cls.all = folder / "office_1", folder / "all"
        shutil.copytree(cls.room, cls.office)
        cls.wall = min((cls.office / "Annotations").glob("wall_*.txt"))
        lines = cls.wall.read_bytes().splitlines()
        lines[2] = lines[2].replace(b" ", b"\0", 1)
        cls.wall.write_bytes(b"\n".join(lines) + b"\n")
        cls.all_of_it = ("all", cls.office, cls.all, "--starts", "1", "--methods",
                         "cid,euclidean,region_growing")
        done = experiment(*cls.all_of_it)
        assert done.returncode == 0, done.stderr
        cls.told = done.stdout

    @classmethod
    def tearDownClass(cls):
        cls.made.cleanup()

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.out = Path(self.folder.name) / "out"

    def tearDown(self):
        self.folder.cleanup()

    def run_it(self, *arguments):
        done = experiment(*arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done

    def dataset_of_its_own(self):
        dataset = Path(self.folder.name) / "dataset"
        dataset.mkdir()
        shutil.copy(self.dataset / "thin.pcd", dataset)
        return dataset

    def test_scans_are_found_at_any_depth(self):
        inside = self.dataset / "out"
        inside.mkdir()
        shutil.copy(self.dataset / "thin.pcd", inside)
        try:
            names = [scan.name for scan in scans_of(self.dataset, inside)]
        finally:
            shutil.rmtree(inside)
        self.assertEqual(names, ["Area_1/office_1", "scans/scene0000_00", "thin.pcd"])
        self.assertEqual([scan.name for scan in scans_of(self.room, inside)], ["office_1"])

    def test_scores_are_those_of_the_evaluation(self):
        self.run_it("tables", self.dataset, self.out)
        means = []
        for start in range(2):
            prediction = Path(self.folder.name) / f"prediction_{start}"
            truth = Path(self.folder.name) / "truth"
            prediction.mkdir()
            truth.mkdir(exist_ok=True)
            for scan in (self.room, self.dataset / "thin.pcd"):
                link = truth / scan.name
                if not link.exists():
                    link.symlink_to(scan)
                tool("pcl_cid_segment", scan, prediction / (scan.stem + ".pcd"), "--labels-from",
                     "label", "--seeds", SEEDS, "--random-seed", start, "--threads", "1",
                     *AS_IN_THE_PAPER)
            report = Path(self.folder.name) / "report.json"
            tool("pcl_cid_evaluate", prediction, truth, "--report", report)
            means.append(json.loads(report.read_text())["mean"])
        rows = [row for row in rows_of(self.out / "tables.csv") if row["class"] == "mean"
                and row["classes_from"] == "s3dis" and row["setting"] == "all points"]
        self.assertEqual(len(rows), 1)
        for figure in ("ap25", "ap50", "ap75"):
            expected = sum(mean[figure] for mean in means) / len(means)
            self.assertAlmostEqual(float(rows[0][figure]), expected)
        self.assertIn("Table II, ScanNet", (self.out / "tables.md").read_text())

    def test_purity_is_that_of_the_evaluation(self):
        parts = 12
        work = Path(self.folder.name)
        for setting, groups in (("defaults", "cid"), ("patches", "patches")):
            row, = [row for row in rows_of(self.all / "purity_scans.csv")
                    if (row["setting"], row["parts"]) == (setting, str(parts))]
            tool("pcl_cid_abstract", self.office, work / "hulls.ply", "--parts", parts, "--seeds",
                 SEEDS, "--groups", groups, "--threads", "1", "--labels", work / "parts.pcd")
            tool("pcl_cid_evaluate", work / "parts.pcd", self.office, "--protocol", "s3dis",
                 "--report", work / "report.json")
            report = json.loads((work / "report.json").read_text())
            self.assertAlmostEqual(float(row["purity"]), report["purity"])
            self.assertAlmostEqual(float(row["compactness"]), report["compactness"])

    def stop_at(self, results, arguments, number):
        """Start a run, and stop it and all that it started after so many results."""
        process = subprocess.Popen(command(*arguments), stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL, start_new_session=True)
        while len(stamps(self.out)) < results:
            self.assertIsNone(process.poll())
            time.sleep(0.02)
        second = experiment(*arguments)
        self.assertEqual(second.returncode, 1)
        self.assertIn("another run works in this folder", second.stderr)
        os.killpg(process.pid, number)
        process.wait()

    def test_killed_run_goes_on(self):
        arguments = ("tables", self.dataset / "Area_1", self.out, "--cores", "1", "--starts", "4")
        before = {}
        for number in (signal.SIGKILL, signal.SIGINT):
            self.stop_at(len(before) + 3, arguments, number)
            now = stamps(self.out)
            # What was written last may not have been seen to be whole.
            self.assertLess(len(now), 12)
            self.assertEqual({path: now[path] for path in list(before)[:-1]},
                             {path: before[path] for path in list(before)[:-1]})
            before = now
        self.run_it(*arguments)
        after = stamps(self.out)
        self.assertEqual(len(after), 3 * 4)  # settings, starts
        kept = list(before)[:-1]
        self.assertEqual([after[path] for path in kept], [before[path] for path in kept])
        self.assertFalse((self.out / "work").exists() and any((self.out / "work").iterdir()))
        self.assertFalse(list(self.out.rglob("incomplete/*")))
        fresh = Path(self.folder.name) / "fresh"
        self.run_it(*arguments[:2], fresh, *arguments[3:])
        self.assertEqual((self.out / "tables.csv").read_bytes(),
                         (fresh / "tables.csv").read_bytes())

    def test_failing_scans_are_named_and_the_others_are_scored(self):
        dataset = self.dataset_of_its_own()
        (dataset / "broken.pcd").write_text("no cloud\n")
        (dataset / "gone.pcd").symlink_to("nowhere.pcd")
        arguments = ("tables", dataset, self.out, "--starts", "1")
        done = experiment(*arguments)
        self.assertEqual(done.returncode, 1)
        self.assertIn("2 failed; they are not in the tables:", done.stderr)
        for name in ("broken.pcd", "gone.pcd"):
            self.assertIn(f"{name} (tables): pcl_cid_segment: ", done.stderr.splitlines()[-2:][
                name == "gone.pcd"])
        self.assertEqual({row["scan"] for row in rows_of(self.out / "tables_scans.csv")},
                         {"thin.pcd"})
        self.assertIn("2 scans failed and are not in these tables:\n\n* broken.pcd\n* gone.pcd\n",
                      (self.out / "tables.md").read_text())
        # They are tried again; what went well is not done again.
        before = stamps(self.out)
        shutil.copy(self.dataset / "thin.pcd", dataset / "broken.pcd")
        (dataset / "gone.pcd").unlink()
        self.run_it(*arguments)
        self.assertEqual({path: stamps(self.out)[path] for path in before}, before)
        self.assertEqual({row["scan"] for row in rows_of(self.out / "tables_scans.csv")},
                         {"broken.pcd", "thin.pcd"})
        self.assertNotIn("failed", (self.out / "tables.md").read_text())

    def test_what_changed_or_is_broken_is_done_again(self):
        dataset = self.dataset_of_its_own()
        arguments = ("tables", dataset, self.out, "--starts", "1")
        self.run_it(*arguments)
        before = stamps(self.out)
        old = (dataset / "thin.pcd").stat()
        subprocess.run([PROGRAMS / "cid_perturb", self.room, dataset / "thin.pcd",
                        "--keep", "0.5"], check=True)
        os.utime(dataset / "thin.pcd", ns=(old.st_atime_ns, old.st_mtime_ns))
        self.run_it(*arguments)
        changed = stamps(self.out)
        self.assertEqual(set(changed), set(before))
        self.assertFalse(set(changed.items()) & set(before.items()))
        table = (self.out / "tables.csv").read_bytes()
        result = next(iter(changed))
        result.write_bytes(result.read_bytes()[:-9])
        done = experiment(*arguments)
        self.assertEqual(done.returncode, 1)
        self.assertIn(f"{result}: is broken; remove it", done.stderr)
        result.unlink()
        self.run_it(*arguments)
        self.assertEqual((self.out / "tables.csv").read_bytes(), table)
        self.assertEqual(len(set(stamps(self.out).items()) - set(changed.items())), 1)

    def test_options_of_snakemake(self):
        arguments = ("tables", self.room, self.out, "--starts", "1")
        graph = self.run_it(*arguments, "--dag").stdout
        self.assertTrue(graph.startswith("digraph"))
        self.assertIn("tables", graph)
        self.assertIn("measure_propagate", self.run_it(*arguments, "-n").stdout)
        self.assertFalse(stamps(self.out))
        self.assertEqual(experiment(*arguments, "--no-such-option").returncode, 2)

    def test_nothing_is_done_twice(self):
        before = stamps(self.all)
        done = self.run_it(*self.all_of_it)
        self.assertIn("Nothing to be done", done.stderr)
        self.assertEqual(stamps(self.all), before)

    def test_remarks_on_scans_are_told(self):
        for name in ("tables", "labels"):
            told = (self.all / f"{name}_remarks.txt").read_text().splitlines()
            self.assertEqual(len(told), 1)
            self.assertIn(f"{self.wall}: line 3: ", told[0])
            self.assertIn(f"{name}_remarks.txt", self.told)

    def test_sweeps(self):
        seeds = {row["seeds"]: row for row in rows_of(self.all / "seeds.csv")
                 if row["class"] == "mean" and row["setting"] == "all points"}
        self.assertEqual(list(seeds), ["10", "20"])
        self.assertTrue((self.all / "seeds_s3dis.png").exists())
        noise = rows_of(self.all / "noise.csv")
        for kind in ("noise", "keep"):
            without = next(row for row in noise if row["disturbance"] == kind)
            self.assertEqual(without["AP50"], seeds[str(SEEDS)]["ap50"])
        for row in rows_of(self.all / "noise_scans.csv"):
            # What is kept of n points: n p, give or take five standard deviations.
            keep, points = float(row["keep"]), self.points()
            self.assertAlmostEqual(float(row["points"]), points * keep,
                                   delta=5 * math.sqrt(points * keep * (1 - keep)))

    def test_raw_scan_settings(self):
        self.assertIn("Is auto as good", self.told)
        scans = {row["setting"]: row for row in rows_of(self.all / "raw_scans.csv")}
        self.assertEqual(list(scans), list(SETTINGS))  # rooms of S3DIS have colors
        self.assertEqual(scans["paper"]["weighted"], "False")
        self.assertEqual(scans["density on"]["weighted"], "True")
        decided = scans["density on" if scans["defaults"]["weighted"] == "True" else "paper"]
        check = rows_of(self.all / "raw_checks.csv")[0]
        self.assertAlmostEqual(float(check["mean IoU auto"]), float(decided["mean_iou"]))
        self.assertEqual(rows_of(self.all / "raw.csv")[0]["mean IoU, more than paper"], "0.0")
        self.assertTrue((self.all / "raw.png").exists())

    def test_clicks(self):
        rows = rows_of(self.all / "clicks_scans.csv")
        settings = {protocol: {row["setting"] for row in rows if row["protocol"] == protocol}
                    for protocol in clicks.PROTOCOLS}
        self.assertEqual(settings["proposals"], set(clicks.SETTINGS))
        self.assertEqual(settings["agile3d"], set(clicks.WITH_AGILE3D))
        work = Path(self.folder.name)
        tool("pcl_cid_simulate", self.office, "--clicks", "50,100", "--threads", "1",
             "--connected", "off", "--color", "0", "--normals", "0.03", "--report",
             work / "report.json")
        expected = json.loads((work / "report.json").read_text())["all"]
        found = [row for row in rows if (row["protocol"], row["setting"]) ==
                 ("proposals", "normals")]
        for row, scores in zip(found, expected):
            for figure in ("clicks", "used", "mean_iou", "recall75", "ap50"):
                self.assertAlmostEqual(float(row[figure]), scores[figure])
        pooled = {(row["setting"], row["figure"]): float(row["value"])
                  for row in rows_of(self.all / "clicks.csv") if row["protocol"] == "proposals"}
        self.assertAlmostEqual(pooled["normals", "mean_iou at 100"], expected[1]["mean_iou"])
        self.assertIn("agile3d: scans in", self.told)
        self.assertTrue((self.all / "clicks.png").exists())

    def points(self):
        files = (self.office / "Annotations").iterdir()
        return sum(len(file.read_text().splitlines()) for file in files)

    def test_peers(self):
        runs = rows_of(self.all / "peers_runs.csv")
        purity = {method: [float(row["purity"]) for row in runs if row["method"] == method]
                  for method in ("cid", "euclidean", "region_growing")}
        self.assertEqual([len(each) for each in purity.values()], [1, 1, 24])  # starts; settings
        for row in runs:
            if row["parts"] == str(SEEDS):  # CID with as many parts is CID
                self.assertAlmostEqual(float(row["CID"]), sum(purity["cid"]))
        self.assertGreater(sum(purity["cid"]), sum(purity["euclidean"]))
        self.assertIn("| euclidean |", (self.all / "peers.md").read_text())
        self.assertTrue((self.all / "peers.png").exists())

    def test_heat_map(self):
        self.run_it("heatmap", self.dataset, self.out, "--scans", "2")
        rows = rows_of(self.out / "heatmap_scans.csv")
        self.assertEqual({row["from"] for row in rows}, {"table", "wall"})
        self.assertEqual(len(list(self.out.rglob("heatmap-start0.png"))), 2)
        for row in rows:
            self.assertGreater(float(row["separation by CID"]), 0.5)

    def test_picture_of_labels(self):
        self.assertEqual(len(list(self.all.rglob("labels-*.png"))), 1)
        work = Path(self.folder.name)
        tool("pcl_cid_segment", self.office, work / "labelled.pcd", "--labels-from", "label",
             "--seeds", SEEDS, "--threads", "1", "--report", work / "report.json",
             *AS_IN_THE_PAPER)
        score = json.loads((work / "report.json").read_text())["score"]
        row = rows_of(self.all / "labels_scans.csv")[0]
        self.assertAlmostEqual(float(row["all points"]), score["right"] / score["points"])


if __name__ == "__main__":
    unittest.main()
