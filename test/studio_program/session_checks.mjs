/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What must hold of every session, and random actions on one.
 */

import assert from 'node:assert/strict';
import { NO_GROUP, Refused, Replica } from './client.mjs';

/** Numbers alone can be compared quickly. */
function assertSameNumbers(actual, expected, what) {
  assert.equal(actual.length, expected.length, what);
  const size = Buffer.compare(Buffer.from(actual.buffer), Buffer.from(expected.buffer));
  if (size === 0) return;
  const at = actual.findIndex((value, i) => value !== expected[i]);
  assert.fail(`${what} of place ${at}: ${actual[at]} instead of ${expected[at]}`);
}

/** @param {{exact?: boolean}} options whether revisions and steps are compared, too */
export function assertSameSession(actual, expected, { exact = true } = {}) {
  const { labels, groups, ...rest } = actual;
  const { labels: otherLabels, groups: otherGroups, ...otherRest } = expected;
  assertSameNumbers(labels, otherLabels, 'label');
  assertSameNumbers(groups, otherGroups, 'group');
  if (!exact)
    for (const each of [rest, otherRest])
      for (const word of ['revision', 'undo', 'redo']) delete each[word];
  assert.deepEqual(rest, otherRest);
}

function countOf(values) {
  const count = new Map();
  for (const value of values) count.set(value, (count.get(value) ?? 0) + 1);
  return count;
}

/** What the protocol says of a state; painted points may have any label. */
export function assertConsistent(
  { labels, groups, seeds, instances, unlabeled },
  painted = new Set(),
) {
  const known = new Set([0, ...instances.map(({ label }) => label)]);
  assert.equal(
    known.size,
    instances.length + 1,
    'labels of instances are 1 and up, each once',
  );
  const byKey = new Map(seeds.map((seed) => [seed.key, seed]));
  assert.equal(byKey.size, seeds.length, 'keys are there once');
  const groupSize = countOf(groups);
  const labelSize = countOf(labels);
  for (const seed of seeds) {
    assert.equal(seed.key, seed.place, 'the key of a seed is its place');
    assert.equal(groups[seed.place], seed.key, 'a seed is in its own group');
    assert.equal(seed.size, groupSize.get(seed.key), 'size of a group');
    assert.ok(
      seed.label === null || known.has(seed.label),
      'the label of a seed is there',
    );
  }
  for (const instance of instances)
    assert.equal(
      instance.size,
      labelSize.get(instance.label) ?? 0,
      'size of an instance',
    );
  assert.equal(unlabeled, labelSize.get(0) ?? 0, 'places without a label');
  labels.forEach((label, place) => {
    const seed = byKey.get(groups[place]);
    if (groups[place] !== NO_GROUP && !seed)
      assert.fail(`place ${place}: group without a seed`);
    if (!painted.has(place) && label !== (seed?.label ?? 0))
      assert.fail(`place ${place}: label ${label}, its seed says ${seed?.label}`);
    if (!known.has(label)) assert.fail(`place ${place}: label ${label} is no instance`);
  });
}

export async function stateOf(page) {
  return new Replica(await page.ask('state'));
}

/** A sentence that says what is wrong. */
export function assertSentence(text) {
  assert.match(text, /^\S.{8,}\S$/s);
  assert.doesNotMatch(text, /exception|std::|json\.|terminate|assert|\n\n/i);
}

export async function assertRefused(promise, pattern = /./) {
  try {
    await promise;
  } catch (error) {
    if (!(error instanceof Refused)) throw error;
    assertSentence(error.message);
    assert.match(error.message, pattern);
    return error.message;
  }
  return assert.fail('it was not refused');
}

/** Random actions: those of the protocol's table, possible or not. */
export class RandomActions {
  #random;

  constructor(random) {
    this.#random = random;
  }

  #number(below) {
    return Math.floor(this.#random() * below);
  }

  #of(list) {
    return list[this.#number(list.length)];
  }

