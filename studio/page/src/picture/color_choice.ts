/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What the colors of the points say: the menu for it.
 */

import { ColorLegend, rampTexture } from '../color_legend';
import { el } from '../dom';
import { CID_RAMP, HEIGHT_RAMP } from '../palette';
import type { PointCloudView } from '../point_cloud_view';
import type { SectionCut } from '../section';
import { MODE } from '../shaders/cloud.glsl';
import type { Kind } from './data';

type Choice = 'rgb' | 'height' | 'label' | 'cid';

const OF_KIND: Record<Kind, [Choice, string]> = {
  labels: ['label', 'Labels'],
  groups: ['label', 'Groups'],
  parts: ['label', 'Parts'],
  values: ['cid', 'CID'],
};

export class ColorChoice {
  readonly select = el('select', { 'aria-label': 'What the colors say', title: 'What the colors say (V)' });
  readonly legend = new ColorLegend();
  private choices: [Choice, string][];

  /** `measured`: what the values are, and the largest one. */
  constructor(
    private view: PointCloudView,
    private section: SectionCut,
    kind: Kind,
    hasColor: boolean,
    private measured: { text: string; most: number },
  ) {
    this.choices = [OF_KIND[kind], ['height', 'Height']];
    if (hasColor) this.choices.push(['rgb', 'Photo colors']);
    this.select.append(...this.choices.map(([value, text]) => el('option', { value, text })));
    this.select.addEventListener('change', () => {
      this.set(this.current);
      this.select.blur();
    });
    this.set(this.current);
  }

  get current(): Choice {
    return this.select.value as Choice;
  }

  next(): void {
    this.select.selectedIndex = (this.select.selectedIndex + 1) % this.choices.length;
    this.set(this.current);
  }

  private set(choice: Choice): void {
    const { uniforms } = this.view;
    const { text, most } = this.measured;
    uniforms.mode.value = MODE[choice];
    this.legend.hide();
    if (choice === 'cid') this.measure(text, CID_RAMP, 0, most);
    // In the other modes, too: gray that follows the height shows what has no label.
    else this.measure(choice === 'height' ? 'Height' : null, HEIGHT_RAMP, ...this.section.heights);
    this.view.invalidate();
  }

  private measure(text: string | null, ramp: Uint8Array, low: number, high: number): void {
    const { uniforms } = this.view;
    uniforms.ramp.value = rampTexture(ramp);
    uniforms.range.value.set(low, high);
    if (text !== null) this.legend.show(text, ramp, low, high);
  }
}
