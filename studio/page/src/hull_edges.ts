/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The lines that show a hull: where two of its faces meet at an angle.
 */

import { BufferAttribute, BufferGeometry, EdgesGeometry } from 'three';

/** Below this, in degrees, two triangles look like one face. */
const FLAT = 14;

export function edgesOf(positions: Float32Array, triangles: Uint32Array): Float32Array {
  const hull = new BufferGeometry();
  hull.setAttribute('position', new BufferAttribute(positions, 3));
  hull.setIndex(new BufferAttribute(triangles, 1));
  return new EdgesGeometry(hull, FLAT).attributes.position.array as Float32Array;
}
