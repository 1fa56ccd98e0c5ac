/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Clicks where the result is wrong: the card at the cursor, the active instance, the preview.
 */

import { Actions } from './actions';
import type { Asking } from './asking';
import { MARK_PREVIEW } from './cloud_geometry';
import { count } from './dom';
import { Emitter } from './emitter';
import type { Messages } from './messages';
import type { PointCloudView } from './point_cloud_view';
import type { Picking } from './picking';
import type { Session } from './session';

const NOTHING = new Uint32Array(0);
/** A seed this many pixels from the cursor is meant. */
const SEED_REACH = 14;

export class Corrections extends Emitter<{ active: number | null; hovering: boolean }> {
  active: number | null = null;
  /** Whether resting the cursor shows what a click would take. */
  previews = true;
  pending = 0;
  private previewed: number | null = null;

  constructor(
    private actions: Actions,
    private asking: Asking,
    private session: Session,
    private view: PointCloudView,
    private picking: Picking,
    private messages: Messages,
  ) {
    super();
    session.on('changed', () => {
      if (this.active !== null && !session.instances.has(this.active)) this.activate(null);
      this.clearPreview();
    });
  }

  activate(label: number | null): void {
    this.active = label;
    this.emit('active', label);
  }

  /** Alt+click: the instance at this place is the one that Shift+click gives to. */
  takeFrom(place: number): void {
    const label = this.session.labels[place];
    if (label === 0) {
      this.messages.note('That point has no label, so there is no instance to take.');
      return;
    }
    this.activate(label);
    this.messages.note(`Shift+click now gives points to ${this.session.nameOf(label)}.`);
  }

  async giveToActive(place: number): Promise<void> {
    if (this.active === null) {
      this.messages.note('No instance is active: Alt+click one, or choose it in the list.');
      return;
    }
    await this.actions.change({ do: 'click', place, label: this.active });
  }

  ask(place: number): void {
    if (!this.actions.may()) return;
    const { session } = this;
    const label = session.labels[place];
    const seed = session.seedAt.get(place);
    const size = session.seeds.get(session.groups[place])?.size;
    const now = label === 0 ? 'No label yet' : `Now ${session.nameOf(label)}`;
    this.asking.open({
      kind: 'point',
      title: seed ? 'This seed is …' : 'This is …',
      context: size === undefined ? now : `${now} · group of ${count(size)} points`,
      place,
      beside: true,
      hint: [['Enter', 'same class'], ['Alt+click', 'an instance'], ['Esc', 'leave']],
      answer: (answer) => void this.actions.change({ do: 'click', place, ...Actions.labelFields(answer) }),
      cancel: () => this.clearPreview(),
    });
    void this.preview(place);
  }

  /** Lights up what a click here would take. */
  async preview(place: number): Promise<void> {
    if (!this.previews || this.previewed === place || !this.session.writer) return;
    this.previewed = place;
    this.pending++;
    const message = await this.actions.ask({ ask: 'preview', place });
    this.pending--;
    if (this.previewed !== place) return;
    this.view.cloud.mark(MARK_PREVIEW, (message?.arrays.places as Uint32Array | undefined) ?? NOTHING);
    this.view.invalidate();
  }

  clearPreview(): void {
    this.previewed = null;
    if (this.view.cloud.marked(MARK_PREVIEW).length === 0) return;
    this.view.cloud.mark(MARK_PREVIEW, NOTHING);
    this.view.invalidate();
  }

  togglePreviews(): void {
    this.previews = !this.previews;
    if (!this.previews) this.clearPreview();
    this.messages.note(this.previews ? 'Preview of clicks is on.' : 'Preview of clicks is off.');
  }

  /** Takes away the seed under the cursor. */
  async removeSeed(x: number, y: number, isDrawn: (place: number) => boolean): Promise<void> {
    const under = this.picking.pick(x, y);
    const depthHere = under === null ? Infinity : this.distance(under);
    let best: number | null = null;
    let least = SEED_REACH;
    for (const seed of this.session.seeds.values()) {
      const at = this.picking.project(seed.place);
      if (!at || !isDrawn(seed.place)) continue;
      const pixels = Math.hypot(at.x - x, at.y - y);
      if (pixels < least && this.distance(seed.place) < 1.03 * depthHere) {
        least = pixels;
        best = seed.key;
      }
    }
    if (best === null) {
      this.messages.note('There is no seed under the cursor.');
      return;
    }
    if (await this.actions.change({ do: 'remove', seed: best })) {
      this.messages.note('The seed is gone. Ctrl+Z brings it back.');
    }
  }

  private distance(place: number): number {
    return this.picking.positionOf(place).distanceTo(this.view.camera.position);
  }
}
