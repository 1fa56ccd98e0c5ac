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
import { spacingOf } from './spacing';

/** The first places are a thinned scan: enough of it to know what hides what. */
const SCENE_SAMPLE = 24000;
const SUBJECT_SAMPLE = 1200;
const GRID = 56;
const AZIMUTHS = [0, 0.6, -0.6, 1.2, -1.2, 1.9, -1.9, 2.6, -2.6, Math.PI];
const ELEVATIONS = [0.6, 0.25, 0.9, 1.2, -0.3];
/** A card at the lower edge: how far the subject moves up for it (of the distance), and what it covers (of half the picture). */
const CARD_SHIFT = 0.13;
const CARD_TOP = -0.38;

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

export interface ViewPointOptions {
  /** How much larger than the subject the picture is. */
  pull?: number;
  /** The lower part of the picture is covered by a card. */
  card?: boolean;
}

export function chooseViewPoint(
  view: PointCloudView,
  camera: Camera,
  places: ArrayLike<number>,
  diagonal: number,
  isDrawn: (place: number) => boolean,
  { pull = 1.7, card = false }: ViewPointOptions = {},
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
  const spacing = spacingOf(positions, mostScene) * Math.sqrt(positions.length / 3 / Math.max(1, mostScene));

  const eye = new PerspectiveCamera(view.camera.fov, view.camera.aspect, view.camera.near, view.camera.far);
  eye.up.copy(view.up);
  const views: { point: ViewPoint; seen: Seen; price: number }[] = [];
  for (const turn of AZIMUTHS) {
    for (const elevation of ELEVATIONS) {
      const direction = camera.direction(camera.azimuth + turn, elevation);
      const target = center.clone();
      if (card) {
        const upInPicture = view.up.clone().addScaledVector(direction, -direction.dot(view.up)).normalize();
        target.addScaledVector(upInPicture, -CARD_SHIFT * distance);
      }
      eye.position.copy(target).addScaledVector(direction, distance);
      eye.lookAt(target);
      eye.updateMatrixWorld(true);
      // A calm camera is worth something: of views as good, the nearest to the present one.
      // From below a floor is seen whole, and nobody knows it again.
      const price = 0.07 * Math.abs(turn) + 0.12 * Math.abs(elevation - 0.6) + (elevation < 0 ? 0.45 : 0);
      const seen = whatIsSeen(eye, positions, scene, subject, { tolerance: 0.06 * distance, spacing, floor: card ? CARD_TOP : -1 });
      views.push({ point: { target, direction, distance }, seen, price });
    }
  }
  // A wall seen along its face is not hidden, and yet nobody sees what it is: size in the picture counts too.
  const most = Math.max(1, ...views.map(({ seen }) => seen.cells));
  const score = ({ seen, price }: (typeof views)[number]): number => seen.share + (0.4 * seen.cells) / most - price;
  return views.reduce((best, one) => (score(one) > score(best) ? one : best)).point;
}

interface Seen {
  /** Of the subject, what is neither outside the picture nor behind the scene. */
  share: number;
  /** Cells of the picture that show some of it. */
  cells: number;
}

function whatIsSeen(
  eye: PerspectiveCamera,
  positions: Float32Array,
  scene: number[],
  subject: number[],
  { tolerance, spacing, floor }: { tolerance: number; spacing: number; floor: number },
): Seen {
  const nearest = new Float32Array(GRID * GRID).fill(Infinity);
  const m = eye.matrixWorldInverse.elements;
  const py = eye.projectionMatrix.elements[5];
  const px = eye.projectionMatrix.elements[0];
  let column = -1;
  let row = -1;
  const depthAt = (place: number): number => {
    const [x, y, z] = [positions[3 * place], positions[3 * place + 1], positions[3 * place + 2]];
    const depth = -(m[2] * x + m[6] * y + m[10] * z + m[14]);
    column = -1;
    if (depth < eye.near) return depth;
    const u = (px * (m[0] * x + m[4] * y + m[8] * z + m[12])) / depth;
    const v = (py * (m[1] * x + m[5] * y + m[9] * z + m[13])) / depth;
    if (Math.abs(u) >= 1 || Math.abs(v) >= 1 || v < floor) return depth;
    column = Math.floor(((u + 1) / 2) * GRID);
    row = Math.floor(((v + 1) / 2) * GRID);
    return depth;
  };
  for (const place of scene) {
    const depth = depthAt(place);
    if (column < 0) continue;
    // The sample is thin: near the eye, one of its places stands for several cells.
    const reach = Math.min(2, Math.round((0.25 * spacing * py * GRID) / depth));
    for (let r = Math.max(0, row - reach); r <= Math.min(GRID - 1, row + reach); r++) {
      for (let c = Math.max(0, column - reach); c <= Math.min(GRID - 1, column + reach); c++) {
        if (depth < nearest[c + GRID * r]) nearest[c + GRID * r] = depth;
      }
    }
  }
  const lit = new Uint8Array(GRID * GRID);
  let seen = 0;
  for (const place of subject) {
    const depth = depthAt(place);
    if (column < 0 || depth > nearest[column + GRID * row] + tolerance) continue;
    seen++;
    lit[column + GRID * row] = 1;
  }
  return { share: seen / subject.length, cells: lit.reduce((sum, one) => sum + one, 0) };
}
