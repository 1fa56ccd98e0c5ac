/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Which place is under the cursor: numbers of places drawn in a small window around it.
 */

import { NearestFilter, Vector3, WebGLRenderTarget } from 'three';
import type { PointCloudView } from './point_cloud_view';

/** Pixels around the cursor that count. */
const WINDOW = 9;
/** More are drawn, for the discs whose middle is outside: a card may drop those. */
const MARGIN = 24;
/** Within each ring the nearest in depth wins; the next ring counts only where the one before is empty. */
const RINGS = [1.5, 3, 4.6];

export class Picking {
  private target: WebGLRenderTarget;
  private point = new Vector3();

  constructor(private view: PointCloudView) {
    const side = WINDOW + 2 * MARGIN;
    this.target = new WebGLRenderTarget(side, side, { minFilter: NearestFilter, magFilter: NearestFilter });
  }

  /** The place at these pixels of the canvas (from its upper left corner), or null. */
  pick(x: number, y: number): number | null {
    const { view, target } = this;
    const side = target.width;
    const ratio = view.pixelRatio;
    const [width, height] = [view.size.x * ratio, view.size.y * ratio];
    const [left, top] = [Math.floor(x * ratio) - (side >> 1), Math.floor(y * ratio) - (side >> 1)];
    view.camera.setViewOffset(width, height, left, top, side, side);
    view.renderer.setRenderTarget(target);
    view.drawIds();
    view.camera.clearViewOffset();
    const pixels = new Uint8Array(4 * WINDOW * WINDOW);
    view.renderer.readRenderTargetPixels(target, MARGIN, MARGIN, WINDOW, WINDOW, pixels);
    view.renderer.setRenderTarget(null);
    return this.nearest(pixels);
  }

  private nearest(pixels: Uint8Array): number | null {
    const middle = WINDOW >> 1;
    let least = 0;
    for (const radius of RINGS) {
      let best: number | null = null;
      for (let i = 0; i < WINDOW * WINDOW; i++) {
        if (Math.hypot((i % WINDOW) - middle, Math.floor(i / WINDOW) - middle) > radius) continue;
        const place = placeIn(pixels, 4 * i);
        if (place === null) continue;
        const depth = this.depthOf(place);
        if (best === null || depth < least) {
          best = place;
          least = depth;
        }
      }
      if (best !== null) return best;
    }
    return null;
  }

  positionOf(place: number): Vector3 {
    return new Vector3().fromArray(this.view.cloud.positions, 3 * place);
  }

  private depthOf(place: number): number {
    this.point.fromArray(this.view.cloud.positions, 3 * place).applyMatrix4(this.view.camera.matrixWorldInverse);
    return -this.point.z;
  }

  /** Where a place is on the canvas; null behind the camera. */
  project(place: number): { x: number; y: number } | null {
    const { camera, size } = this.view;
    if (this.depthOf(place) < camera.near) return null;
    this.point.fromArray(this.view.cloud.positions, 3 * place).project(camera);
    return { x: ((this.point.x + 1) / 2) * size.x, y: ((1 - this.point.y) / 2) * size.y };
  }
}

/** The place whose number these four bytes hold. */
export function placeIn(pixels: Uint8Array, at: number): number | null {
  const n = pixels[at] + 256 * pixels[at + 1] + 65536 * pixels[at + 2] + 16777216 * pixels[at + 3];
  return n === 0 ? null : n - 1;
}
