/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The figures of the run, in words.
 */

import { count, el, metres, volume } from '../dom';
import type { Facts, Report } from './data';

const percent = (share: number): string => `${(100 * share).toFixed(1)} %`;

type Figure = [name: string, text: string, title?: string];

function ofPoints({ points }: Report, shown: number): Figure[] {
  const figures: Figure[] = [['Points', count(points.in)]];
  if (points.finite < points.in) figures.push(['Finite', count(points.finite)]);
  if (shown < points.finite) figures.push(['Shown', count(shown), 'Spread evenly over the scan']);
  if (points.dropped) figures.push(['Dropped', count(points.dropped), 'Points in parts that were left out']);
  return figures;
}

function ofHulls({ parts, exact_vertices, places, tightness }: Report, hulls: number): Figure[] {
  const figures: Figure[] = [];
  if (parts !== undefined) figures.push(['Parts', count(parts)]);
  if (parts !== undefined && hulls < parts) figures.push(['Hulls shown', count(hulls), 'Those of the parts with the most points']);
  if (exact_vertices !== undefined) figures.push(['Exact vertices', count(exact_vertices), 'Of all hulls before they were simplified']);
  if (places) figures.push(['Places refused', percent(places.refused_share), `Of ${count(places.free)} free places, those that the hulls refuse to a robot`]);
  if (!tightness) return figures;
  figures.push(
    ['Volume', volume(tightness.volume), 'Of the union of the hulls'],
    ['Free space in it', percent(tightness.free_share), 'The share of the volume that is free space'],
    ['Hulls off', metres(tightness.max_concavity), `How far a hull strays from the scan at most; ${metres(tightness.mean_concavity)} in the mean`],
  );
  return figures;
}

function figuresOf({ report, points, hulls }: Facts): Figure[] {
  const { blind_spot, density, score, seeds } = report;
  const figures = ofPoints(report, points);
  if (density?.isolated_points) figures.push(['Isolated', count(density.isolated_points), 'Points without enough neighbours']);
  if (blind_spot) figures.push(['Filled', count(blind_spot.points), 'Points that fill the blind spot of the scanner']);
  if (seeds) figures.push(['Seeds', count(seeds.number)], ['Coverage', metres(seeds.coverage), 'The largest CID from a point to its seed']);
  if (score) figures.push(['Right', percent(score.share_right), `Of ${count(score.points)} points, those with the label that the field '${score.field}' says`]);
  return [...figures, ...ofHulls(report, hulls.length)];
}

function table(figures: Figure[]): HTMLElement {
  return el('dl', { class: 'figures' }, ...figures.map(([name, text, title]) => el('div', { title }, el('dt', { text: name }), el('dd', { text }))));
}

function more(text: string, content: HTMLElement): HTMLElement {
  return el('details', {}, el('summary', { text }), content);
}

const worded = (value: string | number | boolean | null): string => (value === null ? 'none' : typeof value === 'boolean' ? (value ? 'on' : 'off') : String(value));

export function figuresPanel(facts: Facts): HTMLElement {
  const { parameters, remarks } = facts.report;
  const settings = Object.entries(parameters).map(([name, value]): Figure => [name.replaceAll('_', ' '), worded(value)]);
  const panel = el('section', { class: 'run', 'aria-label': 'Figures' }, table(figuresOf(facts)));
  if (settings.length > 0) panel.append(more('Settings', table(settings)));
  if (remarks) panel.append(more(`Remarks (${remarks.length})`, el('ul', {}, ...remarks.map((text) => el('li', { text })))));
  return panel;
}
