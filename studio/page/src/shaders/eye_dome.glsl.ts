/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Shading from depth alone after Boucheny 2009, and the outline of what is marked.
 */

export const screenVertex = /* glsl */ `
in vec3 position;
void main() {
  gl_Position = vec4(position.xy, 0.0, 1.0);
}
`;

export const eyeDomeFragment = /* glsl */ `
precision highp float;
precision highp sampler2D;

uniform sampler2D picture;
uniform sampler2D depth;
uniform vec2 nearFar;
uniform float strength;      // 0: no shading
uniform float radius;        // in pixels
uniform bool plain;          // the picture as it is: for slow machines while the camera moves
uniform vec3 background;

out vec4 outColor;

float logDistance(ivec2 at) {
  float d = texelFetch(depth, at, 0).r;
  if (d >= 1.0) return 0.0;
  float z = 2.0 * d - 1.0;
  float eye = 2.0 * nearFar.x * nearFar.y / (nearFar.y + nearFar.x - z * (nearFar.y - nearFar.x));
  return log2(eye) + 20.0;
}

void main() {
  ivec2 size = textureSize(picture, 0);
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 here = texelFetch(picture, at, 0);
  float own = logDistance(at);
  // What is drawn over the points is hidden by them.
  gl_FragDepth = texelFetch(depth, at, 0).r;
  vec3 below = background * (1.0 - 0.35 * distance(gl_FragCoord.xy / vec2(size), vec2(0.5, 0.55)));
  vec3 color = own == 0.0 ? below : here.rgb;
  if (plain) {
    outColor = vec4(color, 1.0);
    return;
  }
  float sum = 0.0;
  float outline = 0.0;
  bool unmarked = own == 0.0 || here.a > 0.9;
  for (int i = 0; i < 8; i++) {
    float angle = 0.7853982 * float(i);
    ivec2 near_ = clamp(at + ivec2(round(radius * vec2(cos(angle), sin(angle)))), ivec2(0), size - 1);
    float other = logDistance(near_);
    if (other > 0.0) {
      if (own > 0.0) sum += max(0.0, own - other);
      if (unmarked) outline = max(outline, 1.0 - texelFetch(picture, near_, 0).a);
    }
  }
  // A step of a hundredth of the distance shows; a wall seen at an angle stays bright.
  color *= exp(-strength * min(sum / 8.0, 0.05) * 60.0);
  if (unmarked && outline > 0.1) {
    color = outline > 0.5 ? vec3(0.55, 0.92, 1.0) : vec3(1.0, 0.84, 0.36);
  }
  outColor = vec4(color, 1.0);
}
`;
