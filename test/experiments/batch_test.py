#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# A tool on every scan of a folder: its outputs against those of calls of its own, scans that
# fail, what is done again, wrong command lines.
#
#   batch_test.py PROGRAMS_FOLDER

import csv
import json
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPTS = Path(__file__).resolve().parents[2] / "scripts" / "experiments"
PROGRAMS = Path(sys.argv.pop()).resolve()
SEGMENT = ("--labels-from", "label", "--seeds", "20")
ABSTRACT = ("--seeds", "20", "--parts", "5", "--mesh-format", "ply")


def rows_of(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def stamps(folder):
    """When each output of a scan was written."""
    return {path: path.stat().st_mtime_ns for tool in ("segment", "abstract", "evaluate")
            for path in (folder / tool).rglob("*") if path.is_file()}


class Batch(unittest.TestCase):
    def setUp(self):
        self.made = tempfile.TemporaryDirectory()
        self.folder = Path(self.made.name)
        self.scans, self.out = self.folder / "scans", self.folder / "out"
        self.scans.mkdir()
        self.options = self.folder / "options"
        self.write_options(SEGMENT)

    def tearDown(self):
        self.made.cleanup()

    def write_options(self, segment):
        self.options.write_text(f"# of a test\n\nsegment {' '.join(segment)}\n"
                                f"abstract {' '.join(ABSTRACT)}  # few\n")

    def run_it(self, tool, *more, scans=None, out=None):
        command = [sys.executable, "-B", str(SCRIPTS / "batch.py"), tool, str(scans or self.scans),
                   str(out or self.out), "--options", str(self.options), *more, "--programs",
                   str(PROGRAMS)]
        return subprocess.run(command, capture_output=True, text=True, timeout=300)

    def tool(self, name, *arguments):
        subprocess.run([PROGRAMS / name, *map(str, arguments), "--quiet"], check=True)

    def test_every_scan(self):
        subprocess.run([PROGRAMS / "make_dataset_folders", self.scans], check=True)
        room, scan = self.scans / "Area_1" / "office_1", self.scans / "scans" / "scene0000_00"
        thin = self.scans / "it's thin.pcd"
        subprocess.run([PROGRAMS / "cid_perturb", room, thin, "--keep", "0.7"], check=True)
        broken = self.scans / "broken.pcd"
        broken.write_text("no cloud\n")

        done = self.run_it("all")
        self.assertEqual(done.returncode, 1, done.stderr)
        names = {"Area_1/office_1": room, "it's thin": thin, "scans/scene0000_00": scan}
        for tool in ("segment", "abstract", "evaluate"):
            self.assertEqual([row["name"] for row in rows_of(self.out / f"{tool}.csv")],
                             list(names))
            self.assertIn(f"  broken ({tool}): {broken}: ", done.stderr)
        for name, path in names.items():
            cloud, mesh = self.folder / "cloud.pcd", self.folder / "mesh.ply"
            self.tool("pcl_cid_segment", path, cloud, *SEGMENT)
            self.tool("pcl_cid_abstract", path, mesh, *ABSTRACT[:-2])
            made = self.out / "segment" / f"{name}.pcd"
            self.assertEqual(made.read_bytes(), cloud.read_bytes())
            self.assertEqual((self.out / "abstract" / f"{name}.ply").read_bytes(),
                             mesh.read_bytes())
            scores = json.loads((self.out / "evaluate" / f"{name}.json").read_text())
            self.assertEqual(scores["classes_from"], "scannet" if path == scan else "s3dis")
            row = next(row for row in rows_of(self.out / "evaluate.csv") if row["name"] == name)
            self.assertEqual(float(row["ap50"]), scores["mean"]["ap50"])

        # The broken one is tried again, and no other.
        before = stamps(self.out)
        shutil.copy(thin, broken)
        done = self.run_it("all")
        self.assertEqual(done.returncode, 0, done.stderr)
        after = stamps(self.out)
        self.assertEqual({path: after[path] for path in before}, before)
        self.assertEqual(len(rows_of(self.out / "evaluate.csv")), 4)

        # Other options of a tool: what it made, and what was made of that, is made again.
        self.write_options((*SEGMENT, "--random-seed", "1"))
        done = self.run_it("all")
        self.assertEqual(done.returncode, 0, done.stderr)
        again = {path.relative_to(self.out).parts[0]
                 for path, time in stamps(self.out).items() if after[path] != time}
        self.assertEqual(again, {"segment", "evaluate"})

        # A scan that is bad by now: what was made of it before does not count.
        broken.write_text("no cloud any more\n")
        done = self.run_it("evaluate")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn(f"1 failed; they are not in the tables:\n  broken (evaluate): {broken}: ",
                      done.stderr)
        self.assertEqual([row["name"] for row in rows_of(self.out / "evaluate.csv")], list(names))
        for each in (thin, room / "Annotations", scan):
            shutil.rmtree(each) if each.is_dir() else each.unlink()
        self.assertEqual(self.run_it("segment").returncode, 1)
        self.assertFalse((self.out / "segment.csv").exists())

    def test_wrong_calls(self):
        def refused(code, text, tool="segment", *more, scans=None, out=None):
            done = self.run_it(tool, *more, scans=scans, out=out)
            self.assertEqual(done.returncode, code, done.stderr)
            self.assertIn(text, done.stderr)
            self.assertFalse(self.out.exists())

        refused(1, "holds no scan")
        for name in ("a.pcd", "a.ply"):
            (self.scans / name).write_text("")
        refused(1, "2 scans would have outputs of the name a;")
        (self.scans / "a.ply").rename(self.scans / "a{b}.ply")
        refused(1, "its path must be printable, in UTF-8, and without { }")
        (self.scans / "a{b}.ply").rename(self.scans / "a:b.ply")
        refused(1, "its name in the dataset must be printable, in UTF-8, and without , = :")
        refused(2, "invalid choice: 'no'", "no")
        refused(2, "--cores: '0'; it must be a whole number, at least 1", "segment", "--cores",
                "0")
        refused(2, "is no folder, PCD or PLY file", scans=self.options)
        refused(2, "must be a folder of its own", out=self.scans)
        refused(2, "must be a folder of its own", out=self.options)
        room = self.scans / "office_1"
        (room / "Annotations").mkdir(parents=True)
        refused(2, f"must not be in a scan, {room}", out=room / "out")
        shutil.rmtree(room)
        for line, text in (("segment --seeds none", "--seeds is 'none'"),
                           ("segments", "line 1: 'segments' is not expected here"),
                           ("segment\nsegment", "line 2: 'segment' is not expected here"),
                           ("segment 'open", "No closing quotation"),
                           ("segment --help", "options of its work on a scan only"),
                           ("segment another.pcd", "options of its work on a scan only"),
                           ("abstract --mesh-format=no", "--mesh-format is 'no'"),
                           ("abstract --threads 2", "'--threads' cannot be specified more")):
            self.options.write_text(line)
            refused(2, text)


if __name__ == "__main__":
    unittest.main()
