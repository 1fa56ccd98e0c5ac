# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# Long work: what it tells, and how it ends before its time.

import os
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import pcl_cid
from conftest import box_points


def test_fractions_never_fall(points):
    fractions = []
    scan = pcl_cid.Scan(points, progress=fractions.append)
    scan.propose(50, progress=fractions.append)
    assert fractions and all(0.0 <= fraction <= 1.0 for fraction in fractions)


def test_false_cancels_and_nothing_changes(scan):
    before = scan.groups
    with pytest.raises(pcl_cid.CIDCancelled, match="cancelled by the progress callback"):
        scan.propose(100, progress=lambda fraction: False)
    assert np.array_equal(scan.groups, before) and len(scan.seeds) == 8
    scan.propose(9)
    assert len(scan.seeds) == 9


def test_other_answers_go_on(scan):
    for answer in (None, True, 0, ""):
        scan.merge_tree(progress=lambda fraction: answer)


@pytest.mark.parametrize("verb", [
    lambda scan, stop: scan.propose(60, progress=stop),
    lambda scan, stop: scan.parts(count=5, progress=stop),
    lambda scan, stop: scan.parts(threshold=0.1, progress=stop),
    lambda scan, stop: scan.cid_from(3, progress=stop),
    lambda scan, stop: scan.labels(clean_up=True, progress=stop),
    lambda scan, stop: pcl_cid.group_cid(scan, box_points(40), box_points(40), progress=stop),
    lambda scan, stop: pcl_cid.point_cid(scan, [0, 0, 0], box_points(500), progress=stop),
])
def test_what_a_callback_raises_reaches_the_caller(scan, verb):
    def stop(fraction):
        raise LookupError("enough")

    with pytest.raises(LookupError, match="enough"):
        verb(scan, stop)


def test_bar(points, capfd):
    pytest.importorskip("tqdm")
    pcl_cid.Scan(points, progress=True).propose(20, progress=True)
    assert "%" in capfd.readouterr().err


@pytest.mark.parametrize("progress", [1, "bar", 0.5, [print]])
def test_no_callable(points, progress):
    with pytest.raises(TypeError, match="progress is .*; it must be True, None or a callable"):
        pcl_cid.Scan(points, progress=progress)


def test_a_callback_reads_but_does_not_change(scan):
    seen = []

    def look(fraction):
        seen.append((len(scan.seeds), len(scan.labels())))
        with pytest.raises(pcl_cid.CIDError, match="from the progress callback"):
            scan.propose(200)

    scan.propose(40, progress=look)
    assert seen and all(state == (8, 2000) for state in seen)
    assert len(scan.seeds) == 40


INTERRUPTED = """
import numpy, signal, sys, time
import pcl_cid
signal.signal(signal.SIGINT, signal.default_int_handler)  # ignored in jobs of the background
end = time.time() + 60
points = numpy.random.default_rng(0).uniform(0, 10, (150000, 3)).astype("f4")
points[:, 2] *= numpy.sin(points[:, 0])
verb = sys.argv[1]
if verb != "Scan":
    scan = pcl_cid.Scan(points)
    scan.propose(4)
print("begun", flush=True)
try:
    if verb == "Scan":
        while time.time() < end:
            pcl_cid.Scan(points)
    elif verb == "propose":
        scan.propose(100000)
    elif verb == "parts":
        scan.parts(count=500)
    elif verb == "labels":
        while time.time() < end:
            scan.labels(clean_up=True)
    elif verb == "group_cid":
        pcl_cid.group_cid(scan, points[:20000], points[20000:40000])
    print("not interrupted", flush=True)
except KeyboardInterrupt:
    print(time.time(), flush=True)
"""


def seconds_to_stop(verb):
    """From Ctrl-C to the exception, without any progress=."""
    process = subprocess.Popen([sys.executable, "-c", INTERRUPTED, verb],
                               stdout=subprocess.PIPE, text=True)
    assert process.stdout.readline() == "begun\n"
    time.sleep(1.0)
    sent = time.time()
    os.kill(process.pid, signal.SIGINT)
    line = process.stdout.readline()
    process.wait()
    return float(line) - sent


@pytest.mark.parametrize("verb", ["Scan", "propose", "parts", "labels", "group_cid"])
def test_ctrl_c(verb):
    # 0.2 s on a machine of one's own; what other tests take beside it comes on top.
    limit = 0.2 * max(1.0, os.getloadavg()[0] / os.cpu_count())
    seconds = seconds_to_stop(verb)
    if seconds >= limit:  # once more: something else may have come between
        seconds = seconds_to_stop(verb)
    print(f"{verb}: {seconds:.3f} s")
    assert seconds < limit


def test_signal_handlers_run_on_the_main_thread_only(scan):
    failed = []

    def work():
        try:
            pcl_cid.Scan(box_points()).propose(30)
        except BaseException as error:
            failed.append(error)

    thread = threading.Thread(target=work)
    thread.start()
    thread.join()
    assert not failed
