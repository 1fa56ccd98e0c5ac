/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What is cut away: the ceiling by height, and all outside a box. The panel and the state behind it.
 */

import { Box3, Vector3 } from 'three';
import { ICONS, el, icon } from './dom';
import { Emitter } from './emitter';
import type { PointCloudView } from './point_cloud_view';

const STEPS = 1000;
const AXES = ['x', 'y', 'z'] as const;

export class SectionCut extends Emitter<{ changed: void }> {
  ceilingOn = false;
  boxOn = false;
  /** The cut steps aside for what it would hide. */
  suspended = false;
  readonly heights: [number, number];
  height: number;
  readonly box: Box3;
  readonly panel = el('section', { class: 'card section-panel', 'aria-label': 'Section', hidden: true });
  private sliders: (() => void)[] = [];

  constructor(
    private view: PointCloudView,
    private bounds: Box3,
  ) {
    super();
    const corners = [0, 1, 2, 3, 4, 5, 6, 7].map((i) =>
      this.heightOf(
        i & 1 ? bounds.max.x : bounds.min.x,
        i & 2 ? bounds.max.y : bounds.min.y,
        i & 4 ? bounds.max.z : bounds.min.z,
      ),
    );
    this.heights = [Math.min(...corners), Math.max(...corners)];
    this.height = this.heights[0] + 0.9 * (this.heights[1] - this.heights[0]);
    this.box = bounds.clone();
    this.buildPanel();
  }

  heightOf(x: number, y: number, z: number): number {
    const { up } = this.view;
    return up.x * x + up.y * y + up.z * z;
  }

  /** How high a place is above the lowest of the scan, metres. */
  heightAt(place: number): number {
    const { positions } = this.view.cloud;
    return this.heightOf(positions[3 * place], positions[3 * place + 1], positions[3 * place + 2]) - this.heights[0];
  }

  get ceilingHeight(): number {
    return this.ceilingOn && !this.suspended ? this.height : 1e9;
  }

  /** Whether the section leaves this place. */
  keeps(place: number): boolean {
    const { positions } = this.view.cloud;
    return this.keepsPoint(positions[3 * place], positions[3 * place + 1], positions[3 * place + 2]);
  }

  keepsPoint(x: number, y: number, z: number): boolean {
    if (this.heightOf(x, y, z) > this.ceilingHeight) return false;
    if (!this.boxOn || this.suspended) return true;
    const { min, max } = this.box;
    return x >= min.x && y >= min.y && z >= min.z && x <= max.x && y <= max.y && z <= max.z;
  }

  apply(): void {
    const far = 1e9;
    const on = this.boxOn && !this.suspended;
    this.view.setSection({
      low: on ? this.box.min : new Vector3(-far, -far, -far),
      high: on ? this.box.max : new Vector3(far, far, far),
      ceiling: this.ceilingHeight,
    });
    for (const update of this.sliders) update();
    this.emit('changed', undefined);
  }

  suspend(value: boolean): void {
    if (this.suspended === value) return;
    this.suspended = value;
    this.apply();
  }

  toggleCeiling(on = !this.ceilingOn): void {
    this.ceilingOn = on;
    this.apply();
  }

  moveCeiling(part: number): void {
    const [low, high] = this.heights;
    this.ceilingOn = true;
    this.height = Math.min(high, Math.max(low, this.height + part * (high - low)));
    this.apply();
  }

  toggleBox(on = !this.boxOn): void {
    this.boxOn = on;
    this.panel.hidden = !on;
    this.apply();
    if (on) this.panel.querySelector('input')?.focus();
  }

  reset(): void {
    this.box.copy(this.bounds);
    this.apply();
  }

  /**
   * Where the top of the scan looks like a ceiling, cuts just below it. A ceiling is many points near
   * the top that cover most of the ground.
   */
  suggestCeiling(places: number): boolean {
    const { positions } = this.view.cloud;
    const n = Math.min(places, 40000);
    const [low, high] = this.heights;
    const bins = new Uint32Array(100);
    const side = 16;
    const ground = new Set<number>();
    const above = new Set<number>();
    const size = this.bounds.getSize(new Vector3());
    const flat = AXES.filter((axis) => Math.abs(this.view.up[axis]) < 0.5).slice(0, 2);
    for (let i = 0; i < n; i++) {
      const p = new Vector3().fromArray(positions, 3 * i);
      const t = (this.heightOf(p.x, p.y, p.z) - low) / (high - low || 1);
      bins[Math.min(99, Math.max(0, Math.floor(100 * t)))]++;
      const [u, v] = flat.map((axis) => Math.floor((side * (p[axis] - this.bounds.min[axis])) / (size[axis] || 1)));
      ground.add(u * 64 + v);
      if (t > 0.82) above.add(u * 64 + v);
    }
    const top = bins.slice(82).reduce((a, b) => a + b, 0);
    if (n < 200 || top < 0.05 * n || above.size < 0.55 * ground.size) return false;
    let peak = 82;
    for (let i = 82; i < 100; i++) if (bins[i] > bins[peak]) peak = i;
    this.height = low + ((peak - 3) / 100) * (high - low);
    this.toggleCeiling(true);
    return true;
  }

  private slider(text: string, limits: [number, number], get: () => number, set: (v: number) => void): HTMLElement {
    const input = el('input', { type: 'range', min: '0', max: String(STEPS), 'aria-label': text });
    const output = el('output', {});
    const [low, high] = limits;
    input.addEventListener('input', () => {
      set(low + (Number(input.value) / STEPS) * (high - low));
      this.apply();
    });
    this.sliders.push(() => {
      input.value = String(Math.round(((get() - low) / (high - low || 1)) * STEPS));
      output.textContent = get().toFixed(2);
      input.setAttribute('aria-valuetext', `${get().toFixed(2)} metres`);
    });
    return el('label', { class: 'slider' }, el('span', { text }), input, output);
  }

  private buildPanel(): void {
    const { min, max } = this.box;
    this.panel.append(
      el(
        'header',
        {},
        el('h2', { text: 'Section box' }),
        el('button', { class: 'small', text: 'Reset', click: () => this.reset() }),
        el('button', { class: 'quiet', 'aria-label': 'Close the section box', click: () => this.toggleBox(false) }, icon(ICONS.close)),
      ),
    );
    for (const axis of AXES) {
      const limits: [number, number] = [this.bounds.min[axis], this.bounds.max[axis]];
      this.panel.append(
        this.slider(`${axis} from`, limits, () => min[axis], (v) => {
          min[axis] = v;
          max[axis] = Math.max(max[axis], v);
        }),
        this.slider(`${axis} to`, limits, () => max[axis], (v) => {
          max[axis] = v;
          min[axis] = Math.min(min[axis], v);
        }),
      );
    }
  }

  /** The slider for the height of the ceiling cut, for the toolbar. */
  ceilingSlider(): HTMLElement {
    return this.slider('Cut at', this.heights, () => this.height, (v) => {
      this.height = v;
      this.ceilingOn = true;
    });
  }
}
