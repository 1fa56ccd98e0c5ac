/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Which points are drawn, and where: shared by the picture and the picking, so that they agree.
 */

/** What the section leaves. */
export const SECTION = /* glsl */ `
uniform vec3 boxLow;
uniform vec3 boxHigh;
uniform vec4 ceiling;        // up, height

bool isCutAway(vec3 at) {
  return any(lessThan(at, boxLow)) || any(greaterThan(at, boxHigh)) || dot(at, ceiling.xyz) > ceiling.w;
}
`;

/** An entry of a texture of lookup_texture.ts; what is beyond it is like the last. */
export const LOOKUP = /* glsl */ `
vec4 entryOf(sampler2D table, uint entry) {
  ivec2 size = textureSize(table, 0);
  int last = size.x * size.y - 1;
  int at = min(int(entry), last);
  return texelFetch(table, ivec2(at % size.x, at / size.x), 0);
}
`;

export const DRAWN = /* glsl */ `
precision highp float;
precision highp int;
precision highp sampler2D;

uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
uniform float pointScale;    // pixels of one metre at distance one
uniform float worldSize;     // of a point, in metres
uniform vec2 sizeLimits;     // in pixels
uniform sampler2D instanceColors;
uniform bool hidesLabels;    // instances that are hidden are so in labels mode only

in vec3 position;
in uint label;

${SECTION}
${LOOKUP}
bool place(out float size) {
  size = 0.0;
  gl_PointSize = 0.0;
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
  if (isCutAway(position)) return false;
  if (hidesLabels && entryOf(instanceColors, label).a < 0.5) return false;
  vec4 eye = modelViewMatrix * vec4(position, 1.0);
  gl_Position = projectionMatrix * eye;
  size = clamp(pointScale * worldSize / max(-eye.z, 1e-3), sizeLimits.x, sizeLimits.y);
  gl_PointSize = size;
  return true;
}
`;

/** Large points are discs; small ones may stay squares, which costs less. */
export const DISC = /* glsl */ `
void cutToDisc(float size) {
  if (size > 2.5) {
    vec2 d = gl_PointCoord - 0.5;
    if (dot(d, d) > 0.25) discard;
  }
}
`;
