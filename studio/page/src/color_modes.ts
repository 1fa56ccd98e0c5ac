/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What the colors of the points say, the menu for it and the legend.
 */

import type { Actions } from './actions';
import { ColorLegend, rampTexture } from './color_legend';
import { el } from './dom';
import type { WorkMode } from './modes';
import { CID_RAMP, DOUBT_RAMP, HEIGHT_RAMP } from './palette';
import type { PointCloudView } from './point_cloud_view';
import type { SectionCut } from './section';
import type { Session } from './session';
import { MODE } from './shaders/cloud.glsl';

export type ModeName = keyof typeof MODE;

const NAMES: Record<ModeName, string> = {
  rgb: 'Photo colors',
  height: 'Height',
  label: 'Instances',
  class: 'Classes',
  group: 'Groups',
  cid: 'CID from the cursor',
  doubt: 'Doubt',
  part: 'Parts',
};

const OFFERED: Record<WorkMode, ModeName[]> = {
  labels: ['rgb', 'height', 'label', 'class', 'group', 'cid', 'doubt'],
  parts: ['part', 'group', 'rgb', 'height', 'label', 'class'],
};

const RAMPS: Partial<Record<ModeName, Uint8Array>> = { height: HEIGHT_RAMP, cid: CID_RAMP, doubt: DOUBT_RAMP };

function quantile(values: Float32Array, share: number): number {
  const some = values.slice(0, 20000).filter((v) => v >= 0 && v < Infinity).sort();
  return some.length === 0 ? 0 : some[Math.min(some.length - 1, Math.floor(share * some.length))];
}

export class ColorModes {
  mode: ModeName = 'height';
  /** Doubt below this is worth a look, in metres. */
  doubtBelow = 0.01;
  readonly select: HTMLSelectElement;
  readonly legend = new ColorLegend();
  private before: ModeName = 'label';
  /** Nobody has chosen a mode yet. */
  private untouched = true;
  private available: ModeName[] = [];
  private work: WorkMode = 'labels';
  private lastOf: Record<WorkMode, ModeName> = { labels: 'height', parts: 'part' };
  private cidBusy = false;
  private cidNext: number | null = null;
  private cidShown: number | null = null;
  private doubtTimer = 0;
  pending = 0;

  constructor(
    private view: PointCloudView,
    session: Session,
    private section: SectionCut,
    private actions: Actions,
    private hasColor: boolean,
  ) {
    this.select = el('select', { 'aria-label': 'What the colors say', title: 'What the colors say (V)' });
    this.offer('labels');
    this.select.addEventListener('change', () => {
      this.untouched = false;
      this.set(this.select.value as ModeName);
      this.select.blur();
    });
    session.on('changed', () => {
      // Height shows what things are; once some have labels, those are what the person must see.
      if (this.untouched && this.mode === 'height' && session.instances.size > 0) this.set('label');
      if (this.mode === 'doubt') this.askDoubt(250);
      if (this.mode === 'cid' && this.cidShown !== null) this.from(this.cidShown, true);
    });
    this.set(hasColor ? 'rgb' : 'height');
  }

  private offer(work: WorkMode): void {
    this.available = OFFERED[work].filter((mode) => this.hasColor || mode !== 'rgb');
    this.select.replaceChildren(...this.available.map((mode) => el('option', { value: mode, text: NAMES[mode] })));
  }

  /** Other work has other colors; those of before come back with it. */
  workOn(work: WorkMode): void {
    this.lastOf[this.work] = this.mode;
    this.work = work;
    this.offer(work);
    this.set(this.lastOf[work]);
    this.before = work === 'labels' ? 'label' : this.hasColor ? 'rgb' : 'height';
  }

  set(mode: ModeName): void {
    if (mode !== this.mode && this.mode !== 'doubt' && this.mode !== 'cid') this.before = this.mode;
    this.mode = mode;
    this.select.value = mode;
    const { uniforms, cloud } = this.view;
    uniforms.mode.value = MODE[mode];
    const ramp = RAMPS[mode] ?? HEIGHT_RAMP;
    uniforms.ramp.value = rampTexture(ramp);
    this.legend.hide();
    if (mode === 'height') this.showHeight();
    else this.setRange(...this.section.heights);
    this.view.canvas.parentElement?.setAttribute('data-colors', mode);
    if (mode === 'cid') {
      cloud.setScalars(new Float32Array(cloud.places).fill(-1));
      this.cidShown = null;
      this.showLegend('Rest the cursor on a point: CID from there to all others', null);
    }
    if (mode === 'doubt') {
      cloud.setScalars(new Float32Array(cloud.places).fill(-1));
      this.showLegend('Doubt: how much nearer the own label is than the next', null);
      this.askDoubt(0);
    }
    this.view.invalidate();
  }

  step(by: 1 | -1): void {
    this.untouched = false;
    const at = this.available.indexOf(this.mode) + by + this.available.length;
    this.set(this.available[at % this.available.length]);
  }

  toggle(mode: ModeName): void {
    this.untouched = false;
    this.set(this.mode === mode ? this.before : mode);
  }

  get name(): string {
    return NAMES[this.mode];
  }

  /** In the mode CID: measures from this place; the newest wish wins. */
  from(place: number, again = false): void {
    if (this.mode !== 'cid' || (place === this.cidShown && !again)) return;
    if (this.cidBusy) {
      this.cidNext = place;
      return;
    }
    this.cidBusy = true;
    this.pending++;
    void this.actions.ask({ ask: 'cid', place }).then((message) => {
      this.cidBusy = false;
      this.pending--;
      const cid = message?.arrays.cid as Float32Array | undefined;
      if (cid && this.mode === 'cid') {
        this.cidShown = place;
        this.view.cloud.setScalars(cid);
        this.setRange(0, quantile(cid, 0.97) || 1);
        this.showLegend('CID from the cursor', CID_RAMP);
      }
      const next = this.cidNext;
      this.cidNext = null;
      if (next !== null) this.from(next);
    });
  }

  /** Doubt is asked for anew after a change, once changes pause. */
  private askDoubt(wait: number): void {
    window.clearTimeout(this.doubtTimer);
    this.doubtTimer = window.setTimeout(() => void this.loadDoubt(), wait);
  }

  async loadDoubt(): Promise<void> {
    this.pending++;
    const message = await this.actions.ask({ ask: 'doubt' });
    this.pending--;
    const doubt = message?.arrays.doubt as Float32Array | undefined;
    if (!doubt) return;
    this.doubtBelow = Math.max(0.002, quantile(doubt, 0.06));
    if (this.mode !== 'doubt') return;
    this.view.cloud.setScalars(doubt);
    const known = doubt.some((value) => value >= 0);
    this.setRange(0, quantile(doubt, 0.6) || 0.1);
    if (known) this.showLegend('Doubt: unsure where bright', DOUBT_RAMP);
    else this.showLegend('Doubt needs two labels at least', null);
  }

  private showHeight(): void {
    const [low, high] = this.section.heights;
    this.setRange(low, high);
    this.showLegend('Height', HEIGHT_RAMP);
  }

  private setRange(low: number, high: number): void {
    this.view.uniforms.range.value.set(low, high);
    this.view.invalidate();
  }

  private showLegend(text: string, ramp: Uint8Array | null): void {
    const { x, y } = this.view.uniforms.range.value;
    this.legend.show(text, ramp, x, y);
  }
}
