/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Saving the parts: meshes of the hulls that are kept, scenes of simulators, and what goes with them.
 */

import { el } from './dom';
import { choice, stemOf } from './export_dialog';
import type { Export } from './export_dialog';
import type { ScanInfo } from './protocol';

const LABELS = [
  ['', 'None', 'No labelled cloud'],
  ['pcd', 'PCD', 'The scan with the number of its part for each point'],
  ['ply', 'PLY', 'The same as PLY'],
] as const;

function check(name: string, value: string, text: string, title?: string): HTMLElement {
  return el('label', { class: 'check', title }, el('input', { type: 'checkbox', name, value }), el('span', { text }));
}

function line(label: string, ...boxes: HTMLElement[]): HTMLElement {
  return el('div', { class: 'checks', role: 'group', 'aria-label': label }, el('span', { class: 'checks-name', text: label }), el('div', { class: 'checks-boxes' }, ...boxes));
}

function meshChoice(meshes: string[]): HTMLElement {
  const select = el('select', { name: 'mesh', 'aria-label': 'Format of the meshes' });
  for (const name of meshes) select.append(el('option', { value: name, text: name.toUpperCase() }));
  return select;
}

export function partsExport({ name, meshes, scenes }: ScanInfo): Export {
  return {
    title: 'Save the parts',
    note: 'Writes the hulls of the parts that are not dropped into the folder of the session. What is promised of them is verified in the written files before they take their places.',
    stem: `${stemOf(name)}_parts`,
    fields: () => [
      line('Meshes', meshChoice(meshes)),
      line('Scenes', ...scenes.map((one) => check('scenes', one.name, one.name, one.help))),
      line('Beside', check('report', 'on', 'A report'), check('primitives', 'on', 'Boxes, spheres, cylinders and capsules where they fit')),
      choice('labels', 'Labelled cloud', LABELS),
    ],
    request: (data) => ({
      ask: 'export parts',
      mesh: data.get('mesh'),
      scenes: data.getAll('scenes'),
      primitives: data.has('primitives'),
      report: data.has('report'),
      // What is left out is not written.
      ...(data.get('labels') ? { labels: data.get('labels') } : {}),
    }),
  };
}
