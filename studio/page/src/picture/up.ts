/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Which axis points up: z, unless the address says otherwise (#up=-y for the scan of a camera).
 */

import { Vector3 } from 'three';
import { el } from '../dom';

const AXES: Record<string, [number, number, number]> = {
  z: [0, 0, 1], '-z': [0, 0, -1], y: [0, 1, 0], '-y': [0, -1, 0], x: [1, 0, 0], '-x': [-1, 0, 0],
};

const named = (): string => /^#up=(-?[xyz])$/.exec(location.hash)?.[1] ?? 'z';

export const upVector = (): Vector3 => new Vector3(...AXES[named()]);

/** All depends on it: the page opens again. */
export function upMenu(): HTMLSelectElement {
  const menu = el('select', { 'aria-label': 'Which axis points up', title: 'Which axis points up', class: 'up' });
  menu.append(...Object.keys(AXES).map((axis) => el('option', { value: axis, text: `${axis.replace('-', '−')} up` })));
  menu.value = named();
  menu.addEventListener('change', () => {
    location.hash = `up=${menu.value}`;
    location.reload();
  });
  return menu;
}
