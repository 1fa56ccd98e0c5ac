/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * How far apart neighbouring points are, which gives the size they are drawn with.
 */

const SIDE = 64;

/**
 * From the share of cells of a coarse grid that hold points: surfaces cover so many cells, and all
 * places share them evenly. That is rough, and right within a factor of two, which is enough here.
 */
export function spacingOf(positions: Float32Array, places: number): number {
  const n = Math.min(places, 60000);
  if (n === 0) return 0.01;
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < 3 * n; i++) {
    low[i % 3] = Math.min(low[i % 3], positions[i]);
    high[i % 3] = Math.max(high[i % 3], positions[i]);
  }
  const cell = Math.max(high[0] - low[0], high[1] - low[1], high[2] - low[2], 1e-6) / SIDE;
  const cells = new Set<number>();
  for (let i = 0; i < n; i++) {
    const [x, y, z] = [0, 1, 2].map((k) => Math.floor((positions[3 * i + k] - low[k]) / cell));
    cells.add(x + 256 * (y + 256 * z));
  }
  const area = cells.size * cell * cell * 0.8;
  return Math.sqrt(area / (positions.length / 3));
}
