/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Which part is under the cursor: of points and hulls that are drawn, the nearest.
 */

import { Ray, Raycaster, Vector2 } from 'three';
import type { Vector3 } from 'three';
import type { HullView } from './hull_view';
import type { PartsState } from './parts_state';
import type { Picking } from './picking';
import type { PointCloudView } from './point_cloud_view';
import type { Part } from './protocol';

export interface PartHit {
  point: Vector3;
  /** Null at a point that is in no part. */
  part: Part | null;
}

export class PartPicking {
  private caster = new Raycaster();

  constructor(
    private view: PointCloudView,
    private picking: Picking,
    private hulls: HullView,
    private state: PartsState,
  ) {}

  at(x: number, y: number): PartHit | null {
    const hull = this.hulls.hit(this.rayAt(x, y));
    const place = this.picking.pick(x, y);
    if (place === null) return hull;
    const point = this.picking.positionOf(place);
    const eye = this.view.camera.position;
    if (hull && eye.distanceToSquared(hull.point) < eye.distanceToSquared(point)) return hull;
    return { point, part: this.state.at(place) };
  }

  private rayAt(x: number, y: number): Ray {
    const { size, camera } = this.view;
    camera.updateMatrixWorld();
    this.caster.setFromCamera(new Vector2((2 * x) / size.x - 1, 1 - (2 * y) / size.y), camera);
    return this.caster.ray;
  }
}
