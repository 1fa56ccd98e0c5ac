/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What a color stands for where it stands for a value.
 */

import { DataTexture, RGBAFormat } from 'three';
import type { Texture } from 'three';
import { el, metres } from './dom';
import { rampCss } from './palette';

export class ColorLegend {
  readonly element = el('div', { class: 'legend', hidden: true });

  hide(): void {
    this.element.hidden = true;
  }

  /** With a ramp, the values at its two ends. */
  show(text: string, ramp: Uint8Array | null, low = 0, high = 0): void {
    this.element.hidden = false;
    this.element.replaceChildren(el('span', { class: 'legend-title', text }));
    if (!ramp) return;
    const bar = el('div', { class: 'legend-bar' });
    bar.style.background = rampCss(ramp);
    this.element.append(bar, el('div', { class: 'legend-ends' }, el('span', { text: metres(low) }), el('span', { text: metres(high) })));
  }
}

const textures = new Map<Uint8Array, Texture>();

/** For shaders. */
export function rampTexture(ramp: Uint8Array): Texture {
  let texture = textures.get(ramp);
  if (!texture) {
    texture = new DataTexture(ramp, 256, 1, RGBAFormat);
    texture.needsUpdate = true;
    textures.set(ramp, texture);
  }
  return texture;
}
