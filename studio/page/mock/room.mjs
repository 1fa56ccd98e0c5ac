/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A small room for development and tests: what a scanner might see, made from boxes.
 */

/** The same numbers, 0 to 1, each time. */
export function randomNumbers(seed) {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

/** Boxes as [name, low, high, color]; only the room itself is seen from inside. */
function things() {
  const list = [];
  const box = (name, x, y, z, w, d, h, color) =>
    list.push({ name, low: [x, y, z], high: [x + w, y + d, z + h], color });
  const legs = (name, x, y, w, d, h, t, color) => {
    for (const [i, j] of [[0, 0], [1, 0], [0, 1], [1, 1]])
      box(name, x + i * (w - t), y + j * (d - t), 0, t, t, h, color);
  };
  box('table', 2.2, 1.6, 0.7, 1.8, 0.9, 0.05, [150, 104, 64]);
  legs('table', 2.25, 1.65, 1.7, 0.8, 0.7, 0.06, [130, 90, 56]);
  const chair = (x, y, back, color) => {
    box('chair', x, y, 0.43, 0.45, 0.45, 0.05, color);
    legs('chair', x, y, 0.45, 0.45, 0.43, 0.04, [70, 70, 74]);
    box('chair', x, back, 0.48, 0.45, 0.04, 0.45, color);
  };
  chair(2.3, 0.95, 0.95, [60, 96, 140]);
  chair(3.2, 0.9, 0.9, [60, 96, 140]);
  chair(2.4, 2.7, 3.11, [164, 72, 60]);
  chair(3.3, 2.75, 3.16, [60, 96, 140]);
  box('cabinet', 0.05, 3.1, 0, 0.5, 0.85, 1.9, [196, 190, 178]);
  box('box', 5.2, 3.2, 0, 0.5, 0.5, 0.4, [188, 150, 96]);
  box('box', 5.25, 3.25, 0.4, 0.38, 0.38, 0.3, [176, 138, 88]);
  box('box', 4.4, 3.4, 0, 0.4, 0.35, 0.35, [196, 158, 104]);
  box('monitor', 2.9, 1.75, 0.86, 0.55, 0.04, 0.33, [30, 32, 36]);
  box('sofa', 0.1, 0.6, 0, 0.85, 1.7, 0.42, [92, 116, 96]);
  box('sofa', 0.1, 0.6, 0.42, 0.25, 1.7, 0.4, [86, 108, 90]);
  box('picture', 2, 3.97, 1.4, 0.9, 0.03, 0.6, [72, 112, 164]);
  return list;
}

/** The sides of a box as [corner, edge, edge, area]. */
function sides({ low, high }) {
  const size = high.map((v, i) => v - low[i]);
  const out = [];
  for (let axis = 0; axis < 3; axis++) {
    const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
    for (const at of [low[axis], high[axis]]) out.push({ axis, at, u, v, low, size, area: size[u] * size[v] });
  }
  return out;
}

export function makeRoom(places, seed = 7) {
  const rnd = randomNumbers(seed);
  const room = { low: [0, 0, 0], high: [6, 4, 2.7] };
  const surfaces = [];
  sides(room).forEach((side, i) => {
    const color = [[214, 208, 198], [206, 202, 196], [210, 206, 190], [218, 212, 202], [142, 120, 98], [236, 236, 232]][i];
    surfaces.push({ ...side, color, weight: side.area * 0.6 });
  });
  for (const thing of things()) {
    for (const side of sides(thing)) {
      if (side.axis === 2 && side.at === 0) continue;
      surfaces.push({ ...side, color: thing.color, weight: side.area * 1.5 });
    }
  }
  const total = surfaces.reduce((sum, s) => sum + s.weight, 0);
  const sums = [];
  surfaces.reduce((sum, s) => (sums.push(sum + s.weight), sum + s.weight), 0);
  const positions = new Float32Array(3 * places);
  const colors = new Uint8Array(3 * places);
  const noise = () => (rnd() + rnd() + rnd() - 1.5) * 0.006;
  for (let i = 0; i < places; i++) {
    const r = rnd() * total;
    let [from, to] = [0, sums.length - 1];
    while (from < to) {
      const middle = (from + to) >> 1;
      if (sums[middle] < r) from = middle + 1;
      else to = middle;
    }
    const s = surfaces[from];
    const p = [0, 0, 0];
    p[s.axis] = s.at + noise();
    p[s.u] = s.low[s.u] + rnd() * s.size[s.u];
    p[s.v] = s.low[s.v] + rnd() * s.size[s.v];
    positions.set([p[0] - 3, p[1] - 2, p[2]], 3 * i);
    const plank = s.axis === 2 && s.at === 0 ? 0.9 + 0.2 * (Math.floor(p[1] / 0.16) % 2) : 1;
    const light = plank * (0.82 + 0.1 * (p[2] / 2.7) + 0.08 * rnd()) * (s.axis === 0 ? 0.92 : 1);
    colors.set(s.color.map((c) => Math.min(255, c * light)), 3 * i);
  }
  return { positions, colors };
}
