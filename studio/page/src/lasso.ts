/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Drawing a lasso, and what is done with the points in it.
 */

import { Actions } from './actions';
import type { Asking } from './asking';
import type { Camera } from './camera';
import { MARK_GROUP } from './cloud_geometry';
import { count, el, key } from './dom';
import { chooseVisible } from './lasso_choice';
import type { Corner } from './lasso_choice';
import type { Messages } from './messages';
import type { Picking } from './picking';
import type { PointCloudView } from './point_cloud_view';
import type { Session } from './session';

export type Limit = 'all' | 'instance' | 'group';

const LIMITS: [Limit, string][] = [
  ['all', 'All that is seen'],
  ['instance', 'One instance'],
  ['group', 'One group'],
];

export class Lasso {
  on = false;
  limit: Limit = 'all';
  readonly bar = el('section', { class: 'card lasso-bar', 'aria-label': 'Lasso', hidden: true });
  private canvas = el('canvas', { class: 'lasso-canvas', hidden: true, 'aria-hidden': 'true' });
  private path: Corner[] | null = null;
  private takesAway = false;
  /** Told when the lasso is taken up or put down. */
  toggled: (on: boolean) => void = () => {};

  constructor(
    area: HTMLElement,
    private view: PointCloudView,
    private camera: Camera,
    private picking: Picking,
    private actions: Actions,
    private asking: Asking,
    private session: Session,
    private messages: Messages,
    private isDrawn: (place: number) => boolean,
  ) {
    area.append(this.canvas, this.bar);
    this.canvas.addEventListener('pointerdown', (event) => this.start(event));
    this.canvas.addEventListener('pointermove', (event) => this.move(event));
    this.canvas.addEventListener('pointerup', () => this.end());
    this.canvas.addEventListener('pointercancel', () => this.abandon());
    this.canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    this.buildBar();
  }

  private buildBar(): void {
    const group = el('div', { class: 'segments', role: 'group', 'aria-label': 'What the lasso takes' });
    for (const [limit, text] of LIMITS) {
      const press = (): void => {
        this.limit = limit;
        for (const other of group.children) other.setAttribute('aria-pressed', String(other === button));
      };
      const button = el('button', { text, 'aria-pressed': String(limit === this.limit), click: press });
      group.append(button);
    }
    this.bar.append(
      group,
      el('p', { class: 'hint' }, el('span', {}, key('Drag'), 'around points'), el('span', {}, key('Alt+drag'), 'take painted labels away'), el('span', {}, key('L'), 'put it down')),
    );
  }

  toggle(on = !this.on): void {
    if (on && !this.actions.may()) return;
    this.on = on;
    this.abandon();
    this.bar.hidden = this.canvas.hidden = !on;
    this.camera.enabled = !on;
    if (on) this.asking.close();
    this.toggled(on);
  }

  private start(event: PointerEvent): void {
    if (event.button !== 0) return;
    this.asking.cancel();
    this.canvas.setPointerCapture(event.pointerId);
    this.canvas.width = this.view.size.x;
    this.canvas.height = this.view.size.y;
    this.takesAway = event.altKey;
    this.path = [{ x: event.offsetX, y: event.offsetY }];
  }

  private move(event: PointerEvent): void {
    const { path } = this;
    if (!path) return;
    const last = path[path.length - 1];
    if (Math.hypot(event.offsetX - last.x, event.offsetY - last.y) < 2) return;
    path.push({ x: event.offsetX, y: event.offsetY });
    this.draw();
  }

  private draw(): void {
    const context = this.canvas.getContext('2d')!;
    context.clearRect(0, 0, this.canvas.width, this.canvas.height);
    if (!this.path) return;
    context.beginPath();
    for (const { x, y } of this.path) context.lineTo(x, y);
    context.closePath();
    context.fillStyle = this.takesAway ? 'rgb(255 120 90 / 0.12)' : 'rgb(255 216 107 / 0.12)';
    context.fill();
    context.lineWidth = 3.5;
    context.strokeStyle = 'rgb(10 12 16 / 0.7)';
    context.stroke();
    context.lineWidth = 1.5;
    context.strokeStyle = this.takesAway ? '#ff8a6a' : '#ffd86b';
    context.stroke();
  }

  private abandon(): void {
    this.path = null;
    this.draw();
  }

  private end(): void {
    const path = this.path;
    this.abandon();
    if (!path || path.length < 3) return;
    const places = chooseVisible(this.view, path, this.isDrawn, this.allowedFrom(path[0]));
    if (places.length === 0) {
      this.messages.note('No point that is seen is in the lasso.');
      return;
    }
    this.view.cloud.mark(MARK_GROUP, places);
    this.view.invalidate();
    if (this.takesAway) void this.paint(places, { label: null });
    else this.ask(places);
  }

  /** The instance or the group that is under the start of the lasso is the only one it takes from. */
  private allowedFrom(start: Corner): (place: number) => boolean {
    const { labels, groups } = this.session;
    const first = this.limit === 'all' ? null : this.picking.pick(start.x, start.y);
    if (first === null) return () => true;
    if (this.limit === 'instance') return (place) => labels[place] === labels[first];
    return (place) => groups[place] === groups[first];
  }

  private ask(places: Uint32Array): void {
    this.asking.open({
      kind: 'lasso',
      title: 'These points are …',
      context: `${count(places.length)} points`,
      place: places[0],
      beside: false,
      hint: [['Enter', 'same class'], ['Esc', 'leave'], 'The labels stay whatever the seeds say.'],
      answer: (answer) => void this.paint(places, Actions.labelFields(answer)),
      cancel: () => this.clear(),
    });
  }

  private async paint(places: Uint32Array, fields: Record<string, unknown>): Promise<void> {
    await this.actions.change({ do: 'paint', ...fields }, { places });
    this.clear();
  }

  private clear(): void {
    this.view.cloud.mark(MARK_GROUP, new Uint32Array(0));
    this.view.invalidate();
  }
}