  /** [word, fields, arrays, whether it is possible] */
  next(replica) {
    const { seeds, instances, undo, redo } = replica.summary;
    const places = replica.labels.length;
    const label = () =>
      instances.length && this.#random() < 0.8 ? this.#of(instances).label : 0;
    const answer = () =>
      this.#random() < 0.35
        ? {
            class: this.#of(['', 'chair', 'Stühle', 'a "b"\\']),
            name: this.#of(['', 'n', '椅子']),
          }
        : { label: label() };
    const somePlaces = () => {
      const first = this.#number(places);
      const list = Uint32Array.from({ length: 1 + this.#number(300) }, () =>
        this.#number(places),
      );
      list[0] = first;
      return { places: list };
    };
    const missing = 1e6 + this.#number(1000);
    const noSeed = () => {
      const keys = new Set(seeds.map(({ key }) => key));
      for (;;) {
        const place = this.#number(places);
        if (!keys.has(place)) return place;
      }
    };
    const possible = {
      propose: () => [{ seeds: 1 + this.#number(3) }],
      answer: () => seeds.length && [{ seed: this.#of(seeds).key, ...answer() }],
      click: () => [{ place: this.#number(places), ...answer() }],
      clickOnSeed: () =>
        seeds.length && [{ place: this.#of(seeds).place, ...answer() }],
      remove: () => seeds.length && [{ seed: this.#of(seeds).key }],
      paint: () => [answer(), somePlaces()],
      unpaint: () => [{ label: null }, somePlaces()],
      edit: () =>
        instances.length && [
          { label: this.#of(instances).label, class: 'k', name: `${this.#number(99)}` },
        ],
      merge: () => {
        if (instances.length < 2) return null;
        const from = this.#of(instances).label;
        const into = this.#of(instances.filter((each) => each.label !== from)).label;
        return [{ from, into }];
      },
      delete: () => instances.length && [{ label: this.#of(instances).label }],
      settle: () => seeds.some((seed) => seed.label === null) && [{}],
      undo: () => undo > 0 && [{}],
      redo: () => redo > 0 && [{}],
    };
    const impossible = {
      propose: () =>
        this.#of([
          { seeds: 0 },
          { seeds: -1 },
          { seeds: 2 ** 32 },
          { seeds: places * 2 },
          { seeds: '3' },
          {},
        ]),
      answer: () =>
        this.#of([
          { seed: noSeed(), label: 0 },
          { seed: 1e9, label: 0 },
          { seed: seeds[0]?.key ?? 0, label: missing },
          { seed: seeds[0]?.key ?? 0 },
          { label: 0 },
        ]),
      click: () =>
        this.#of([
          { place: places, label: 0 },
          { place: 0, label: missing },
          { place: -1, label: 0 },
          { place: 0.5, label: 0 },
          { place: 0, label: 0, class: 'x' },
          { place: 0, class: 7 },
          { place: null, label: 0 },
          { place: 0 },
        ]),
      remove: () => this.#of([{ seed: noSeed() }, { seed: places }, {}]),
      paint: () =>
        this.#of([{ label: 0 }, { label: missing }, { class: 'x', name: 3 }]),
      edit: () =>
        this.#of([
          { label: missing, class: '', name: '' },
          { label: 0, class: '', name: '' },
          { label: 1 },
        ]),
      merge: () =>
        this.#of([
          { from: missing, into: missing },
          { from: 0, into: instances[0]?.label ?? 1 },
          { from: instances[0]?.label ?? 1, into: instances[0]?.label ?? 1 },
          {},
        ]),
      delete: () => this.#of([{ label: missing }, { label: 0 }, {}]),
      dance: () => ({}),
    };
    if (this.#random() < 0.25) {
      const word = this.#of(Object.keys(impossible));
      const fields = impossible[word]();
      const arrays = word === 'paint' && fields.label === missing ? somePlaces() : {};
      if (word === 'paint' && fields.label === 0 && this.#random() < 0.5)
        return [word, fields, { places: Uint32Array.of(places) }, false];
      return [word, fields, arrays, false];
    }
    for (;;) {
      const key = this.#of([...Object.keys(possible), 'click', 'answer', 'undo']);
      const made = possible[key]();
      if (!made) continue;
      const word = { clickOnSeed: 'click', unpaint: 'paint' }[key] ?? key;
      return [word, made[0], made[1] ?? {}, true];
    }
  }
}
