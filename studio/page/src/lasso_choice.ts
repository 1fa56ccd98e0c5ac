/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Which places a drawn polygon chooses: those that are seen in it, and the layer they belong to.
 */

import { NearestFilter, WebGLRenderTarget } from 'three';
import { placeIn } from './picking';
import type { PointCloudView } from './point_cloud_view';

export interface Corner {
  x: number;
  y: number;
}

/**
 * Numbers of places are drawn for the whole picture. A place inside the polygon is chosen where its
 * number is seen, or where it is hardly farther away than what is seen there: otherwise a dense
 * surface would lose the points that share a pixel.
 */
export function chooseVisible(
  view: PointCloudView,
  polygon: Corner[],
  isDrawn: (place: number) => boolean,
  allowed: (place: number) => boolean,
): Uint32Array {
  const { camera, renderer, cloud } = view;
  const [width, height] = [Math.round(view.size.x), Math.round(view.size.y)];
  const target = new WebGLRenderTarget(width, height, { minFilter: NearestFilter, magFilter: NearestFilter });
  renderer.setRenderTarget(target);
  view.drawIds();
  const pixels = new Uint8Array(4 * width * height);
  renderer.readRenderTargetPixels(target, 0, 0, width, height, pixels);
  renderer.setRenderTarget(null);
  target.dispose();

  const inside = polygonMask(polygon, width, height);
  camera.updateMatrixWorld();
  const m = camera.matrixWorldInverse.elements;
  const [px, py] = [camera.projectionMatrix.elements[0], camera.projectionMatrix.elements[5]];
  const { positions } = cloud;
  const depthOf = (place: number): number => {
    const at = 3 * place;
    return -(m[2] * positions[at] + m[6] * positions[at + 1] + m[10] * positions[at + 2] + m[14]);
  };
  const slack = 2 * view.spacing();
  const chosen: number[] = [];
  for (let place = 0; place < view.arrivedPlaces; place++) {
    const depth = depthOf(place);
    if (depth < camera.near) continue;
    const [x, y, z] = [positions[3 * place], positions[3 * place + 1], positions[3 * place + 2]];
    const u = (px * (m[0] * x + m[4] * y + m[8] * z + m[12])) / depth;
    const v = (py * (m[1] * x + m[5] * y + m[9] * z + m[13])) / depth;
    const column = Math.floor(((u + 1) / 2) * width);
    const row = Math.floor(((v + 1) / 2) * height);
    if (column < 0 || row < 0 || column >= width || row >= height) continue;
    if (!inside[(height - 1 - row) * width + column]) continue;
    if (!isDrawn(place) || !allowed(place)) continue;
    const seen = placeIn(pixels, 4 * (row * width + column));
    if (seen === null || depth > depthOf(seen) + slack + 0.004 * depth) continue;
    chosen.push(place);
  }
  return Uint32Array.from(chosen);
}

/** One byte a pixel, rows from the top: whether its middle is inside, by the even-odd rule. */
function polygonMask(polygon: Corner[], width: number, height: number): Uint8Array {
  const mask = new Uint8Array(width * height);
  for (let row = 0; row < height; row++) {
    const y = row + 0.5;
    const crossings: number[] = [];
    for (let i = 0; i < polygon.length; i++) {
      const [a, b] = [polygon[i], polygon[(i + 1) % polygon.length]];
      if (a.y <= y === b.y <= y) continue;
      crossings.push(a.x + ((y - a.y) / (b.y - a.y)) * (b.x - a.x));
    }
    crossings.sort((p, q) => p - q);
    for (let k = 0; k + 1 < crossings.length; k += 2) {
      const from = Math.max(0, Math.round(crossings[k]));
      const to = Math.min(width, Math.round(crossings[k + 1]));
      if (from < to) mask.fill(1, row * width + from, row * width + to);
    }
  }
  return mask;
}
