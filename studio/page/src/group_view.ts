/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Shows a few places: lit up, from where they are seen, without the cut that would hide them.
 */

import type { Camera } from './camera';
import { MARK_GROUP } from './cloud_geometry';
import type { PointCloudView } from './point_cloud_view';
import type { SectionCut } from './section';
import { chooseViewPoint, type ViewPointOptions } from './view_points';

/** A smaller share than this would not tell what the places are. */
const ENOUGH = 0.35;

export class GroupView {
  constructor(
    private view: PointCloudView,
    private camera: Camera,
    private section: SectionCut,
    private diagonal: number,
    private isDrawn: (place: number) => boolean,
  ) {}

  /** Flies there. Says whether the cut is off for as long as they are shown. */
  show(places: Uint32Array, options: ViewPointOptions, needed?: number): boolean {
    this.section.suspended = false;
    let kept = 0;
    for (const place of places) if (this.section.keeps(place)) kept++;
    const isHidden = kept < ENOUGH * places.length || (needed !== undefined && !this.section.keeps(needed));
    this.section.suspended = isHidden;
    this.section.apply();
    this.view.cloud.mark(MARK_GROUP, places);
    const point = chooseViewPoint(this.view, this.camera, places, this.diagonal, this.isDrawn, options);
    void this.camera.lookFrom(point.target, point.direction, point.distance);
    this.view.pulse();
    return isHidden;
  }

  clear(): void {
    this.view.cloud.mark(MARK_GROUP, new Uint32Array(0));
    this.section.suspend(false);
    this.view.invalidate();
  }
}
