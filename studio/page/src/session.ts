/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The session as the server last told it: labels, groups, seeds and instances.
 */

import { Emitter } from './emitter';
import { placesWhere } from './places';
import { NO_GROUP } from './protocol';
import type { Header, Instance, Message, Seed } from './protocol';

interface Events {
  /** The places whose label or group changed; null: all. */
  changed: { places: Uint32Array | null };
}

export class Session extends Emitter<Events> {
  labels: Uint32Array;
  groups: Uint32Array;
  seeds = new Map<number, Seed>();
  seedAt = new Map<number, Seed>();
  instances = new Map<number, Instance>();
  revision = 0;
  undo = 0;
  redo = 0;
  unlabeled = 0;
  writer = true;
  ready = false;
  /** How long the last change took here, in milliseconds, without drawing. */
  lastApply = 0;

  constructor(readonly places: number) {
    super();
    this.labels = new Uint32Array(places);
    this.groups = new Uint32Array(places).fill(NO_GROUP);
    this.unlabeled = places;
  }

  get questions(): number {
    let n = 0;
    for (const seed of this.seeds.values()) if (seed.label === null) n++;
    return n;
  }

  apply({ header, arrays }: Message): void {
    const start = performance.now();
    const labels = arrays.labels as Uint32Array | undefined;
    const groups = arrays.groups as Uint32Array | undefined;
    const places = arrays.places as Uint32Array | undefined;
    // Before the first state, a change tells too little.
    if (!this.ready && places) return;
    if (places) {
      for (let i = 0; i < places.length; i++) {
        if (labels) this.labels[places[i]] = labels[i];
        if (groups) this.groups[places[i]] = groups[i];
      }
    } else {
      if (labels) this.labels.set(labels);
      if (groups) this.groups.set(groups);
    }
    this.seeds.clear();
    this.seedAt.clear();
    for (const seed of header.seeds as Seed[]) {
      this.seeds.set(seed.key, seed);
      this.seedAt.set(seed.place, seed);
    }
    this.instances.clear();
    for (const instance of header.instances as Instance[]) {
      this.instances.set(instance.label, instance);
    }
    this.revision = header.revision as number;
    this.writer = header.writer as boolean;
    this.undo = header.undo as number;
    this.redo = header.redo as number;
    this.unlabeled = header.unlabeled as number;
    this.ready = true;
    const nothing = !places && !labels;
    this.emit('changed', { places: nothing ? new Uint32Array(0) : (places ?? null) });
    this.lastApply = performance.now() - start;
  }

  /** Of a change of the parts: the labels are as they were. */
  noteRevision({ revision, writer }: Header): void {
    if (typeof revision === 'number') this.revision = revision;
    if (typeof writer === 'boolean') this.writer = writer;
    this.emit('changed', { places: new Uint32Array(0) });
  }

  nameOf(label: number): string {
    if (label === 0) return 'no label';
    const instance = this.instances.get(label);
    if (!instance) return `instance ${label}`;
    return instance.name || `${instance.class || 'instance'} ${label}`;
  }

  placesOf(label: number): Uint32Array {
    return placesWhere(this.places, (place) => this.labels[place] === label);
  }
}
