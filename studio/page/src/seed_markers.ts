/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Seeds as dots with a rim: open questions hollow, answered ones in the color of their label.
 */

import { BufferAttribute, BufferGeometry, GLSL3, Points, RawShaderMaterial } from 'three';
import type { PointCloudView } from './point_cloud_view';
import type { Session } from './session';
import { DRAWN } from './shaders/drawn.glsl';

const vertex = /* glsl */ `
${DRAWN}
in uint open;
uniform float dotSize;
flat out vec3 inside;
void main() {
  float size;
  if (!place(size)) return;
  inside = open != 0u ? vec3(0.08, 0.09, 0.11) : entryOf(instanceColors, label).rgb;
  gl_PointSize = dotSize;
  // A little nearer than its own point, so that it is not lost among neighbours.
  gl_Position.z -= 0.0006 * gl_Position.w;
}
`;

const fragment = /* glsl */ `
precision highp float;
flat in vec3 inside;
out vec4 outColor;
void main() {
  float r = length(gl_PointCoord - 0.5);
  if (r > 0.5) discard;
  outColor = vec4(r > 0.32 ? vec3(1.0) : inside, 1.0);
}
`;

export class SeedMarkers {
  private shown = true;
  private active = true;
  private points: Points;
  private material: RawShaderMaterial;

  constructor(
    private view: PointCloudView,
    private session: Session,
  ) {
    this.material = new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: vertex,
      fragmentShader: fragment,
      uniforms: { ...view.uniforms, dotSize: { value: 9 * view.pixelRatio } },
    });
    this.points = new Points(new BufferGeometry(), this.material);
    this.points.frustumCulled = false;
    view.addToPicture(this.points);
    session.on('changed', () => this.refresh());
  }

  toggle(): void {
    this.shown = !this.shown;
    this.refreshVisible();
  }

  /** Seeds belong to labels only. */
  setActive(active: boolean): void {
    this.active = active;
    this.refreshVisible();
  }

  private refreshVisible(): void {
    this.points.visible = this.shown && this.active;
    this.view.invalidate();
  }

  refresh(): void {
    const seeds = [...this.session.seeds.values()];
    const { positions } = this.view.cloud;
    const at = new Float32Array(3 * seeds.length);
    seeds.forEach((seed, i) => at.set(positions.subarray(3 * seed.place, 3 * seed.place + 3), 3 * i));
    this.points.geometry.dispose();
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(at, 3));
    // What is drawn here is hidden with its instance, as its points are.
    geometry.setAttribute('label', new BufferAttribute(Uint32Array.from(seeds, (seed) => seed.label ?? 0), 1));
    geometry.setAttribute('open', new BufferAttribute(Uint32Array.from(seeds, (seed) => (seed.label === null ? 1 : 0)), 1));
    this.points.geometry = geometry;
    this.view.invalidate();
  }
}
