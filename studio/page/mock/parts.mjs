/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Parts in memory with the rules of the protocol: groups are nearest seeds, the tree joins near groups,
 * and hulls are boxes around points.
 */

import { Refused } from './refused.mjs';

const NONE = 0xffffffff;
const BEND = 12;
const NOTHING = { groups: 0, decomposition: 0, groupOf: new Uint32Array(0), heights: [], merges: [], list: [] };

/** What a part is made of: one group, or two nodes. */
const leaf = (group) => ({ groups: [group], height: null, children: null });
const joined = (a, b, height) => ({ groups: [...a.groups, ...b.groups].sort((x, y) => x - y), height, children: [a, b] });
const fresh = (node) => ({ node, dropped: false, exact: false });
const numberOf = ({ node }) => node.groups[0];

export class PartsWorld {
  constructor(positions) {
    this.positions = positions;
    this.places = positions.length / 3;
    this.state = NOTHING;
    this.past = [];
    this.future = [];
    this.decompositions = 0;
    this.isCutting = false;
  }

  knows(what) {
    return ['decompose', 'cut', 'split', 'join', 'drop', 'keep', 'exact', 'undo parts', 'redo parts'].includes(what);
  }

  change(h) {
    if (h.do === 'undo parts') return this.step(this.past, this.future, 'undo');
    if (h.do === 'redo parts') return this.step(this.future, this.past, 'redo');
    const next = this.next(h);
    // Cuts one after another are one step.
    const isCut = h.do === 'cut';
    if (!isCut || !this.isCutting) this.past.push(this.state);
    this.isCutting = isCut;
    this.future = [];
    this.state = next;
  }

  step(from, to, name) {
    if (from.length === 0) throw new Refused(`There is nothing to ${name}.`);
    to.push(this.state);
    this.state = from.pop();
    this.isCutting = false;
  }

  next(h) {
    const { state } = this;
    if (h.do === 'decompose') return this.decompose(h.groups);
    if (state.groups === 0) throw new Refused('There are no parts yet: decompose first.');
    if (h.do === 'cut') return { ...state, list: this.cut(h.parts) };
    const one = this.part(h.part);
    const others = state.list.filter((other) => other !== one);
    const put = (...parts) => ({ ...state, list: [...others, ...parts].sort((a, b) => numberOf(a) - numberOf(b)) });
    if (h.do === 'split') {
      if (!one.node.children) throw new Refused(`Part ${h.part} is one group.`);
      return put(...one.node.children.map((node) => ({ ...fresh(node), dropped: one.dropped })));
    }
    if (h.do === 'join') {
      const two = this.part(h.with);
      if (two === one) throw new Refused('A part cannot be joined with itself.');
      others.splice(others.indexOf(two), 1);
      return put({ ...fresh(joined(one.node, two.node, null)), dropped: one.dropped && two.dropped });
    }
    if (h.do === 'drop') return put({ ...one, dropped: true });
    if (h.do === 'keep') return put({ ...one, dropped: false });
    return put({ ...one, exact: h.exact });
  }

  part(number) {
    const found = this.state.list.find((one) => numberOf(one) === number);
    if (!found) throw new Refused(`There is no part ${number}.`);
    return found;
  }

  at(place) {
    return this.positions.subarray(3 * place, 3 * place + 3);
  }

  decompose(groups) {
    if (!Number.isInteger(groups) || groups < 1 || groups > this.places) throw new Refused(`${groups} groups are not possible here.`);
    const groupOf = this.nearest(this.seeds(groups));
    const centers = Array.from({ length: groups }, () => [0, 0, 0, 0]);
    groupOf.forEach((group, place) => {
      this.at(place).forEach((v, k) => (centers[group][k] += v));
      centers[group][3]++;
    });
    const merges = this.tree(centers.map(([x, y, z, n]) => [x / n, y / n, z / n]));
    const state = { groups, decomposition: ++this.decompositions, groupOf, merges, heights: merges.map((one) => one.height), list: [] };
    state.list = this.cutOf(state, Math.min(groups, BEND)).map(fresh);
    return state;
  }

  /** Farthest point first, among a thinned scan. */
  seeds(n) {
    const some = Math.min(this.places, Math.max(4000, n));
    const far = new Float32Array(some).fill(Infinity);
    const seeds = [];
    for (let next = 0; seeds.length < n; next = far.indexOf(far.reduce((a, b) => Math.max(a, b)))) {
      seeds.push(next);
      for (let i = 0; i < some; i++) far[i] = Math.min(far[i], distance(this.at(i), this.at(next)));
    }
    return seeds;
  }

  nearest(seeds) {
    const groupOf = new Uint32Array(this.places).fill(NONE);
    for (let i = 0; i < this.places; i++) {
      let least = Infinity;
      seeds.forEach((seed, group) => {
        const d = distance(this.at(i), this.at(seed));
        if (d < least) [least, groupOf[i]] = [d, group];
      });
    }
    return groupOf;
  }

