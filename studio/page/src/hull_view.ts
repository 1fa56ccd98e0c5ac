/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Draws the hulls of the parts that are kept, in two meshes; another choice of colors sends nothing.
 */

import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  FrontSide,
  GLSL3,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  Mesh,
  RawShaderMaterial,
  Vector2,
  Vector3,
} from 'three';
import type { Ray } from 'three';
import type { Hull } from './hull';
import type { PointCloudView } from './point_cloud_view';
import type { Part } from './protocol';
import type { SectionCut } from './section';
import { edgeFragment, edgeVertex, faceFragment, faceVertex } from './shaders/hull.glsl';

const LINE = 1.4;
/** Points must be seen through the faces, as far as there are any. */
const OPACITY = { withPoints: 0.27, alone: 0.62 };

export interface DrawnHull {
  part: Part;
  hull: Hull;
}

export class HullView {
  shown = true;
  /** Whether the mode has hulls at all. */
  active = false;
  /** What the meshes hold. */
  private drawn: DrawnHull[] = [];
  private faces: Mesh;
  private edges: Mesh;
  private size = { value: new Vector2() };
  private opacity = { value: OPACITY.withPoints };

  constructor(
    private view: PointCloudView,
    private section: SectionCut,
    /** Those that there are now. */
    private list: () => DrawnHull[],
  ) {
    const material = (vertexShader: string, fragmentShader: string, more: object): RawShaderMaterial =>
      new RawShaderMaterial({ glslVersion: GLSL3, vertexShader, fragmentShader, transparent: true, depthWrite: false, ...more });
    this.faces = new Mesh(new BufferGeometry(), material(faceVertex, faceFragment, { uniforms: { ...view.uniforms, opacity: this.opacity }, side: FrontSide }));
    const line = { pictureSize: this.size, lineWidth: { value: LINE * view.pixelRatio } };
    this.edges = new Mesh(new BufferGeometry(), material(edgeVertex, edgeFragment, { uniforms: { ...view.uniforms, ...line }, side: DoubleSide }));
    this.edges.renderOrder = 1;
    for (const mesh of [this.faces, this.edges]) {
      mesh.frustumCulled = false;
      mesh.visible = false;
      view.addOver(mesh);
    }
    this.resize();
    view.on('resized', () => this.resize());
  }

  /** The parts whose hulls are in the picture. */
  get seen(): readonly DrawnHull[] {
    return this.faces.visible ? this.drawn : [];
  }

  private resize(): void {
    this.size.value.copy(this.view.size).multiplyScalar(this.view.pixelRatio);
  }

  show(shown: boolean, active = this.active): void {
    this.shown = shown;
    this.active = active;
    this.refreshVisible();
  }

  refreshVisible(): void {
    this.opacity.value = this.view.pointsShown ? OPACITY.withPoints : OPACITY.alone;
    this.faces.visible = this.edges.visible = this.shown && this.active && this.drawn.length > 0;
    this.view.invalidate();
  }

  /** The list is another one. */
  refresh(): void {
    this.drawn = this.list();
    this.faces.geometry.dispose();
    this.edges.geometry.dispose();
    this.faces.geometry = this.faceGeometry();
    this.edges.geometry = this.edgeGeometry();
    this.refreshVisible();
  }

  private faceGeometry(): BufferGeometry {
    const { drawn } = this;
    const vertices = drawn.reduce((sum, { hull }) => sum + hull.positions.length / 3, 0);
    const corners = drawn.reduce((sum, { hull }) => sum + hull.triangles.length, 0);
    const [positions, parts, index] = [new Float32Array(3 * vertices), new Uint32Array(vertices), new Uint32Array(corners)];
    let [vertex, corner] = [0, 0];
    for (const { part, hull } of drawn) {
      const n = hull.positions.length / 3;
      positions.set(hull.positions, 3 * vertex);
      parts.fill(part.part, vertex, vertex + n);
      for (const one of hull.triangles) index[corner++] = vertex + one;
      vertex += n;
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(positions, 3));
    geometry.setAttribute('part', new BufferAttribute(parts, 1));
    geometry.setIndex(new BufferAttribute(index, 1));
    return geometry;
  }

  private edgeGeometry(): BufferGeometry {
    const total = this.drawn.reduce((sum, { hull }) => sum + hull.edges.length / 6, 0);
    const [starts, ends, parts] = [new Float32Array(3 * total), new Float32Array(3 * total), new Uint32Array(total)];
    let edge = 0;
    for (const { part, hull } of this.drawn) {
      for (let at = 0; at < hull.edges.length; at += 6, edge++) {
        starts.set(hull.edges.subarray(at, at + 3), 3 * edge);
        ends.set(hull.edges.subarray(at + 3, at + 6), 3 * edge);
        parts[edge] = part.part;
      }
    }
    const geometry = new InstancedBufferGeometry();
    geometry.instanceCount = total;
    geometry.setAttribute('corner', new BufferAttribute(new Float32Array([0, -1, 0, 1, 1, -1, 1, 1]), 2));
    geometry.setIndex([0, 1, 2, 2, 1, 3]);
    geometry.setAttribute('start', new InstancedBufferAttribute(starts, 3));
    geometry.setAttribute('end', new InstancedBufferAttribute(ends, 3));
    geometry.setAttribute('part', new InstancedBufferAttribute(parts, 1));
    return geometry;
  }

  /** The nearest face that is drawn along a ray. */
  hit(ray: Ray): { part: Part; point: Vector3 } | null {
    const [a, b, c, point] = [new Vector3(), new Vector3(), new Vector3(), new Vector3()];
    let best: { part: Part; point: Vector3 } | null = null;
    for (const { part, hull } of this.seen) {
      for (let i = 0; i < hull.triangles.length; i += 3) {
        a.fromArray(hull.positions, 3 * hull.triangles[i]);
        b.fromArray(hull.positions, 3 * hull.triangles[i + 1]);
        c.fromArray(hull.positions, 3 * hull.triangles[i + 2]);
        if (!ray.intersectTriangle(a, b, c, true, point) || !this.section.keepsPoint(point.x, point.y, point.z)) continue;
        if (best && ray.origin.distanceToSquared(point) >= ray.origin.distanceToSquared(best.point)) continue;
        best = { part, point: point.clone() };
      }
    }
    return best;
  }
}
