/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The points on the graphics card: attributes by place, of which only what changed is sent.
 */

import { BufferAttribute, BufferGeometry, DynamicDrawUsage, IntType } from 'three';
import type { WorkMode } from './modes';
import type { PartsState } from './parts_state';
import type { Session } from './session';

/** Changed values are sent in whole blocks: places are in random order, so a change is spread widely. */
const BLOCK = 2048;

export const MARK_GROUP = 1;
export const MARK_PREVIEW = 2;

export class CloudGeometry {
  readonly geometry = new BufferGeometry();
  readonly positions: Float32Array;
  readonly colors: Uint8Array;
  readonly scalars: Float32Array;
  readonly marks: Uint8Array;
  private markedPlaces: Uint32Array[] = [new Uint32Array(0), new Uint32Array(0)];
  private groupsOf: Record<WorkMode, BufferAttribute>;
  private attributes: Record<'position' | 'color' | 'label' | 'group' | 'scalar' | 'mark', BufferAttribute>;

  constructor(
    readonly places: number,
    hasColor: boolean,
    session: Pick<Session, 'labels' | 'groups'>,
    parts: Pick<PartsState, 'groupOf'>,
  ) {
    this.groupsOf = { labels: new BufferAttribute(session.groups, 1), parts: new BufferAttribute(parts.groupOf, 1) };
    this.positions = new Float32Array(3 * places);
    this.colors = new Uint8Array(hasColor ? 4 * places : 4);
    this.scalars = new Float32Array(places).fill(-1);
    this.marks = new Uint8Array(places);
    const mark = new BufferAttribute(this.marks, 1);
    (mark as BufferAttribute & { gpuType: number }).gpuType = IntType;
    this.attributes = {
      position: new BufferAttribute(this.positions, 3),
      color: new BufferAttribute(this.colors, 4, true),
      label: new BufferAttribute(session.labels, 1),
      group: this.groupsOf.labels,
      scalar: new BufferAttribute(this.scalars, 1),
      mark,
    };
    for (const [name, attribute] of Object.entries(this.attributes)) {
      attribute.setUsage(DynamicDrawUsage);
      if (name !== 'color' || hasColor) this.geometry.setAttribute(name, attribute);
    }
    this.geometry.setDrawRange(0, 0);
  }

  /** Positions or colors from place to place came. */
  arrived(name: 'position' | 'color', from: number, to: number): void {
    const attribute = this.attributes[name];
    attribute.addUpdateRange(from * attribute.itemSize, (to - from) * attribute.itemSize);
    attribute.needsUpdate = true;
  }

  /** Labels and groups of these places changed; null: of all. */
  labelsChanged(places: Uint32Array | null): void {
    this.send(this.attributes.label, places);
    this.send(this.groupsOf.labels, places);
  }

  partGroupsChanged(): void {
    this.send(this.groupsOf.parts, null);
  }

  /** Each mode has its own groups: those of seeds, or those that parts are made of. */
  showGroups(of: WorkMode): void {
    this.groupsOf[of].setUsage(DynamicDrawUsage);
    this.geometry.setAttribute('group', this.groupsOf[of]);
  }

  setScalars(values: Float32Array): void {
    for (let i = 0; i < this.scalars.length; i++) {
      const value = values[i];
      // Below zero stands for "unknown": shaders need not know what not-a-number is.
      this.scalars[i] = value >= 0 ? value : -1;
    }
    this.send(this.attributes.scalar, null);
  }

  mark(bit: typeof MARK_GROUP | typeof MARK_PREVIEW, places: Uint32Array): void {
    const before = this.markedPlaces[bit - 1];
    if (before.length === 0 && places.length === 0) return;
    for (const place of before) this.marks[place] &= ~bit;
    for (const place of places) this.marks[place] |= bit;
    this.markedPlaces[bit - 1] = places;
    if (before.length + places.length > this.places / 4) {
      this.send(this.attributes.mark, null);
    } else {
      this.send(this.attributes.mark, before);
      this.send(this.attributes.mark, places);
    }
  }

  marked(bit: typeof MARK_GROUP | typeof MARK_PREVIEW): Uint32Array {
    return this.markedPlaces[bit - 1];
  }

  private send(attribute: BufferAttribute, places: Uint32Array | null): void {
    if (places !== null) {
      if (places.length === 0) return;
      const blocks = new Uint8Array(Math.ceil(attribute.count / BLOCK));
      for (const place of places) blocks[(place / BLOCK) | 0] = 1;
      for (let from = 0; from < blocks.length; from++) {
        if (!blocks[from]) continue;
        let to = from + 1;
        while (to < blocks.length && blocks[to]) to++;
        attribute.addUpdateRange(from * BLOCK, Math.min(to * BLOCK, attribute.count) - from * BLOCK);
        from = to;
      }
    } else {
      attribute.clearUpdateRanges();
      attribute.addUpdateRange(0, attribute.count);
    }
    attribute.needsUpdate = true;
  }
}
