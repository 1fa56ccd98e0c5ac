/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The buttons of a picture, and their keys.
 */

import type { Camera } from '../camera';
import { el } from '../dom';
import type { HullView } from '../hull_view';
import type { Binding, Keys } from '../keys';
import type { PointCloudView } from '../point_cloud_view';
import type { SectionCut } from '../section';
import { Toolbar } from '../toolbar';
import type { ColorChoice } from './color_choice';
import type { Facts } from './data';
import { upMenu } from './up';

export interface Bench {
  camera: Camera;
  colors: ColorChoice;
  facts: Facts;
  hulls: HullView;
  keys: Keys;
  section: SectionCut;
  view: PointCloudView;
}

export function makeToolbar(bench: Bench): HTMLElement {
  const { camera, colors, facts, hulls, keys, section, view } = bench;
  const { tool, version, input } = facts.report;
  const bar = new Toolbar(facts.name, `${tool} ${version}`, input);
  const hasHulls = facts.hulls.length > 0;
  const toggleHulls = (): void => {
    hulls.show(!hulls.shown);
    refresh();
  };
  const togglePoints = (): void => {
    view.pointsShown = !view.pointsShown;
    hulls.refreshVisible();
    refresh();
  };
  const resize = (factor: number): void => {
    view.pointSize = Math.min(8, Math.max(0.25, view.pointSize * factor));
    view.invalidate();
  };
  const ceiling = (): void => section.toggleCeiling();
  const [home, top] = [() => void camera.home(), () => void camera.top()];
  const slider = section.ceilingSlider();
  slider.classList.add('ceiling-slider');
  bar.group('Colors', colors.select);
  if (hasHulls) {
    bar.group(
      'What is shown',
      { name: 'hulls', text: 'Hulls', title: 'Show the hulls', icon: 'hull', shortcut: 'K', run: toggleHulls },
      { name: 'points', text: 'Points', title: 'Show the points', icon: 'points', shortcut: 'P', run: togglePoints },
    );
  }
  bar.group('Cut', { name: 'ceiling', text: 'Ceiling cut', title: 'Cut the ceiling away', icon: 'ceiling', shortcut: 'C', run: ceiling }, slider);
  bar.group(
    'View',
    { name: 'home', text: 'Whole scan', title: 'The whole scan', icon: 'box', shortcut: 'H', run: home },
    { name: 'top', text: 'From above', title: 'From above', icon: 'above', shortcut: 'T', run: top },
    upMenu(),
  );
  bar.fill();
  bar.element.append(el('span', { class: 'context hint', text: 'Drag: turn · Shift+drag: move · Wheel: zoom' }));

  const binding = (key: string, run: () => void): Binding => ({ keys: [key], group: '', text: '', run });
  keys.add(
    binding('C', ceiling), binding('H', home), binding('T', top), binding('V', () => colors.next()),
    binding('[', () => section.moveCeiling(-0.02)), binding(']', () => section.moveCeiling(0.02)),
    binding('-', () => resize(1 / 1.25)), binding('+', () => resize(1.25)),
    binding('ArrowLeft', () => camera.turn(-1, 0)), binding('ArrowRight', () => camera.turn(1, 0)),
    binding('ArrowUp', () => camera.turn(0, -1)), binding('ArrowDown', () => camera.turn(0, 1)),
    binding('PageUp', () => camera.zoom(0.8)), binding('PageDown', () => camera.zoom(1.25)),
  );
  if (hasHulls) keys.add(binding('K', toggleHulls), binding('P', togglePoints));

  const refresh = (): void => {
    bar.press('hulls', hulls.shown);
    bar.press('points', view.pointsShown);
    bar.press('ceiling', section.ceilingOn);
  };
  section.on('changed', refresh);
  refresh();
  return bar.element;
}
