/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Hulls as they come, one after the other in two arrays, and as they are drawn.
 */

import { edgesOf } from './hull_edges';
import type { HullFacts } from './protocol';

export interface Hull {
  facts: HullFacts;
  /** Local, three for each vertex. */
  positions: Float32Array;
  triangles: Uint32Array;
  /** Two ends, three coordinates each, of each edge between faces that are not one plane. */
  edges: Float32Array;
}

export function unpackHulls(facts: HullFacts[], vertices: Float32Array, triangles: Uint32Array): Hull[] {
  let [vertex, triangle] = [0, 0];
  return facts.map((one) => {
    const positions = vertices.slice(3 * vertex, 3 * (vertex += one.vertices));
    const corners = triangles.slice(3 * triangle, 3 * (triangle += one.triangles));
    return { facts: one, positions, triangles: corners, edges: edgesOf(positions, corners) };
  });
}
