/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The points in the color mode that is chosen.
 */

import { LOOK } from '../part_table';
import { DISC, DRAWN } from './drawn.glsl';

/** Numbers of the uniform `mode`. */
export const MODE = { rgb: 0, height: 1, label: 2, class: 3, group: 4, cid: 5, doubt: 6, part: 7 } as const;

export const cloudVertex = /* glsl */ `
${DRAWN}
in vec4 color;
in uint group;
in float scalar;
in uint mark;

uniform int mode;
uniform bool hasColor;
uniform bool dimmed;         // something is marked: the rest steps back
uniform float pulse;
uniform vec2 range;          // of height or of the measured value
uniform sampler2D classColors;
uniform sampler2D partColors;
uniform sampler2D ramp;

out vec3 shade;
flat out float edge;
flat out float discSize;

vec3 rampAt(float value) {
  float t = clamp((value - range.x) / max(range.y - range.x, 1e-6), 0.0, 1.0);
  return texelFetch(ramp, ivec2(int(t * 255.0 + 0.5), 0), 0).rgb;
}

// Neighbouring keys get far hues: the golden ratio parts a circle evenly for any count.
vec3 groupColor(uint key) {
  if (key == 0xffffffffu) return vec3(0.25);
  float hue = fract(float(key) * 0.61803399) * 6.2831853;
  float light = 0.55 + 0.2 * fract(float(key) * 0.41421356);
  return clamp(light + 0.28 * vec3(cos(hue), cos(hue - 2.094), cos(hue + 2.094)), 0.0, 1.0);
}

bool isLook(float channel, int look) {
  return int(channel * 255.0 + 0.5) == look;
}

void main() {
  float size;
  if (!place(size)) return;
  discSize = size;
  float luminance = hasColor ? dot(color.rgb, vec3(0.3, 0.59, 0.11)) : 0.55;
  // A little of the photograph stays in flat colors, so that things are still recognized.
  vec4 part = vec4(1.0);
  float texture_ = 0.72 + 0.5 * luminance;
  if (mode == ${MODE.rgb}) shade = hasColor ? color.rgb : vec3(0.6);
  else if (mode == ${MODE.height}) shade = rampAt(dot(position, ceiling.xyz));
  else if (mode == ${MODE.label} || mode == ${MODE.class}) {
    shade = mode == ${MODE.label} ? entryOf(instanceColors, label).rgb : entryOf(classColors, label).rgb;
    // Gray that follows the height still shows what has no label yet.
    if (label == 0u && !hasColor) texture_ = 0.6 + 0.8 * dot(rampAt(dot(position, ceiling.xyz)), vec3(0.3, 0.59, 0.11));
    shade *= texture_;
  }
  else if (mode == ${MODE.part}) {
    part = group == 0xffffffffu ? vec4(0.5, 0.5, 0.52, 1.0) : entryOf(partColors, group);
    shade = part.rgb * texture_;
  }
  else if (mode == ${MODE.group}) shade = groupColor(group) * texture_;
  else shade = scalar < 0.0 ? vec3(0.2, 0.22, 0.26) : rampAt(scalar);

  edge = 1.0;
  bool marked = (mark & 1u) != 0u;
  bool preview = (mark & 2u) != 0u;
  if (marked) {
    shade = mix(shade * 1.05, vec3(1.0, 0.85, 0.42), 0.5 + 0.3 * pulse);
    edge = 0.6;
  } else if (preview) {
    shade = mix(shade, vec3(0.62, 0.93, 1.0), 0.55);
    edge = 0.4;
  } else if (isLook(part.a, ${LOOK.selected})) {
    edge = 0.6;
  } else if (isLook(part.a, ${LOOK.second})) {
    edge = 0.4;
  } else if (dimmed) {
    shade *= 0.62;
  }
}
`;

export const cloudFragment = /* glsl */ `
precision highp float;
in vec3 shade;
flat in float edge;
flat in float discSize;
out vec4 outColor;
${DISC}
void main() {
  cutToDisc(discSize);
  outColor = vec4(min(shade, 1.0), edge);
}
`;
