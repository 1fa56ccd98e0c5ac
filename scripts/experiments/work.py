# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# Work that is done once: each item's result is a file of its own, which appears whole or
# not at all, so that a run can be killed at any time and goes on where it was.

import fcntl
import json
import os
import shutil
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor, as_completed
from dataclasses import dataclass, field
from pathlib import Path
from typing import Callable

from programs import ProgramError, remarks_in
from scans import Scan


@dataclass(frozen=True)
class Item:
    """Something to do with a scan; the same settings give the same result."""

    scan: Scan
    kind: str
    settings: dict = field(hash=False)
    # (item, programs, folder for temporary files) -> result, a dict
    work: Callable = field(compare=False)
    # Name of the file beside the result that the work leaves in its folder, if any.
    picture: str = ""

    def name(self):
        values = [f"{key}{value}" for key, value in self.settings.items()]
        return "-".join([self.kind, *values])

    def id(self):
        return f"{self.scan.name}: {self.name()}"


class Store:
    """The results in a folder; locked, for two runs would do things twice."""

    def __init__(self, folder, version):
        self.folder = folder
        self.version = version
        self.work_folder = folder / "work"
        self.work_folder.mkdir(parents=True, exist_ok=True)
        self.lock = open(folder / "lock", "w", encoding="utf-8")
        try:
            fcntl.flock(self.lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            raise SystemExit(f"{folder}: another run works in this folder; wait for its end")
        for left_over in self.work_folder.iterdir():
            shutil.rmtree(left_over)

    def path(self, item, suffix=".json"):
        return self.folder / "results" / item.scan.name / (item.name() + suffix)

    def key(self, item):
        """All that the result depends on."""
        return {
            "version": self.version,
            "scan": item.scan.fingerprint(),
            "kind": item.kind,
            "settings": item.settings,
        }

    def result(self, item):
        """That of an earlier run; None when there is none, or the file is broken."""
        try:
            stored = self.stored(item)
            if stored["key"] != self.key(item):
                return None
            if item.picture and not self.path(item, ".png").exists():
                return None
            return stored["result"] if isinstance(stored["result"], dict) else None
        except (OSError, ValueError, LookupError, TypeError):
            return None

    def stored(self, item):
        return json.loads(self.path(item).read_text(encoding="utf-8"))

    def remarks(self, item):
        """What the programs repaired, left out or assumed when they read the scan."""
        return self.stored(item).get("remarks", [])

    def do(self, item, programs):
        """Do it, and keep the result."""
        with tempfile.TemporaryDirectory(dir=self.work_folder) as name:
            folder = Path(name)
            key = self.key(item)
            result = item.work(item, programs, folder)
            self.path(item).parent.mkdir(parents=True, exist_ok=True)
            if item.picture:
                os.replace(folder / item.picture, self.path(item, ".png"))
            new = folder / "result.json"
            stored = {"key": key, "remarks": remarks_in(folder), "result": result}
            new.write_text(json.dumps(stored), encoding="utf-8")
            os.replace(new, self.path(item))
        return result


class Progress:
    """A bar on a terminal, a line for each item elsewhere."""

    WIDTH = 40

    def __init__(self, total, stream=sys.stderr):
        self.total = total
        self.done = 0
        self.stream = stream
        self.is_terminal = stream.isatty()

    def advance(self, text):
        self.done += 1
        if self.is_terminal:
            bar = "#" * (self.WIDTH * self.done // self.total)
            self.stream.write(f"\r[{bar:<{self.WIDTH}}] {self.done}/{self.total} {text}\033[K")
        else:
            self.stream.write(f"{self.done}/{self.total} {text}\n")
        self.stream.flush()

    def end(self):
        if self.is_terminal and self.done:
            self.stream.write("\r\033[K")


def reason(error):
    """For the user; where the text alone may say too little, with the kind of error."""
    if isinstance(error, (ProgramError, ValueError)):
        return str(error)
    return f"{type(error).__name__}: {error}"


def do_all(items, store, programs, jobs):
    """Do what is not done yet. Gives the results, and for each scan that failed, why."""
    results = {item.id(): store.result(item) for item in items}
    missing = [item for item in items if results[item.id()] is None]
    failures = {}
    print(f"{len(items)} items, {len(items) - len(missing)} of them done before", flush=True)
    progress = Progress(len(missing))
    executor = ThreadPoolExecutor(jobs)
    try:
        waiting = {executor.submit(store.do, item, programs): item for item in missing}
        for future in as_completed(waiting):
            item = waiting[future]
            try:
                results[item.id()] = future.result()
                progress.advance(item.id())
            except Exception as error:  # whatever it is, the other items are done
                failures.setdefault(item.scan.name, reason(error))
                progress.advance(item.id() + " FAILED")
    except BaseException:
        programs.stop()
        executor.shutdown(cancel_futures=True)
        raise
    executor.shutdown()
    progress.end()
    done = [(item, results[item.id()]) for item in items
            if item.scan.name not in failures]
    return done, failures
