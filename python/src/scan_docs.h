/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The docstrings of Scan.
 */

#pragma once

namespace pcl_cid::python {

inline constexpr const char* scan_doc = R"(A scan made ready for CID, and seeds on it.

The scan is prepared once; seeds come and go at their own cost, and after any sequence of
calls the groups are, to the bit, those of the same seeds in the same order from scratch.
Results are the same for every number of threads.

Any number of threads may read a Scan. Changes (propose, add_seeds, remove_seeds,
label_seeds) come one after another, and readers beside them see the state before or after
one. A change that fails or is cancelled changes nothing. Arrays are read-only.
)";

inline constexpr const char* init_doc = R"(Prepare a scan.

Parameters
----------
points : array_like of shape (N, 3), or Cloud
    float32 or float64, metres; points that are not finite stay in the numbering and
    are in no group. UTM coordinates in float64 keep their millimetres. A Cloud brings
    its sensor and its colors.
colors : array_like of shape (N, 3), optional
    uint8, or floats from 0 to 1; needed where `color` is not 0.
sensor : array_like of shape (3,) or (7,), optional
    Where the sensor was, metres, and its rotation as w, x, y, z; at the origin and
    upright where it is not given, as PCL has it.
paper : bool, default False
    Start from the settings of the paper instead of the defaults.
keep_zeros : bool, default False
    10 points and more exactly at (0, 0, 0), or at the sensor, are points; without it
    they count as what did not return.
progress : bool or callable, optional
    See `propose`.
{settings}

Raises
------
ValueError
    For arrays of a bad shape, dtype or size, no finite point, and settings out of
    their range.
TypeError
    For a keyword that is no setting; the message lists those that are.
CIDCancelled
)";

inline constexpr const char* propose_doc = R"(Propose seeds: Algorithm 1 (CID-FPS).

Goes on from the seeds that there are. New seeds have the labels after the largest one.

Parameters
----------
seeds : int, optional
    How many all in all: {seeds range}. Default {seeds}, or as many as
    `coverage` needs.
coverage : float, optional
    Stop when every point is within this CID of its seed: {coverage range}.
progress : bool or callable, optional
    A callable gets the fraction done, 0 to 1, a few times a second; where it returns
    False the work is cancelled. True shows a bar of tqdm, where that is installed.
    Ctrl-C cancels with or without it.

Returns
-------
{'seeds', 'coverage', 'no_gain'}
    Why it stopped.

Raises
------
ValueError
    For a value out of its range.
CIDCancelled
    When `progress` said so.
KeyboardInterrupt

Notes
-----
Algorithm 1 of Wang et al., RA-L 2023.
)";

inline constexpr const char* add_seeds_doc = R"(Add seeds, after all others.

Parameters
----------
seeds : array_like of int, shape (K,)
    Indices of points, finite and no seeds yet.
labels : array_like of int, shape (K,), optional
    0 to 4294967295; 0 is none. Default: the labels after the largest one.
progress : bool or callable, optional
    See `propose`.

Raises
------
ValueError
    For an index out of range, a point that is a seed already or not finite, and
    another number of labels.
CIDCancelled

Notes
-----
Section IV.A of Wang et al., RA-L 2023. The cost is about that of the points that the
seeds win.
)";

inline constexpr const char* remove_seeds_doc =
    R"(Take seeds away; their points go to those that remain.

Parameters
----------
seeds : array_like of int, shape (K,)
    Points that are seeds, each once.
progress : bool or callable, optional
    See `propose`.

Raises
------
ValueError
    When a point is no seed.
CIDCancelled
)";

inline constexpr const char* label_seeds_doc = R"(Give seeds other labels.

Parameters
----------
seeds : array_like of int, shape (K,)
    Points that are seeds, each once.
labels : array_like of int, shape (K,)
    0 to 4294967295; 0 is none.

Raises
------
ValueError
    When a point is no seed, and for another number of labels.
)";

