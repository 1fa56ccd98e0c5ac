/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Each point painted with its own number, for picking and the lasso.
 */

import { DISC, DRAWN } from './drawn.glsl';

export const idVertex = /* glsl */ `
${DRAWN}
flat out vec4 id;
flat out float discSize;
void main() {
  float size;
  // Zero is left for "nothing here".
  uint n = uint(gl_VertexID) + 1u;
  id = vec4(n & 255u, (n >> 8) & 255u, (n >> 16) & 255u, n >> 24) / 255.0;
  place(size);
  discSize = size;
}
`;

export const idFragment = /* glsl */ `
precision highp float;
flat in vec4 id;
flat in float discSize;
out vec4 outColor;
${DISC}
void main() {
  cutToDisc(discSize);
  outColor = id;
}
`;
