/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The parts as the server last told them: which group each place is in, and which groups are one part.
 */

import type { Actions } from './actions';
import { Emitter } from './emitter';
import { placesWhere } from './places';
import { NO_GROUP } from './protocol';
import type { Message, Part, PartsSummary } from './protocol';

interface Events {
  /** Whether the groups of the places are others, too. */
  changed: { groups: boolean };
}

export class PartsState extends Emitter<Events> {
  /** The group of each place; groups and parts always belong together here. */
  readonly groupOf: Uint32Array;
  groups = 0;
  decomposition: number | null = null;
  heights: number[] = [];
  list: Part[] = [];
  undo = 0;
  redo = 0;
  /** How many changes were told: an answer counts for the state in which it was asked for only. */
  told = 0;
  private wanted = false;
  private loading = false;
  private byNumber = new Map<number, Part>();
  private byGroup: Part[] = [];

  constructor(
    readonly places: number,
    private actions: Actions,
  ) {
    super();
    this.groupOf = new Uint32Array(places).fill(NO_GROUP);
  }

  get ready(): boolean {
    return this.decomposition !== null;
  }

  /** From now on the parts are followed; after a break of the connection they are asked for again. */
  async load(): Promise<void> {
    this.wanted = true;
    if (this.loading) return;
    this.loading = true;
    await this.actions.insist({ ask: 'parts' });
    this.loading = false;
  }

  reload(): void {
    if (this.wanted) void this.load();
  }

  apply({ header, arrays }: Message): void {
    const summary = header.parts as PartsSummary;
    const groups = arrays.part_groups as Uint32Array | undefined;
    this.told++;
    if (!this.wanted) return;
    if (!groups && summary.decomposition !== this.decomposition) {
      void this.load();
      return;
    }
    if (groups) this.takeGroups(groups);
    this.takeSummary(summary);
    this.emit('changed', { groups: groups !== undefined });
  }

  private takeGroups(groups: Uint32Array): void {
    if (groups.length === 0) this.groupOf.fill(NO_GROUP);
    else this.groupOf.set(groups);
  }

  private takeSummary({ groups, decomposition, heights, list, undo, redo }: PartsSummary): void {
    Object.assign(this, { groups, decomposition, heights, list, undo, redo });
    this.byNumber = new Map(list.map((part) => [part.part, part]));
    this.byGroup = [];
    for (const part of list) for (const group of part.groups) this.byGroup[group] = part;
  }

  part(number: number | null): Part | null {
    return (number !== null && this.byNumber.get(number)) || null;
  }

  /** The part that a place is in. */
  at(place: number): Part | null {
    return this.byGroup[this.groupOf[place]] ?? null;
  }

  placesOf(part: Part): Uint32Array {
    return placesWhere(this.places, (place) => this.at(place) === part);
  }

  /** What it costs to have one part less than `n`, as the tree has them; null where there is one only. */
  costOfMerge(n: number): number | null {
    return this.heights[this.groups - n] ?? null;
  }
}
