/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A session in memory with the rules of the protocol; groups are nearest seeds in straight lines.
 */

import { PartsWorld } from './parts.mjs';
import { Refused } from './refused.mjs';
import { makeRoom } from './room.mjs';

const NONE = 0xffffffff;

export class World {
  constructor({ places = 60000, questions = 24 } = {}) {
    Object.assign(this, makeRoom(places));
    this.places = places;
    this.parts = new PartsWorld(this.positions);
    this.labels = new Uint32Array(places);
    this.groups = new Uint32Array(places).fill(NONE);
    this.state = { seeds: [], instances: [], painted: new Map() };
    this.past = [];
    this.future = [];
    this.nextKey = 1;
    this.nextLabel = 1;
    this.revision = 0;
    this.propose(questions);
    this.recompute();
  }

  /** Nearest seed of each place; `except` leaves one label out. */
  distances(except) {
    const { positions } = this;
    const seeds = this.state.seeds.filter((seed) => except === undefined || seed.label !== except);
    const best = new Float32Array(this.places).fill(Infinity);
    const which = new Int32Array(this.places).fill(-1);
    seeds.forEach((seed, n) => {
      const [x, y, z] = positions.subarray(3 * seed.place, 3 * seed.place + 3);
      for (let i = 0, at = 0; i < this.places; i++, at += 3) {
        const d = (positions[at] - x) ** 2 + (positions[at + 1] - y) ** 2 + 2 * (positions[at + 2] - z) ** 2;
        if (d < best[i]) {
          best[i] = d;
          which[i] = n;
        }
      }
    });
    return { best, which, seeds };
  }

  recompute() {
    const { which, seeds } = this.distances();
    const changed = [];
    for (const seed of seeds) seed.size = 0;
    const sizes = new Map();
    this.unlabeled = 0;
    for (let i = 0; i < this.places; i++) {
      const seed = seeds[which[i]];
      const group = seed ? seed.key : NONE;
      if (seed) seed.size++;
      const label = this.state.painted.get(i) ?? seed?.label ?? 0;
      if (label === 0) this.unlabeled++;
      else sizes.set(label, (sizes.get(label) ?? 0) + 1);
      if (label !== this.labels[i] || group !== this.groups[i]) changed.push(i);
      this.labels[i] = label;
      this.groups[i] = group;
    }
    for (const one of this.state.instances) one.size = sizes.get(one.label) ?? 0;
    return Uint32Array.from(changed);
  }

  propose(n) {
    // Farthest point first, among a thinned scan.
    const { positions } = this;
    const some = Math.min(this.places, 4000);
    const far = new Float32Array(some).fill(Infinity);
    const reach = (place) => {
      for (let i = 0; i < some; i++) {
        let d = 0;
        for (let k = 0; k < 3; k++) d += (positions[3 * i + k] - positions[3 * place + k]) ** 2;
        far[i] = Math.min(far[i], d);
      }
    };
    for (const seed of this.state.seeds) reach(seed.place);
    for (let i = 0; i < n; i++) {
      const place = this.state.seeds.length ? far.indexOf(Math.max(...far)) : 0;
      this.state.seeds.push({ key: this.nextKey++, place, label: null, size: 0 });
      reach(place);
    }
  }

  labelOf(h) {
    if (h.class !== undefined) {
      const label = this.nextLabel++;
      this.state.instances.push({ label, class: h.class, name: h.name ?? '', size: 0 });
      return label;
    }
    if (h.label !== 0 && !this.state.instances.some((one) => one.label === h.label))
      throw new Refused(`There is no instance ${h.label}.`);
    return h.label;
  }

  instance(label) {
    const one = this.state.instances.find((other) => other.label === label);
    if (!one) throw new Refused(`There is no instance ${label}.`);
    return one;
  }