  tree(centers) {
    const live = new Map(centers.map((center, group) => [group, center]));
    const merges = [];
    let height = 0;
    while (live.size > 1) {
      let best = null;
      for (const [a, p] of live) for (const [b, q] of live) if (a < b && (!best || distance(p, q) < best.d)) best = { a, b, d: distance(p, q) };
      const [p, q] = [live.get(best.a), live.get(best.b)];
      live.set(best.a, p.map((v, k) => (v + q[k]) / 2));
      live.delete(best.b);
      height = Math.max(height, 0.2 * best.d);
      merges.push({ a: best.a, b: best.b, height });
    }
    return merges;
  }

  cutOf({ groups, merges }, parts) {
    const nodes = new Map(Array.from({ length: groups }, (_, group) => [group, leaf(group)]));
    for (const { a, b, height } of merges.slice(0, groups - parts)) {
      nodes.set(a, joined(nodes.get(a), nodes.get(b), height));
      nodes.delete(b);
    }
    return [...nodes.values()];
  }

  cut(parts) {
    const { state } = this;
    if (!Number.isInteger(parts) || parts < 1 || parts > state.groups) throw new Refused(`${parts} parts are not possible: there are ${state.groups} groups.`);
    const marks = new Map(state.list.map((one) => [one.node.groups.join(), one]));
    return this.cutOf(state, parts).map((node) => ({ ...(marks.get(node.groups.join()) ?? fresh(node)), node }));
  }

  placesOf({ node }) {
    const groups = new Set(node.groups);
    const found = [];
    this.state.groupOf.forEach((group, place) => groups.has(group) && found.push(place));
    return found;
  }

  summary() {
    const { state } = this;
    const sizes = new Uint32Array(state.groups);
    for (const group of state.groupOf) sizes[group]++;
    const list = state.list.map(({ node, dropped, exact }) => ({
      part: node.groups[0],
      groups: node.groups,
      size: node.groups.reduce((sum, group) => sum + sizes[group], 0),
      height: node.height,
      splits: node.children !== null,
      dropped,
      exact,
    }));
    return { groups: state.groups, decomposition: state.decomposition, heights: state.heights, list, undo: this.past.length, redo: this.future.length };
  }

  answer(h) {
    if (h.ask === 'parts') return [{ parts: this.summary() }, { part_groups: this.state.groupOf }];
    if (h.ask === 'hulls') return this.hulls(h.parts.map((number) => this.part(number)));
    if (h.ask === 'tightness') return [{ tightness: h.parts.map((number) => this.tightness(this.part(number))) }, {}];
    if (h.ask === 'export parts') return [this.exported(h), {}];
    return null;
  }

  hulls(parts) {
    const boxes = parts.map((part) => this.box(part));
    const hulls = boxes.map((box, i) => ({
      part: numberOf(parts[i]), vertices: 8, triangles: 12, volume: volumeOf(box), thickness: Math.min(...box.size), thickened: false, boxed: false,
    }));
    const corners = boxes.flatMap(({ low, size }) => [0, 1, 2, 3, 4, 5, 6, 7].flatMap((i) => [0, 1, 2].map((k) => low[k] + ((i >> k) & 1) * size[k])));
    const sides = [0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5];
    return [{ hulls }, { vertices: Float32Array.from(corners), triangles: Uint32Array.from(boxes.flatMap(() => sides)) }];
  }

  /** An exact one holds all points, others are a little smaller. */
  box(part) {
    const margin = part.exact ? 0 : 0.02;
    const low = [Infinity, Infinity, Infinity];
    const high = [-Infinity, -Infinity, -Infinity];
    for (const place of this.placesOf(part)) {
      this.at(place).forEach((v, k) => {
        low[k] = Math.min(low[k], v + margin);
        high[k] = Math.max(high[k], v - margin);
      });
    }
    return { low, size: high.map((v, k) => Math.max(0.01, v - low[k])) };
  }

  tightness(part) {
    const most = 0.02 + 0.09 * Math.log(part.node.groups.length) + 0.002 * (numberOf(part) % 7);
    return { part: numberOf(part), max_concavity: most, mean_concavity: most / 5, free_share: 1 - 1 / (1 + 0.4 * most * part.node.groups.length) };
  }

  exported(h) {
    if (this.state.groups === 0) throw new Refused('There are no parts yet: decompose first.');
    if (h.file === 'fail') throw new Refused('fail.obj could not be written: there is no space left on the disk.');
    const files = [`${h.file}.${h.mesh}`, ...h.scenes.map((scene) => `${h.file}.${scene}`)];
    if (h.labels) files.push(`${h.file}.${h.labels}`);
    if (h.report) files.push(`${h.file}.report.json`);
    return { files, remarks: h.primitives ? ['No part is nearly a sphere.'] : [] };
  }
}

function distance(p, q) {
  return Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

function volumeOf({ size }) {
  return size[0] * size[1] * size[2];
}
