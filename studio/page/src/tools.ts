/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Which buttons the toolbar has, and when they are pressed or off.
 */

import type { Commands } from './bindings';
import { el } from './dom';
import type { PartsCommands } from './parts_bindings';
import type { Workbench } from './workbench';
import type { ScanInfo } from './protocol';
import { Toolbar } from './toolbar';

export function makeToolbar(bench: Workbench, commands: Commands, ofParts: PartsCommands, info: ScanInfo): Toolbar {
  const { actions, colors, hulls, lasso, messages, modes, parts, questions, section, session, view } = bench;
  const bar = new Toolbar(info.name, info.session, `Session: ${info.session}`);
  const more = el('select', { 'aria-label': 'More about questions', title: 'More about questions', class: 'more', 'data-only': 'labels' });
  for (const [value, text] of [
    ['', 'More'],
    ['propose', 'Propose 20 more questions'],
    ['settle', 'Take the open questions away'],
  ]) {
    more.append(el('option', { value, text }));
  }
  more.addEventListener('change', () => {
    const what = more.value;
    more.value = '';
    if (what === 'propose' && actions.may()) void questions.propose(20);
    if (what === 'settle') void questions.settle();
  });
  bar.group(
    'Mode',
    { name: 'labels', text: 'Labels', title: 'Labels: what things are', icon: 'label', shortcut: 'G', run: () => modes.set('labels') },
    { name: 'parts', text: 'Parts', title: 'Parts: collision geometry', icon: 'hull', shortcut: 'G', run: () => modes.set('parts') },
  ).classList.add('segments');
  bar.group(
    'Questions',
    { name: 'next', only: 'labels', text: 'Next question', title: 'Next question', icon: 'next', shortcut: 'Space', changes: true, run: commands.next },
    more,
  );
  bar.group(
    'Changes',
    { name: 'undo', text: 'Undo', title: 'Undo', icon: 'undo', shortcut: 'Ctrl+Z', small: true, changes: true, run: commands.undo },
    { name: 'redo', text: 'Redo', title: 'Redo', icon: 'redo', shortcut: 'Ctrl+Y', small: true, changes: true, run: commands.redo },
    { name: 'lasso', only: 'labels', text: 'Lasso', title: 'Lasso', icon: 'lasso', shortcut: 'L', changes: true, run: commands.lasso },
    { name: 'doubtful', only: 'labels', text: 'Doubt', title: 'Next doubtful area', icon: 'doubt', shortcut: '⇧U', run: commands.nextDoubt },
  );
  const slider = section.ceilingSlider();
  slider.classList.add('ceiling-slider');
  bar.group('Colors', colors.select);
  bar.group(
    'View',
    { name: 'hulls', text: 'Hulls', title: 'Show the hulls', icon: 'hull', shortcut: 'K', only: 'parts', run: ofParts.hulls },
    { name: 'points', text: 'Points', title: 'Show the points', icon: 'points', shortcut: 'P', only: 'parts', run: ofParts.points },
    { name: 'ceiling', text: 'Ceiling cut', title: 'Cut the ceiling away', icon: 'ceiling', shortcut: 'C', run: commands.ceiling },
    slider,
    { name: 'section', text: 'Section box', title: 'Section box', icon: 'box', shortcut: 'X', small: true, run: commands.section },
    { name: 'lighting', text: 'Eye-dome lighting', title: 'Eye-dome lighting', icon: 'light', shortcut: 'O', small: true, run: commands.lighting },
  );
  bar.fill();
  bar.group(
    'General',
    { name: 'save', text: 'Save as', title: 'Save as', icon: 'save', shortcut: 'Ctrl+S', small: true, run: commands.save },
    { name: 'help', text: 'Keys', title: 'Keys and mouse', icon: 'keys', shortcut: '?', small: true, run: commands.help },
  );

  const refresh = (): void => {
    const connected = bench.connection.isOpen && session.ready;
    const may = connected && session.writer;
    bar.mayChange(may);
    const steps = modes.isParts ? parts : session;
    bar.disable('undo', !may || steps.undo === 0);
    bar.disable('redo', !may || steps.redo === 0);
    more.disabled = !may;
    bar.press('labels', !modes.isParts);
    bar.press('parts', modes.isParts);
    bar.press('hulls', hulls.shown);
    bar.press('points', view.pointsShown);
    bar.press('ceiling', section.ceilingOn && !section.suspended);
    slider.hidden = !section.ceilingOn;
    bar.press('section', section.boxOn);
    bar.press('lighting', view.lighting.enabled);
    bar.press('lasso', lasso.on);
  };
  bench.toolbarChanged = refresh;
  lasso.toggled = (on) => {
    if (on) messages.say('Lasso');
    refresh();
  };
  session.on('changed', refresh);
  parts.on('changed', refresh);
  section.on('changed', refresh);
  bench.connection.on('connected', refresh);
  bench.connection.on('disconnected', () => {
    if (lasso.on) lasso.toggle(false);
    refresh();
  });
  refresh();
  return bar;
}
