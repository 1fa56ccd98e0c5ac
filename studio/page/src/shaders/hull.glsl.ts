/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The hulls of parts: translucent faces, and edges as lines that are smooth at any width.
 */

import { LOOK } from '../part_table';
import { LOOKUP, SECTION } from './drawn.glsl';

const IS_CHOSEN = /* glsl */ `
bool isChosen() {
  return look == ${LOOK.selected} || look == ${LOOK.second};
}
`;

const HEAD = /* glsl */ `
precision highp float;
precision highp int;
precision highp sampler2D;
uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
uniform sampler2D partColors;
in uint part;
out vec3 at;
flat out vec3 color;
flat out int look;
${LOOKUP}
${IS_CHOSEN}
void lookUp() {
  vec4 entry = entryOf(partColors, part);
  color = entry.rgb;
  look = int(entry.a * 255.0 + 0.5);
}
`;

const FRAGMENT_HEAD = /* glsl */ `
precision highp float;
in vec3 at;
flat in vec3 color;
flat in int look;
out vec4 outColor;
${SECTION}
${IS_CHOSEN}
`;

export const faceVertex = /* glsl */ `
${HEAD}
in vec3 position;
void main() {
  lookUp();
  at = position;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  // A little nearer than the points that lie in the face.
  gl_Position.z -= 0.0008 * gl_Position.w;
}
`;

export const faceFragment = /* glsl */ `
${FRAGMENT_HEAD}
uniform vec3 cameraPosition;
uniform float opacity;
void main() {
  if (isCutAway(at)) discard;
  // Faces that look away from the camera are darker, so that the form is seen.
  vec3 normal = normalize(cross(dFdx(at), dFdy(at)));
  float facing = abs(dot(normal, normalize(cameraPosition - at)));
  outColor = vec4(color * (0.55 + 0.5 * facing), isChosen() ? max(opacity, 0.5) : opacity);
}
`;

/** Each edge is a ribbon of four corners across the picture. */
export const edgeVertex = /* glsl */ `
${HEAD}
in vec2 corner;              // along, across
in vec3 start;
in vec3 end;
uniform vec2 pictureSize;    // in pixels
uniform float lineWidth;     // in pixels
out float across;
flat out float halfWidth;

// What is behind the camera has no place in the picture: the edge ends before it.
vec4 clipped(vec4 from, vec4 to) {
  float near = from.z + from.w;
  if (near >= 0.0) return from;
  return mix(from, to, near / (near - (to.z + to.w)) + 1e-4);
}

void main() {
  lookUp();
  at = mix(start, end, corner.x);
  mat4 toClip = projectionMatrix * modelViewMatrix;
  vec4 a = toClip * vec4(start, 1.0);
  vec4 b = toClip * vec4(end, 1.0);
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
  if (a.z < -a.w && b.z < -b.w) return;
  vec4 p = clipped(a, b);
  vec4 q = clipped(b, a);
  vec2 along = (q.xy / q.w - p.xy / p.w) * pictureSize;
  vec2 normal = normalize(vec2(-along.y, along.x) + 1e-9);
  halfWidth = 0.5 * lineWidth * (isChosen() ? 1.4 : 1.0);
  // One pixel more for the smooth rim.
  across = (halfWidth + 1.0) * corner.y;
  gl_Position = corner.x < 0.5 ? p : q;
  gl_Position.xy += 2.0 * normal * across / pictureSize * gl_Position.w;
  gl_Position.z -= 0.0012 * gl_Position.w;
}
`;

export const edgeFragment = /* glsl */ `
${FRAGMENT_HEAD}
in float across;
flat in float halfWidth;
void main() {
  if (isCutAway(at)) discard;
  float smooth_ = clamp(halfWidth + 0.5 - abs(across), 0.0, 1.0);
  vec3 line = mix(color, vec3(1.0), 0.25);
  if (look == ${LOOK.selected}) line = vec3(1.0, 0.84, 0.36);
  if (look == ${LOOK.second}) line = vec3(0.55, 0.92, 1.0);
  outColor = vec4(line, smooth_ * (isChosen() ? 1.0 : 0.85));
}
`;
