/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What the keys are bound to in parts mode; help is made from the same table.
 */

import type { Binding } from './keys';

export interface PartsCommands {
  split(): void;
  join(): void;
  drop(): void;
  exact(): void;
  fewer(): void;
  more(): void;
  select(): void;
  selectSecond(): void;
  list(): void;
  hulls(): void;
  points(): void;
  colors(): void;
}

export function partsBindings(c: PartsCommands): Binding[] {
  const group = 'Parts';
  const mode = 'parts';
  const mouse = (shown: string, text: string): Binding => ({ keys: [], shown, group, text, mode });
  return [
    mouse('Click', 'Select the part under the cursor'),
    { keys: ['Enter'], group, text: 'The same at the cursor (or the middle)', run: c.select, mode },
    mouse('⇧Click', 'A second part, to join the two'),
    { keys: ['Shift+Enter'], group, text: 'The same at the cursor', run: c.selectSecond, mode },
    { keys: ['/'], group, text: 'Split the selected part', run: c.split, mode },
    { keys: ['M'], group, text: 'Join it with the second one (or with the next that is clicked)', run: c.join, mode },
    { keys: ['Delete'], group, text: 'Drop it, or keep it again', run: c.drop, mode },
    { keys: ['R'], group, text: 'Exact hull, or as the others', run: c.exact, mode },
    { keys: [','], group, text: 'One part fewer', run: c.fewer, mode },
    { keys: ['.'], group, text: 'One part more', run: c.more, mode },
    { keys: ['J'], group, text: 'Go to the list', run: c.list, mode },
    mouse('↑ ↓ Enter', 'In the list: choose, go there (⇧Enter: a second)'),
    { keys: ['K'], group, text: 'Hulls', run: c.hulls, mode },
    { keys: ['P'], group, text: 'Points', run: c.points, mode },
    { keys: ['B'], group, text: 'Colors of parts or those before', run: c.colors, mode },
  ];
}
