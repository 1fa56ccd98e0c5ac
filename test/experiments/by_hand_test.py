#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# What the experiments compute, on figures that can be checked by hand.

import sys
import tempfile
import unittest
from pathlib import Path

SCRIPTS = Path(__file__).resolve().parents[2] / "scripts" / "experiments"
sys.path.insert(0, str(SCRIPTS))
sys.dont_write_bytecode = True

import scores  # noqa: E402
from clouds import labelled  # noqa: E402
from experiments_plan import read_result  # noqa: E402
from heatmap import separation  # noqa: E402
from peers_summary import Comparison  # noqa: E402
from purity import contingency, purities  # noqa: E402
from raw import TOLERANCE, Raw, has_color, place_of, settings_of  # noqa: E402
from scans import Scan, natural, spread  # noqa: E402
from work import Item  # noqa: E402

import numpy as np  # noqa: E402


class ByHand(unittest.TestCase):
    def test_average_precision(self):
        # doc/core/evaluation.md: 6 right, 2 wrong, 4 missing.
        counted = {"truths": 10, "predictions": 8, "right50": 6}
        self.assertAlmostEqual(scores.average_precision(counted, 50), 0.525)
        self.assertIsNone(scores.average_precision({"truths": 0, "predictions": 0}, 50))
        self.assertEqual(scores.average_precision({"truths": 3, "predictions": 0}, 50), 0)

    def test_pooling_sums_counts(self):
        def scan(truths, predictions, right):
            return {"classes": {"chair": {"truths": truths, "predictions": predictions,
                                          **{f"right{t}": right for t in (25, 50, 75)}}}}
        # 3 of 4 found, all 3 predictions right: not the mean of the two scans' APs.
        self.assertEqual(scores.pooled([scan(1, 1, 1), scan(3, 2, 2)])["mean"], (0.75,) * 3)

    def test_purity_of_merges(self):
        table = contingency(np.array([1, 1, 2, 2, 3]), np.array([7, 7, 7, 9, 9]))
        self.assertEqual(table.tolist(), [[2, 0], [1, 1], [0, 1]])
        steps = [{"first": 1, "second": 2}, {"first": 0, "second": 1}]
        self.assertEqual(purities(table, steps), [0.8, 0.8, 0.6])

    def test_scan_without_labels_is_refused(self):
        for fields in ([("x", "<f4"), ("y", "<f4"), ("z", "<f4")],
                       [("x", "<f4"), ("y", "<f4"), ("z", "<f4"), ("label", "<u4")]):
            with self.assertRaisesRegex(ValueError, "label"):
                labelled(np.zeros(3, fields))

    def test_separation(self):
        same = np.array([True, True, False, False])
        self.assertEqual(separation(np.array([0.0, 1.0, 2.0, 3.0]), same), 1.0)
        self.assertEqual(separation(np.array([0.0, 2.0, 1.0, 3.0]), same), 0.75)
        self.assertEqual(separation(np.array([1.0, 1.0, 1.0, 1.0]), same), 0.5)

    def test_spread_over_the_list(self):
        scans = [Scan(str(i), Path(str(i))) for i in range(10)]
        self.assertEqual([scan.name for scan in spread(scans, 4)], ["0", "2", "5", "7"])
        self.assertEqual(spread(scans, None), scans)
        self.assertLess(natural("office_2"), natural("office_10"))

    def test_best_of_a_peer(self):
        def done(name, *runs):
            scan = Scan(name, Path(name))
            curve = {"curve": [[4, 0.8], [5, 0.8], [6, 0.9]]}
            figures = [{"method": "peer", "settings": {"k": k}, "parts": parts, "purity": purity,
                        "own_purity": purity / 2, "peak_bytes": 10**6} for k, parts, purity in runs]
            figures.append({"method": "peer", "settings": {"k": 9}, "failure": "on purpose"})
            result = {"instances": 5, "comparable": [4, 6], "runs": figures}
            return [(Item(scan, "curve", {"tree": 10, "start": 0}), curve),
                    (Item(scan, "peers", {"method": "peer"}), result)]
        # CID is purer by -0.05, 0.2 and by 0.4, 0.1; of seven parts nothing is said.
        comparison = Comparison([*done("a", (0, 5, 0.85), (1, 6, 0.7), (2, 7, 1.0)),
                                 *done("b", (0, 5, 0.4), (1, 6, 0.8), (2, 4, 0.8))], 10)
        picked, one = comparison.summary_rows()
        self.assertAlmostEqual(picked["purity"], (0.85 + 0.8) / 2)
        self.assertAlmostEqual(picked["CID"], (0.8 + 0.8) / 2)
        self.assertEqual((one["setting"], one["scans"]), ("k 1", 2))
        self.assertAlmostEqual(one["purity"], (0.7 + 0.8) / 2)
        self.assertAlmostEqual(one["CID"], 0.9)
        tally = comparison.tally_rows()[0]
        self.assertEqual((tally["runs"], tally["failed"], tally["compared"]), (8, 2, 5))
        self.assertEqual(tally["CID purer"], 3)
        self.assertEqual(tally["CID purer than its own purity"], 5)
        self.assertEqual(tally["scans where CID is purer than the best"], "0 of 2")

    def test_class_table_is_part_of_a_scan(self):
        with tempfile.TemporaryDirectory() as name:
            scan = Scan("a", Path(name) / "scans" / "a", is_scannet=True)
            scan.path.mkdir(parents=True)
            (scan.path / "a_vh_clean_2.ply").write_text("")
            seen = [scan.fingerprint()]
            for place in (Path(name), scan.path.parent, scan.path):
                for text in ("old", "newer"):
                    (place / "scannetv2-labels.combined.tsv").write_text(text)
                    self.assertNotIn(scan.fingerprint(), seen)
                    seen.append(scan.fingerprint())

    def test_names_are_part_of_a_scan(self):
        with tempfile.TemporaryDirectory() as name:
            scan = Scan("room", Path(name))
            (scan.path / "Annotations").mkdir()
            chair = scan.path / "Annotations" / "chair_1.txt"
            chair.write_text("0 0 0 0 0 0\n")
            before = scan.fingerprint()
            self.assertEqual(scan.fingerprint(), before)
            chair.rename(chair.with_name("table_1.txt"))
            self.assertNotEqual(scan.fingerprint(), before)

    def test_color_is_looked_for_in_the_header(self):
        with tempfile.TemporaryDirectory() as name:
            for i, (header, expected) in enumerate((
                    ("FIELDS x y z rgba\nDATA ascii\n", True),
                    ("FIELDS x y z\nDATA ascii\n1 2 3 rgb\n", False),
                    ("ply\nproperty uchar red\nend_header\n", True),
                    ("ply\nproperty float x\nend_header\nred\n", False))):
                path = Path(name) / str(i)
                path.write_text(header)
                scan = Scan("office/1", path)
                self.assertEqual(has_color(scan), expected)
                self.assertEqual("color" in settings_of(scan), expected)
                self.assertEqual("color" in settings_of(scan)["all"], expected)
                self.assertEqual(place_of(scan), "office")
            self.assertTrue(has_color(Scan("room", Path(name))))
            self.assertFalse(has_color(Scan("gone", Path(name) / "gone.pcd")))

    def test_auto_is_compared_with_the_better(self):
        def runs(*scores):
            return [(Item(Scan(f"kind/{i}", Path()), "", {}),
                     {"mean_iou": score, "truth_instances": 2 - i,
                      "density": {"weighted": i == 1, "spread": 1.5 + i}})
                    for i, score in enumerate(scores)]

        # With twice the weight of the second scan, the first; auto is on for the second.
        both, first, second = Raw.checks("kind", {
            "paper": runs(0.8, 0.3), "density on": runs(0.8 + 2 * TOLERANCE, 0.9),
            "defaults": runs(1, 1)})
        self.assertAlmostEqual(both["mean IoU off"], (2 * 0.8 + 0.3) / 3)
        self.assertAlmostEqual(both["mean IoU auto"], (2 * 0.8 + 0.9) / 3)
        self.assertAlmostEqual(both["less than the better"], 4 / 3 * TOLERANCE)
        self.assertEqual([row["kept"] for row in (both, first, second)], ["NO", "NO", "yes"])
        self.assertEqual((both["spread"], second["spread"]), ("1.50 to 2.50", "2.50 to 2.50"))
        self.assertEqual([row["on in"] for row in (both, first, second)], [1, 0, 1])

    def test_broken_results_are_seen(self):
        with tempfile.TemporaryDirectory() as name:
            path = Path(name) / "result.json"
            for broken in (b"", b"[]", b"{}", b"null", b"\xff", b'{"result": {}}',
                           b'{"result": 1, "remarks": []}'):
                path.write_bytes(broken)
                with self.assertRaisesRegex(ValueError, "result.json: is broken"):
                    read_result(path)


if __name__ == "__main__":
    unittest.main()
