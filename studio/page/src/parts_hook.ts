/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What tests and the curious may read of parts mode: a part of window.studio.
 */

import type { Modes } from './modes';
import type { PartsMode } from './parts_mode';
import type { PartsState } from './parts_state';
import type { Part } from './protocol';
import type { PointCloudView } from './point_cloud_view';

export interface PartsHook {
  workMode(): string;
  parts(): { groups: number; list: Part[]; undo: number; redo: number; selected: number | null; second: number | null };
  /** Numbers of the parts whose hulls are drawn. */
  hulls(): number[];
  /** Low and high corner of a hull that is drawn. */
  hullBox(part: number): { low: number[]; high: number[] } | null;
  /** How many parts have been measured. */
  measured(): number;
  partOf(place: number): number | null;
  /** The part that a click at these pixels of the window selects, and the point of it that is seen there. */
  partAt(x: number, y: number): { part: number | null; point: [number, number, number] } | null;
  decomposing(): boolean;
}

function boxOf(positions: Float32Array): { low: number[]; high: number[] } {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  positions.forEach((value, i) => {
    low[i % 3] = Math.min(low[i % 3], value);
    high[i % 3] = Math.max(high[i % 3], value);
  });
  return { low, high };
}

export function makePartsHook(view: PointCloudView, modes: Modes, parts: PartsState, { hulls, hullStore, partPicking, partsWork }: PartsMode): PartsHook {
  return {
    workMode: () => modes.current,
    parts: () => ({
      groups: parts.groups,
      list: structuredClone(parts.list),
      undo: parts.undo,
      redo: parts.redo,
      selected: partsWork.selected,
      second: partsWork.second,
    }),
    hulls: () => hulls.seen.map(({ part }) => part.part),
    hullBox(number) {
      const found = hulls.seen.find(({ part }) => part.part === number);
      return found ? boxOf(found.hull.positions) : null;
    },
    measured: () => parts.list.filter((part) => hullStore.tightnessOf(part)).length,
    partOf: (place) => parts.at(place)?.part ?? null,
    partAt(x, y) {
      const { left, top } = view.canvas.getBoundingClientRect();
      const hit = partPicking.at(x - left, y - top);
      return hit && { part: hit.part?.part ?? null, point: hit.point.toArray() };
    },
    decomposing: () => partsWork.decomposing,
  };
}
