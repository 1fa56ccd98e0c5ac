/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Colors of instances and classes, and the ramps for measured values.
 */

// Neighbours in a scan get numbers in no useful order, so any two colors may meet. They are chosen as
// far as possible from all that are there already, in the worst of three kinds of sight: full, and
// without the long- or the middle-wave cones (the projections of Viénot, Brettel and Mollon 1999). As
// hue alone cannot part many colors for those people, lightness varies too; distances are taken
// in Oklab (Ottosson 2020), where equal steps look about equal.

type Triple = [number, number, number];

/** How many different ones there are. */
export const COLORS = 48;

function linear(channel: number): number {
  return channel <= 0.04045 ? channel / 12.92 : ((channel + 0.055) / 1.055) ** 2.4;
}

function encoded(channel: number): number {
  return channel <= 0.0031308 ? channel * 12.92 : 1.055 * channel ** (1 / 2.4) - 0.055;
}

function oklab([r, g, b]: Triple): Triple {
  const l = Math.cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const m = Math.cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const s = Math.cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return [
    0.2104542553 * l + 0.793617785 * m - 0.0040720468 * s,
    1.9779984951 * l - 2.428592205 * m + 0.4505937099 * s,
    0.0259040371 * l + 0.7827717662 * m - 0.808675766 * s,
  ];
}

function fromOklab([L, a, b]: Triple): Triple {
  const l = (L + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (L - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (L - 0.0894841775 * a - 1.291485548 * b) ** 3;
  return [
    4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
    -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
    -0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s,
  ];
}

function protanope([r, g, b]: Triple): Triple {
  const y = 0.11238 * r + 0.88762 * g;
  return [y, y, Math.max(0, 0.00401 * r - 0.00401 * g + b)];
}

function deuteranope([r, g, b]: Triple): Triple {
  const y = 0.29275 * r + 0.70725 * g;
  return [y, y, Math.max(0, -0.02234 * r + 0.02234 * g + b)];
}

const sights = [(c: Triple): Triple => c, protanope, deuteranope];

interface Candidate {
  rgb: Triple;
  seen: Triple[];
}

function candidate(rgb: Triple): Candidate {
  return { rgb, seen: sights.map((sight) => oklab(sight(rgb))) };
}

function distance(a: Candidate, b: Candidate): number {
  let least = Infinity;
  for (let i = 0; i < sights.length; i++) {
    const [p, q] = [a.seen[i], b.seen[i]];
    const d = Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    // What full sight tells apart counts double for those who have it.
    least = Math.min(least, i === 0 ? 0.55 * d : d);
  }
  return least;
}

function chooseColors(): Triple[] {
  const candidates: Candidate[] = [];
  for (let L = 0.52; L < 0.93; L += 0.065) {
    for (const chroma of [0.09, 0.14, 0.19]) {
      for (let hue = 0; hue < 360; hue += 10) {
        const h = (hue * Math.PI) / 180;
        const rgb = fromOklab([L, chroma * Math.cos(h), chroma * Math.sin(h)]);
        if (rgb.every((c) => c >= 0 && c <= 1)) candidates.push(candidate(rgb));
      }
    }
  }
  // Not to be mistaken for: the background, points without label, the light of a selection.
  const taken = [[0.005, 0.006, 0.008], [0.12, 0.15, 0.2], [1, 0.95, 0.8]].map((c) => candidate(c as Triple));
  const first = candidate(fromOklab([0.72, -0.04, -0.13]));
  const chosen = [first];
  const least = candidates.map((c) => Math.min(distance(c, first), ...taken.map((t) => distance(c, t))));
  while (chosen.length < COLORS) {
    let best = 0;
    for (let i = 1; i < least.length; i++) if (least[i] > least[best]) best = i;
    chosen.push(candidates[best]);
    candidates.forEach((c, i) => (least[i] = Math.min(least[i], distance(c, candidates[best]))));
  }
  return chosen.map((c) => c.rgb.map((v) => Math.round(255 * encoded(v))) as Triple);
}

const colors = chooseColors();

/** sRGB, 0 to 255, of an instance (1 and up) or of the n-th class (1 and up). */
export function colorOf(number: number): Triple {
  return colors[(number - 1) % colors.length];
}

export function css([r, g, b]: Triple): string {
  return `rgb(${r} ${g} ${b})`;
}

export const UNLABELED: Triple = [98, 110, 130];

/** 256 colors between stops that grow in lightness, so that the order is seen without hue. */
function ramp(stops: Triple[]): Uint8Array {
  const labs = stops.map((stop) => oklab(stop.map((c) => linear(c / 255)) as Triple));
  const out = new Uint8Array(256 * 4);
  for (let i = 0; i < 256; i++) {
    const t = (i / 255) * (labs.length - 1);
    const at = Math.min(Math.floor(t), labs.length - 2);
    const mixed = labs[at].map((v, k) => v + (labs[at + 1][k] - v) * (t - at)) as Triple;
    const rgb = fromOklab(mixed).map((c) => Math.round(255 * encoded(Math.min(1, Math.max(0, c)))));
    out.set([rgb[0], rgb[1], rgb[2], 255], 4 * i);
  }
  return out;
}

export const HEIGHT_RAMP = ramp([[44, 52, 104], [46, 110, 142], [66, 166, 138], [174, 208, 96], [252, 232, 150]]);
export const CID_RAMP = ramp([[255, 244, 204], [242, 178, 88], [204, 92, 82], [122, 50, 112], [46, 34, 74]]);
export const DOUBT_RAMP = ramp([[255, 238, 150], [240, 140, 50], [140, 72, 80], [76, 74, 96], [58, 66, 84]]);

export function rampCss(values: Uint8Array): string {
  const stops = [];
  for (let i = 0; i <= 255; i += 15) stops.push(`rgb(${values[4 * i]} ${values[4 * i + 1]} ${values[4 * i + 2]})`);
  return `linear-gradient(to right, ${stops.join(', ')})`;
}
