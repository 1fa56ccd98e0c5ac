/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * From where to look at some places so that they are seen and not hidden behind others.
 */

import { PerspectiveCamera, Vector3 } from 'three';
import type { Camera } from './camera';
import type { PointCloudView } from './point_cloud_view';

/** The first places are a thinned scan: enough of it to know what hides what. */
const SCENE_SAMPLE = 24000;
const SUBJECT_SAMPLE = 1200;
const GRID = 56;
const AZIMUTHS = [0, 0.6, -0.6, 1.2, -1.2, 1.9, -1.9, 2.6, -2.6, Math.PI];
const ELEVATIONS = [0.6, 0.25, 1.05, -0.3];

export interface ViewPoint {
  target: Vector3;
  direction: Vector3;
  distance: number;
}

/** The middle of places and the radius around it that holds nine in ten of them. */
export function extent(positions: Float32Array, places: ArrayLike<number>): { center: Vector3; radius: number } {
  const step = Math.max(1, Math.floor(places.length / 4000));
  const some: Vector3[] = [];
  for (let i = 0; i < places.length; i += step) some.push(new Vector3().fromArray(positions, 3 * places[i]));
  const low = some[0].clone();
  const high = some[0].clone();
  for (const p of some) {
    low.min(p);
    high.max(p);
  }
  const center = low.add(high).multiplyScalar(0.5);
  const distances = some.map((p) => p.distanceTo(center)).sort((a, b) => a - b);
  return { center, radius: distances[Math.floor(0.95 * (distances.length - 1))] };
}

export function chooseViewPoint(
  view: PointCloudView,
  camera: Camera,
  places: ArrayLike<number>,
  diagonal: number,
  isDrawn: (place: number) => boolean,
  pull = 1.7,
): ViewPoint {
  const { positions } = view.cloud;
  const { center, radius } = extent(positions, places);
  const distance = camera.distanceFor(Math.max(radius * pull, diagonal * 0.045));
  const subject: number[] = [];
  const step = Math.max(1, Math.floor(places.length / SUBJECT_SAMPLE));
  for (let i = 0; i < places.length; i += step) subject.push(places[i]);
  const scene: number[] = [];
  const mostScene = Math.min(view.arrivedPlaces, SCENE_SAMPLE);
  for (let place = 0; place < mostScene; place++) if (isDrawn(place)) scene.push(place);

  const eye = new PerspectiveCamera(view.camera.fov, view.camera.aspect, view.camera.near, view.camera.far);
  eye.up.copy(view.up);
  let best: ViewPoint | null = null;
  let bestScore = -Infinity;
  for (const turn of AZIMUTHS) {
    for (const elevation of ELEVATIONS) {
      const direction = camera.direction(camera.azimuth + turn, elevation);
      eye.position.copy(center).addScaledVector(direction, distance);
      eye.lookAt(center);
      eye.updateMatrixWorld(true);
      const seen = seenShare(eye, positions, scene, subject, distance);
      // A calm camera is worth something: of views as good, the nearest to the present one.
      const score = seen - 0.07 * Math.abs(turn) - 0.12 * Math.abs(elevation - 0.6);
      if (score > bestScore) {
        bestScore = score;
        best = { target: center, direction, distance };
      }
    }
  }
  return best!;
}

/** The share of the subject that is neither outside the picture nor behind the scene. */
function seenShare(
  eye: PerspectiveCamera,
  positions: Float32Array,
  scene: number[],
  subject: number[],
  distance: number,
): number {
  const nearest = new Float32Array(GRID * GRID).fill(Infinity);
  const m = eye.matrixWorldInverse.elements;
  const py = eye.projectionMatrix.elements[5];
  const px = eye.projectionMatrix.elements[0];
  let cell = -1;
  const depthAt = (place: number): number => {
    const [x, y, z] = [positions[3 * place], positions[3 * place + 1], positions[3 * place + 2]];
    const depth = -(m[2] * x + m[6] * y + m[10] * z + m[14]);
    cell = -1;
    if (depth < eye.near) return depth;
    const u = (px * (m[0] * x + m[4] * y + m[8] * z + m[12])) / depth;
    const v = (py * (m[1] * x + m[5] * y + m[9] * z + m[13])) / depth;
    if (Math.abs(u) >= 1 || Math.abs(v) >= 1) return depth;
    cell = Math.floor(((u + 1) / 2) * GRID) + GRID * Math.floor(((v + 1) / 2) * GRID);
    return depth;
  };
  for (const place of scene) {
    const depth = depthAt(place);
    if (cell >= 0 && depth < nearest[cell]) nearest[cell] = depth;
  }
  const tolerance = 0.06 * distance;
  let seen = 0;
  for (const place of subject) {
    const depth = depthAt(place);
    if (cell >= 0 && depth <= nearest[cell] + tolerance) seen++;
  }
  return seen / subject.length;
}
