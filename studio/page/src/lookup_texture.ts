/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Colors by number, as textures that shaders look up.
 */

import { DataTexture, NearestFilter, RGBAFormat, UnsignedByteType } from 'three';

export const LOOKUP_WIDTH = 256;

/** Room for 256 entries a row; `entryOf` in drawn.glsl.ts reads them. */
export function lookupTexture(rows: number): DataTexture {
  const data = new Uint8Array(LOOKUP_WIDTH * rows * 4);
  const texture = new DataTexture(data, LOOKUP_WIDTH, rows, RGBAFormat, UnsignedByteType);
  texture.magFilter = texture.minFilter = NearestFilter;
  return texture;
}
