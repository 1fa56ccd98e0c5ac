# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# Readers beside each other and beside a change; changes one after another.

import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import pcl_cid
from conftest import box_points


def test_readers_agree(scan):
    expected = scan.groups.copy(), scan.cid_from(7), scan.merge_tree().heights.copy()

    def read(_):
        return (np.array_equal(scan.groups, expected[0])
                and np.array_equal(scan.cid_from(7), expected[1])
                and np.array_equal(scan.merge_tree().heights, expected[2])
                and len(scan.parts(count=3, merging="cid")) == 3)

    with ThreadPoolExecutor(4) as threads:
        assert all(threads.map(read, range(24)))


def test_changes_come_one_after_another():
    scan = pcl_cid.Scan(box_points())
    indices = np.arange(0, 1600, 100)
    with ThreadPoolExecutor(4) as threads:
        list(threads.map(lambda i: scan.add_seeds([i], labels=[i]), indices))
    assert sorted(scan.seeds) == list(indices)
    assert np.array_equal(scan.seeds, scan.seed_labels)
    with ThreadPoolExecutor(4) as threads:
        list(threads.map(lambda i: scan.remove_seeds([i]), indices[:8]))
    again = pcl_cid.Scan(box_points())
    again.add_seeds(scan.seeds)
    assert np.array_equal(scan.groups, again.groups)


def test_readers_see_whole_states():
    scan = pcl_cid.Scan(box_points())
    scan.add_seeds([0])
    states = {}
    for seeds in ([0], [0, 700]):
        other = pcl_cid.Scan(box_points())
        other.add_seeds(seeds)
        states[len(seeds)] = other.labels().tobytes()
    stop = threading.Event()
    wrong = []

    def look():
        while not stop.is_set():
            if scan.labels().tobytes() not in states.values():
                wrong.append(scan.seeds)

    threads = [threading.Thread(target=look) for _ in range(3)]
    for thread in threads:
        thread.start()
    for _ in range(20):
        scan.add_seeds([700])
        scan.remove_seeds([700])
    stop.set()
    for thread in threads:
        thread.join()
    assert not wrong


def test_the_interpreter_is_free_meanwhile():
    points = np.random.default_rng(0).uniform(0, 1, (100000, 3)).astype(np.float32)
    thread = threading.Thread(target=lambda: pcl_cid.Scan(points).propose(60))
    thread.start()
    longest, last = 0.0, time.perf_counter()
    while thread.is_alive():
        time.sleep(0.001)
        now = time.perf_counter()
        longest, last = max(longest, now - last), now
    assert longest < 1.0


def end_beside(thread, rest=""):
    program = (
        "import atexit, os, threading, time\n"
        "atexit.register(lambda: here() and pcl_cid.Scan(points[:99]).propose(9))  # the last of all\n"
        "here = lambda parent=os.getpid(): os.getpid() == parent\n"
        "import numpy, pcl_cid\n"
        "points = numpy.random.default_rng(0).uniform(0, 10, (100000, 3))\n"
        "scan = pcl_cid.Scan(points)\n"
        f"threading.Thread(target=lambda: {thread}, daemon=True).start()\n"
    )
    done = subprocess.run([sys.executable, "-c", program + rest], capture_output=True, timeout=120)
    assert done.returncode == 0 and not done.stderr


@pytest.mark.parametrize("moment", [0.005, 0.05, 0.2])
@pytest.mark.parametrize(
    "verb", ["scan.propose(100000)", "scan.parts(count=300)", "[scan.propose(20) for _ in range(99)]"]
)
def test_a_daemon_thread_may_be_at_work_when_the_process_ends(verb, moment):
    end_beside(verb, f"time.sleep({moment})\n")


def test_a_child_forked_beside_a_thread_at_work_ends():
    end_beside(
        "scan.propose(100000)",
        "time.sleep(0.05)\n"
        "child = os.fork()\n"
        "assert not child or os.waitpid(child, 0)[1] == 0\n",
    )
