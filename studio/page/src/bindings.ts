/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * All keys and what they do, in the order in which help lists them.
 */

import type { Binding } from './keys';

export interface Commands {
  modes(): void;
  next(): void;
  skip(): void;
  escape(): void;
  pick(): void;
  backToCard(): void;
  clickHere(): void;
  giveHere(): void;
  removeSeed(): void;
  previews(): void;
  undo(): void;
  redo(): void;
  lasso(): void;
  nextDoubt(): void;
  merge(): void;
  list(): void;
  isolate(): void;
  showAll(): void;
  colors(by: 1 | -1): void;
  labels(): void;
  doubt(): void;
  pointSize(factor: number): void;
  lighting(): void;
  seeds(): void;
  ceiling(): void;
  moveCeiling(part: number): void;
  section(): void;
  home(): void;
  top(): void;
  focus(): void;
  turn(right: number, up: number): void;
  zoom(factor: number): void;
  save(): void;
  help(): void;
}

export function bindings(c: Commands): Binding[] {
  const work = 'Questions';
  const correct = 'Correct';
  const instances = 'Instances';
  const look = 'Look';
  const camera = 'Camera';
  const all = 'General';
  const mouse = (group: string, shown: string, text: string): Binding => ({ keys: [], shown, group, text });
  const ofLabels: Binding[] = [
    { keys: ['Space'], group: work, text: 'Next question', run: c.next, whileAsking: true },
    { keys: ['Shift+Space'], group: work, text: 'Skip to the question after this one', run: c.skip, whileAsking: true },
    { keys: ['N'], group: work, text: 'The same, without a card', run: c.skip },
    mouse(work, '1 … 9', 'A new instance of that class'),
    mouse(work, 'letters', 'With a card open: type a class or an instance; ↑ ↓ choose'),
    mouse(work, 'Enter', 'A new instance of the same class as last time'),
    mouse(work, '0', 'No label'),
    mouse(work, '⇧1 … ⇧6', 'One of the nearest instances'),
    mouse(work, 'Click', 'The instance under the cursor'),
    { keys: ['/'], group: work, text: 'Back to the open card', run: c.backToCard },

    mouse(correct, 'Click', 'Say what this point is'),
    { keys: ['Enter'], group: correct, text: 'The same at the cursor (or the middle)', run: c.clickHere },
    mouse(correct, 'Alt+Click', 'Make this instance the active one'),
    mouse(correct, '⇧Click', 'Give this point to the active instance'),
    { keys: ['Shift+Enter'], group: correct, text: 'The same at the cursor', run: c.giveHere },
    { keys: ['Ctrl+I'], group: correct, text: 'With a card open: pick an instance by a click', run: c.pick, always: true },
    { keys: ['Delete'], group: correct, text: 'Remove the seed under the cursor', run: c.removeSeed },
    { keys: ['P'], group: correct, text: 'Preview of what a click takes, on or off', run: c.previews },
    { keys: ['L'], group: correct, text: 'Lasso (Alt+drag takes paint away)', run: c.lasso },
    { keys: ['Shift+U'], group: correct, text: 'Next doubtful area', run: c.nextDoubt },

    { keys: ['J'], group: instances, text: 'Go to the list', run: c.list },
    mouse(instances, '↑ ↓ Enter', 'In the list: choose, go there'),
    mouse(instances, 'Ctrl+Click', 'Choose a second one (list: ⇧Enter)'),
    { keys: ['M'], group: instances, text: 'Merge the two that are chosen', run: c.merge },
    mouse(instances, 'F2', 'In the list: change class and name'),
    mouse(instances, 'H', 'In the list: hide or show (Alt: all others)'),
    mouse(instances, 'Delete', 'In the list: delete the instance'),
    { keys: ['Z'], group: instances, text: 'Hide all but the active one', run: c.isolate },
    { keys: ['Shift+H'], group: instances, text: 'Show all', run: c.showAll },

    { keys: ['B'], group: look, text: 'Instances or the mode before', run: c.labels },
    { keys: ['U'], group: look, text: 'Doubt', run: c.doubt },
    { keys: ['K'], group: look, text: 'Seeds', run: c.seeds },
  ];
  return [
    ...ofLabels.map((one): Binding => ({ ...one, mode: 'labels' })),

    { keys: ['V'], group: look, text: 'Next color mode', run: () => c.colors(1) },
    { keys: ['Shift+V'], group: look, text: 'Color mode before', run: () => c.colors(-1) },
    { keys: ['C'], group: look, text: 'Cut the ceiling away', run: c.ceiling },
    { keys: ['['], group: look, text: 'Cut lower', run: () => c.moveCeiling(-0.02) },
    { keys: [']'], group: look, text: 'Cut higher', run: () => c.moveCeiling(0.02) },
    { keys: ['X'], group: look, text: 'Section box', run: c.section },
    { keys: ['-'], group: look, text: 'Smaller points', run: () => c.pointSize(1 / 1.25) },
    { keys: ['+', '='], group: look, text: 'Larger points', run: () => c.pointSize(1.25) },
    { keys: ['O'], group: look, text: 'Eye-dome lighting', run: c.lighting },

    mouse(camera, 'Drag', 'Turn about the point under the cursor'),
    mouse(camera, 'Right or ⇧Drag', 'Move sideways'),
    mouse(camera, 'Wheel', 'Zoom to the cursor'),
    mouse(camera, 'Double-click', 'Look at this point'),
    { keys: ['F'], group: camera, text: 'Look at the point under the cursor', run: c.focus },
    mouse(camera, 'W A S D Q E', 'Without a card: fly; Shift: faster'),
    { keys: ['ArrowLeft'], group: camera, text: 'Turn left', run: () => c.turn(-1, 0), whileAsking: true },
    { keys: ['ArrowRight'], group: camera, text: 'Turn right', run: () => c.turn(1, 0), whileAsking: true },
    { keys: ['ArrowUp'], group: camera, text: 'Turn up', run: () => c.turn(0, -1), whileAsking: true },
    { keys: ['ArrowDown'], group: camera, text: 'Turn down', run: () => c.turn(0, 1), whileAsking: true },
    { keys: ['PageUp'], group: camera, text: 'Nearer', run: () => c.zoom(0.8), whileAsking: true },
    { keys: ['PageDown'], group: camera, text: 'Farther', run: () => c.zoom(1.25), whileAsking: true },
    { keys: ['T'], group: camera, text: 'From above', run: c.top },
    { keys: ['H'], group: camera, text: 'The whole scan', run: c.home },

    { keys: ['Ctrl+Z'], group: all, text: 'Undo', run: c.undo, whileAsking: true },
    { keys: ['Ctrl+Y', 'Ctrl+Shift+Z'], group: all, text: 'Redo', run: c.redo, whileAsking: true },
    { keys: ['G'], group: all, text: 'Labels or parts', run: c.modes },
    { keys: ['Ctrl+S'], group: all, text: 'Save as other formats', run: c.save, always: true },
    { keys: ['?', 'F1'], group: all, text: 'This list', run: c.help, whileAsking: true },
    { keys: ['Escape'], group: all, text: 'Leave what is open', run: c.escape, always: true },
  ];
}
