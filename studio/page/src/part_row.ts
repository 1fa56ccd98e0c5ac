/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * One row of the list of parts: what it is, and how well its hull fits.
 */

import { count, el, metres, shortCount, volume } from './dom';
import { css } from './palette';
import type { HullFacts, Part, Tightness } from './protocol';

export interface PartRowData {
  part: Part;
  color: [number, number, number];
  facts: HullFacts | null;
  tightness: Tightness | null;
  selected: boolean;
  cursor: boolean;
}

export const nameOf = (part: Part): string => `Part ${part.part}`;

function marks({ dropped, exact }: Part, facts: HullFacts | null): HTMLElement[] {
  const list: [boolean, string, string][] = [
    [dropped, 'dropped', 'Left out of what is exported'],
    [exact, 'exact', 'The hull has all its vertices and holds all points'],
    [facts?.thickened ?? false, 'thickened', 'A flat part: its hull was given a thickness'],
    [facts?.boxed ?? false, 'box', 'The hull is a box around the points'],
  ];
  return list.flatMap(([is, text, title]) => (is ? [el('span', { class: `badge ${text}`, text, title })] : []));
}

/** How large the hull is, and how well it fits. */
export function fit(facts: HullFacts | null, tightness: Tightness | null): HTMLElement {
  const line = el('span', { class: 'part-fit' });
  if (!facts) line.append(el('span', { text: 'The hull is on its way …' }));
  else {
    line.append(el('span', { text: volume(facts.volume), title: `Volume of the hull, ${count(facts.vertices)} vertices` }));
    if (!tightness) line.append(el('span', { text: 'fit …' }));
    else {
      line.append(
        el('span', { text: `off ${metres(tightness.max_concavity)}`, title: `How far the surface of the hull strays from the scan at most; ${metres(tightness.mean_concavity)} in the mean` }),
        el('span', { text: `${Math.round(100 * tightness.free_share)} % free`, title: 'The share of its volume that is free space' }),
      );
    }
  }
  return line;
}

export function partRow({ part, color, facts, tightness, selected, cursor }: PartRowData, choose: (event: MouseEvent) => void): HTMLElement {
  const swatch = el('span', { class: 'swatch' });
  swatch.style.background = css(color);
  const row = el(
    'div',
    {
      class: 'part',
      role: 'option',
      id: `part-${part.part}`,
      'data-part': String(part.part),
      'aria-selected': String(selected),
      title: `${count(part.size)} points, ${part.groups.length === 1 ? 'one group' : `${part.groups.length} groups`}`,
      click: choose,
    },
    el('span', { class: 'part-head' }, swatch, el('span', { class: 'part-name', text: nameOf(part) }), ...marks(part, facts), el('span', { class: 'part-size', text: shortCount(part.size) })),
    fit(facts, tightness),
  );
  row.classList.toggle('cursor', cursor);
  row.classList.toggle('off', part.dropped);
  return row;
}
