/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Finding places.
 */

/** The places below `count` for which `holds`; counted first, as there may be millions. */
export function placesWhere(count: number, holds: (place: number) => boolean): Uint32Array {
  let n = 0;
  for (let place = 0; place < count; place++) if (holds(place)) n++;
  const found = new Uint32Array(n);
  n = 0;
  for (let place = 0; place < count; place++) if (holds(place)) found[n++] = place;
  return found;
}
