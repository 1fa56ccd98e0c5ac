#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# Reads what the writers of datasets wrote, as other people's tools do, and prints it as
# JSON for the tests.

import json
import pathlib
import re
import sys
import urllib.parse
import warnings

import numpy as np

warnings.filterwarnings("ignore", message=".*input contained no data.*")


def s3dis(room):
    room = pathlib.Path(room)
    path = room / (room.name + ".txt")
    known = set(path.read_text().splitlines())
    instances = []
    for annotation in sorted((room / "Annotations").glob("*.txt")):
        if not known.issuperset(annotation.read_text().splitlines()):
            sys.exit(f"{annotation}: holds a line that {path} does not")
        name, number = annotation.stem.split("_")
        instances.append({"class": urllib.parse.unquote_plus(name), "number": int(number),
                          "points": np.loadtxt(annotation, ndmin=2).tolist()})
    return {"points": np.loadtxt(path, ndmin=2).tolist(), "instances": instances}


# Another opinion, where it is installed.
def compare_with_pyyaml(path, labels, instances):
    try:
        import yaml
    except ImportError:
        return
    again = yaml.safe_load(pathlib.Path(path).read_text())
    if again["labels"] != {int(number): name for number, name in labels.items()}:
        sys.exit(f"{path}: PyYAML reads other labels")
    rows = {str(number): [row["class"], row["label"], row["name"]]
            for number, row in again["instances"].items()}
    if rows != instances:
        sys.exit(f"{path}: PyYAML reads other instances")


def kitti(label_file):
    words = np.fromfile(label_file, dtype="<u4")
    text = re.sub(r"\.label$", ".classes.yaml", label_file)
    labels, instances, rows = {}, {}, None
    for line in pathlib.Path(text).read_text().splitlines():
        if row := re.fullmatch(r"  (\d+): (.*)", line):
            rows[row[1]] = row[2]
        else:
            rows = {"labels:": labels, "instances:": instances}.get(line)
    labels = {number: json.loads(name) for number, name in labels.items()}
    shape = re.compile(r"\{class: (\d+), label: (\d+), name: (.*)\}")
    found = {}
    for number, row in instances.items():
        row = shape.fullmatch(row)
        found[number] = [int(row[1]), int(row[2]), json.loads(row[3])]
    if len(found) < 100:  # PyYAML is slow
        compare_with_pyyaml(text, labels, found)
    return {"class": (words & 0xFFFF).tolist(), "instance": (words >> 16).tolist(),
            "labels": labels, "instances": found}


# As load_scannet_data.py of VoteNet, which follows ScanNet's own scripts.
def scannet(folder, scan_id):
    folder = pathlib.Path(folder)
    segments_file = scan_id + "_vh_clean_2.0.010000.segs.json"
    segments = json.loads((folder / segments_file).read_text())
    aggregation = json.loads((folder / (scan_id + ".aggregation.json")).read_text())
    if aggregation["segmentsFile"] != "scannet." + segments_file:
        sys.exit("the aggregation is of other segments")
    of_vertex = np.array(segments["segIndices"], dtype=int)
    instance = np.zeros(len(of_vertex), dtype=int)
    classes = []
    for place, group in enumerate(aggregation["segGroups"]):
        if group["id"] != place or group["objectId"] != place:
            sys.exit("object ids must count from 0")
        own = np.isin(of_vertex, group["segments"])
        if instance[own].any() or not own.any():
            sys.exit("each segment must be of one group, which has vertices")
        instance[own] = group["objectId"] + 1
        classes.append(group["label"])
    return {"segment": of_vertex.tolist(), "instance": instance.tolist(),
            "classes": classes}


if __name__ == "__main__":
    readers = {"s3dis": s3dis, "kitti": kitti, "scannet": scannet}
    print(json.dumps(readers[sys.argv[1]](*sys.argv[2:])))
