/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The color of each part by its groups, as a texture: another cut of the tree sends nothing per point.
 */

import type { Texture } from 'three';
import { LOOKUP_WIDTH, lookupTexture } from './lookup_texture';
import { COLORS, colorOf } from './palette';
import type { PartsState } from './parts_state';
import type { Part } from './protocol';

/** What the fourth channel says of a part. */
export const LOOK = { second: 120, selected: 180, plain: 255 } as const;

const GRAY: [number, number, number] = [112, 118, 128];

export class PartTable {
  /** By group. */
  texture = lookupTexture(1);
  private numbers = new Map<number, number>();

  constructor(
    private state: PartsState,
    private use: (texture: Texture) => void,
  ) {
    use(this.texture);
  }

  colorOf(part: Part): [number, number, number] {
    return part.dropped ? GRAY : colorOf(this.numbers.get(part.part) ?? 1);
  }

  refresh(selected: Part | null, second: Part | null): void {
    this.chooseNumbers();
    this.makeRoom();
    const data = this.texture.image.data as Uint8Array;
    for (const part of this.state.list) {
      const look = part === selected ? LOOK.selected : part === second ? LOOK.second : LOOK.plain;
      for (const group of part.groups) data.set([...this.colorOf(part), look], 4 * group);
    }
    this.texture.needsUpdate = true;
  }

  /** A part keeps its color while it keeps its number; no color comes twice before all have come once. */
  private chooseNumbers(): void {
    const uses = new Array<number>(COLORS).fill(0);
    const parts = this.state.list.map((one) => one.part).sort((a, b) => a - b);
    const own = (part: number): number => part % COLORS;
    this.numbers.clear();
    const take = (part: number, color: number): void => {
      uses[color]++;
      this.numbers.set(part, color + 1);
    };
    for (const part of parts) if (uses[own(part)] === 0) take(part, own(part));
    for (const part of parts) if (!this.numbers.has(part)) take(part, uses.indexOf(Math.min(...uses)));
  }

  private makeRoom(): void {
    const rows = Math.ceil(Math.max(1, this.state.groups) / LOOKUP_WIDTH);
    if (rows <= this.texture.image.height) return;
    this.texture.dispose();
    this.texture = lookupTexture(2 * rows);
    this.use(this.texture);
  }
}