inline constexpr const char* labels_doc = R"(The label of every point: that of its seed.

Parameters
----------
clean_up : {'off', 'on'} or bool, default 'off'
    Mend ragged boundaries between labels.
progress : bool or callable, optional
    See `propose`.

Returns
-------
ndarray of uint32, shape (N,)
    0 where there is none.

Raises
------
CIDCancelled

Notes
-----
Section IV.A of Wang et al., RA-L 2023; the cleaning is alpha expansion.
)";

inline constexpr const char* groups_doc =
    R"(ndarray of int32, shape (N,): the number of the seed of each point, -1 for a point that
is not finite, and for all without seeds.)";

inline constexpr const char* cids_doc =
    R"(The CID (or cost) of each point to its nearest seed.

Parameters
----------
progress : bool or callable, optional
    See `propose`.

Returns
-------
ndarray of float32, shape (N,)
    Metres; NaN where there is none.

Raises
------
CIDCancelled
)";

inline constexpr const char* cid_from_doc =
    R"(CID from one point to all: the heat map of Fig. 1.

Parameters
----------
index : int
    A point that is finite.
progress : bool or callable, optional
    See `propose`.

Returns
-------
ndarray of float32, shape (N,)
    CID_p by Eq. 2, metres; NaN where a point is not finite.

Raises
------
ValueError
    For an index out of range, and a point that is not finite.
CIDCancelled

Notes
-----
Eq. 2 of Wang et al., RA-L 2023.
)";

inline constexpr const char* merge_tree_doc =
    R"(Merge the groups: Algorithm 2, to the end.

Parameters
----------
group_samples : int, default {group_samples}
    Points drawn from each group: {group_samples range}.
progress : bool or callable, optional
    See `propose`.
groups : {'cid', 'patches'}, default {groups}
    Merge the groups of the seeds, or smooth patches of the surface, which need none.
seeds : int, optional
    The largest number of patches: {seeds range}. Default: {seeds}.

Returns
-------
MergeTree
    The last one is kept: another call for it, and `parts`, do not make it again.

Raises
------
ValueError
    For a setting out of its range, and for `seeds` without patches.
CIDError
    With 'cid' and without seeds.
CIDCancelled

Notes
-----
Algorithm 2 and Eq. 3 of Wang et al., RA-L 2023.
)";

inline constexpr const char* parts_doc = R"(Approximately convex parts, and their hulls.

Parameters
----------
count : int, optional
    So many parts: {parts range}.
error : float, optional
    No hull holds a place farther from the scan than this: {max_error range}.
threshold : float, optional
    Merge while the smallest group CID is at most this: {threshold range}.
merges : int, optional
    Merge groups so many times: {merges range}.
merging : {'hull', 'cid'}, optional
    Parts by the hull that comes out, without regard to the groups, or by the CID of
    the groups. Default: 'hull' with `count`, `error`, `robot_radius` or `viewpoints`,
    and 'cid' with `threshold`, `merges`, `groups`, `seeds` or `group_samples`, or none
    of all. 'cid' with neither count, threshold nor merges cuts where the tree bends.
viewpoints : array_like of shape (K, 3), optional
    Where the scan was taken from, metres: with 'hull', only what was seen from there
    counts as free.
progress : bool or callable, optional
    See `propose`.
{settings}

Returns
-------
list of ConvexPart
    With `error` and `count`, there may be more: the bound comes first.

Raises
------
ValueError
    For settings out of their range, or that do not go together.
TypeError
    For a keyword that is no setting; the message lists those that are.
CIDError
    With 'cid' and neither seeds nor patches, and where nothing is left of the parts.
CIDCancelled

Notes
-----
'cid' is Algorithm 2 of Wang et al., RA-L 2023. `max_vertices` may be 'auto': as few as
the bound on the error allows, or, without one, 1 % of the size of the hull. `seeds` is
the largest number of patches, {seeds} where none is given; those of `propose` are not
concerned.
)";

} // namespace pcl_cid::python
