# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# What progress=True shows.


class _Bar:
    def __init__(self, tqdm):
        self._bar = tqdm(total=100, bar_format="{l_bar}{bar}| {elapsed}")

    def __call__(self, fraction):
        self._bar.update(int(100 * fraction) - self._bar.n)

    def close(self):
        self._bar.close()


def open_bar():
    """A bar of tqdm, or None where that is not installed."""
    try:
        from tqdm.auto import tqdm
    except ImportError:
        return None
    return _Bar(tqdm)