  /** Takes one change in; answers the places that changed. */
  change(h, arrays) {
    if (h.do === 'undo' || h.do === 'redo') {
      const [from, to] = h.do === 'undo' ? [this.past, this.future] : [this.future, this.past];
      if (from.length === 0) throw new Refused(`There is nothing to ${h.do}.`);
      to.push(structuredClone(this.state));
      this.state = from.pop();
    } else {
      const before = structuredClone(this.state);
      const { state } = this;
      const seed = (key) => {
        const found = state.seeds.find((one) => one.key === key);
        if (!found) throw new Refused(`There is no seed ${key}.`);
        return found;
      };
      if (h.do === 'propose') this.propose(h.seeds);
      else if (h.do === 'answer') seed(h.seed).label = this.labelOf(h);
      else if (h.do === 'click') {
        const label = this.labelOf(h);
        const there = state.seeds.find((one) => one.place === h.place);
        if (there) there.label = label;
        else state.seeds.push({ key: this.nextKey++, place: h.place, label, size: 0 });
      } else if (h.do === 'remove') state.seeds.splice(state.seeds.indexOf(seed(h.seed)), 1);
      else if (h.do === 'paint') {
        const label = h.label === null ? null : this.labelOf(h);
        for (const p of arrays.places) label === null ? state.painted.delete(p) : state.painted.set(p, label);
      } else if (h.do === 'edit') Object.assign(this.instance(h.label), { class: h.class, name: h.name });
      else if (h.do === 'merge' || h.do === 'delete') {
        const gone = this.instance(h.do === 'merge' ? h.from : h.label);
        const into = h.do === 'merge' ? this.instance(h.into).label : null;
        if (into) for (const one of state.seeds) if (one.label === gone.label) one.label = into;
        if (!into) state.seeds = state.seeds.filter((one) => one.label !== gone.label);
        for (const [p, label] of state.painted)
          if (label === gone.label) into ? state.painted.set(p, into) : state.painted.delete(p);
        state.instances = state.instances.filter((one) => one !== gone);
      } else if (h.do === 'settle') state.seeds = state.seeds.filter((one) => one.label !== null);
      else throw new Refused(`The server does not know how to do ${h.do}.`);
      this.past.push(before);
      this.future = [];
    }
    this.revision++;
    return this.recompute();
  }

  changeParts(h) {
    this.parts.change(h);
    this.revision++;
  }

  partsSummary(writer) {
    return { revision: this.revision, writer, parts: this.parts.summary() };
  }

  summary(writer) {
    return {
      revision: this.revision,
      writer,
      seeds: this.state.seeds.map(({ key, place, label, size }) => ({ key, place, label, size })),
      instances: this.state.instances.map((one) => ({ ...one })),
      undo: this.past.length,
      redo: this.future.length,
      unlabeled: this.unlabeled,
    };
  }

  where(test) {
    const found = [];
    for (let i = 0; i < this.places; i++) if (test(i)) found.push(i);
    return Uint32Array.from(found);
  }

  doubt() {
    const out = new Float32Array(this.places).fill(NaN);
    const own = this.distances();
    const labels = [...new Set(this.state.seeds.map((seed) => seed.label))];
    for (const label of labels) {
      const other = this.distances(label);
      for (let i = 0; i < this.places; i++)
        if (own.seeds[own.which[i]].label === label && other.best[i] < Infinity)
          out[i] = Math.sqrt(other.best[i]) - Math.sqrt(own.best[i]);
    }
    return out;
  }

  answer(h) {
    if (h.ask === 'question') {
      const open = this.state.seeds.filter((one) => one.label === null).sort((a, b) => b.size - a.size || a.key - b.key);
      const at = h.after === null ? 0 : open.findIndex((one) => one.key === h.after) + 1;
      const one = open[at];
      if (!one) return [{ question: null, left: open.length }, {}];
      const question = { seed: one.key, place: one.place, size: one.size };
      return [{ question, left: open.length }, { places: this.where((i) => this.groups[i] === one.key) }];
    }
    if (h.ask === 'preview' || h.ask === 'cid') {
      const at = (i, k) => this.positions[3 * i + k];
      const to = (i) => Math.hypot(at(i, 0) - at(h.place, 0), at(i, 1) - at(h.place, 1), 1.4 * (at(i, 2) - at(h.place, 2)));
      if (h.ask === 'cid') return [{}, { cid: Float32Array.from({ length: this.places }, (_, i) => to(i)) }];
      const { best } = this.distances();
      return [{}, { places: this.where((i) => to(i) ** 2 < best[i]) }];
    }
    if (h.ask === 'doubt') return [{}, { doubt: this.doubt() }];
    if (h.ask === 'doubtful') {
      const doubt = this.doubt();
      const low = this.where((i) => doubt[i] < h.below);
      if (low.length === 0 || h.skip > 0) return [{ place: null, size: 0 }, {}];
      const near = low.filter((i) => Math.hypot(...[0, 1, 2].map((k) => this.positions[3 * i + k] - this.positions[3 * low[0] + k])) < 0.4);
      return [{ place: low[0], size: near.length }, { places: near }];
    }
    if (h.ask === 'inspect') {
      const position = [...this.positions.subarray(3 * h.place, 3 * h.place + 3)];
      const seed = this.state.seeds.find((one) => one.place === h.place)?.key ?? null;
      return [{ index: h.place, position, label: this.labels[h.place], seed, painted: this.state.painted.has(h.place) }, {}];
    }
    if (h.ask === 'export') {
      if (h.file === 'fail') throw new Refused('fail.pcd could not be written: there is no space left on the disk.');
      return [{ files: h.format === 'scannet' ? [`${h.file}.txt`, `${h.file}.segs.json`] : [`${h.file}.${h.format}`], remarks: [] }, {}];
    }
    const ofParts = this.parts.answer(h);
    if (ofParts) return ofParts;
    throw new Refused(`The server does not know ${h.ask}.`);
  }
}
