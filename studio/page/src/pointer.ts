/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The mouse over the cloud: a click is told from a drag, and resting from passing.
 */

import { Emitter } from './emitter';
import type { PointCloudView } from './point_cloud_view';

/** A press that moves farther than this turns the view. */
const CLICK_REACH = 4;
const REST = 80;

export interface Click {
  x: number;
  y: number;
  shift: boolean;
  alt: boolean;
}

interface Events {
  click: Click;
  double: Click;
  /** The cursor rests here. */
  rest: { x: number; y: number };
  /** It moves on, or leaves. */
  move: void;
}

export class Pointer extends Emitter<Events> {
  private down: { x: number; y: number; id: number } | null = null;
  private timer = 0;
  private last: { x: number; y: number } | null = null;

  constructor(private view: PointCloudView) {
    super();
    const { canvas } = view;
    canvas.addEventListener('pointerdown', (event) => {
      this.down = event.button === 0 ? { x: event.offsetX, y: event.offsetY, id: event.pointerId } : null;
      this.leave();
    });
    canvas.addEventListener('pointerup', (event) => {
      const down = this.down;
      this.down = null;
      if (!down || down.id !== event.pointerId) return;
      if (Math.hypot(event.offsetX - down.x, event.offsetY - down.y) > CLICK_REACH) return;
      this.emit('click', this.click(event));
    });
    canvas.addEventListener('dblclick', (event) => this.emit('double', this.click(event)));
    canvas.addEventListener('pointermove', (event) => this.moved(event));
    canvas.addEventListener('pointerleave', () => {
      this.last = null;
      this.leave();
    });
  }

  /** Where keys act: under the mouse, or in the middle when it is not over the cloud. */
  get cursor(): { x: number; y: number } {
    return this.last ?? { x: this.view.size.x / 2, y: this.view.size.y / 2 };
  }

  /** For the keyboard: from now on the middle counts, until the mouse moves. */
  useMiddle(): void {
    this.last = null;
  }

  private click(event: MouseEvent): Click {
    return { x: event.offsetX, y: event.offsetY, shift: event.shiftKey, alt: event.altKey };
  }

  private leave(): void {
    window.clearTimeout(this.timer);
    this.emit('move', undefined);
  }

  private moved(event: PointerEvent): void {
    // A browser may tell of a move when only the page changed below the cursor.
    if (this.last && this.last.x === event.offsetX && this.last.y === event.offsetY) return;
    this.last = { x: event.offsetX, y: event.offsetY };
    if (event.buttons !== 0) return;
    this.leave();
    const at = this.last;
    const rested = (): void => {
      if (this.view.moving) this.timer = window.setTimeout(rested, REST);
      else this.emit('rest', at);
    };
    this.timer = window.setTimeout(rested, REST);
  }
}
