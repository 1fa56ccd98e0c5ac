/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * One scan and what was made of it, in a page of its own: puts it together.
 */

import '../style.css';
import './picture.css';
import { Box3, Vector3 } from 'three';
import { Camera } from '../camera';
import { CloudGeometry } from '../cloud_geometry';
import { el, letGoOfButtons } from '../dom';
import { unpackHulls } from '../hull';
import { HullView } from '../hull_view';
import type { DrawnHull } from '../hull_view';
import { InstanceTable } from '../instance_table';
import { Keys } from '../keys';
import { Picking } from '../picking';
import { PointCloudView } from '../point_cloud_view';
import type { Instance, Part } from '../protocol';
import { unpackColors } from '../scan';
import { SectionCut } from '../section';
import { spacingOf } from '../spacing';
import { ColorChoice } from './color_choice';
import { readBytes, readFacts, readFloats, readNumbers } from './data';
import type { Facts } from './data';
import { figuresPanel } from './figures';
import { MarksList } from './marks_list';
import { makeToolbar } from './toolbar';
import { upVector } from './up';

declare global {
  interface Window {
    /** Only for reading, for tests. */
    picture?: { idle(): Promise<void>; ceiling(): number; mode(): string };
  }
}

/** A color for each index, whether it is listed or not. */
function instancesOf({ indices }: Facts): Map<number, Instance> {
  const instances = new Map<number, Instance>();
  for (let label = 1; label <= indices; label++) instances.set(label, { label, class: '', name: '', size: 0 });
  return instances;
}

function hullsOf({ hulls }: Facts): DrawnHull[] {
  const unpacked = unpackHulls(hulls, readFloats('hull_vertices'), readNumbers('hull_triangles'));
  return unpacked.map((hull) => {
    const part: Part = { part: hull.facts.part, groups: [], size: 0, height: null, splits: false, dropped: false, exact: false };
    return { part, hull };
  });
}

function makeCloud({ points }: Facts, labels: Uint32Array): { cloud: CloudGeometry; hasColor: boolean; most: number } {
  const [colors, values] = [readBytes('colors'), readFloats('values')];
  const hasColor = colors.length > 0;
  const cloud = new CloudGeometry(points, hasColor, { labels, groups: labels }, { groupOf: labels });
  cloud.positions.set(readFloats('positions'));
  if (hasColor) unpackColors(colors, cloud.colors, 0, points);
  if (values.length > 0) cloud.setScalars(values);
  return { cloud, hasColor, most: values.reduce((a, b) => Math.max(a, b), 0) };
}

function open(root: HTMLElement): void {
  const facts = readFacts();
  document.title = `${facts.name} · ${facts.report.tool}`;
  const bounds = new Box3(new Vector3(...facts.low), new Vector3(...facts.high));
  const labels = facts.kind === 'values' ? new Uint32Array(facts.points) : readNumbers('labels');
  const { cloud, hasColor, most } = makeCloud(facts, labels);
  const table = new InstanceTable({ instances: instancesOf(facts) }, []);
  const canvas = el('canvas', { class: 'cloud', tabindex: '0', 'aria-label': 'The scan. Arrow keys turn it, Page Up and Page Down zoom.' });
  const area = el('main', { class: 'area' }, canvas);
  root.replaceChildren(area);

  const spacing = spacingOf(cloud.positions, facts.points);
  const view = new PointCloudView(canvas, cloud, table, hasColor, upVector(), () => spacing);
  const section = new SectionCut(view, bounds);
  const picking = new Picking(view);
  const keys = new Keys();
  const camera = new Camera(view, bounds, keys.down, (x, y) => {
    const place = picking.pick(x, y);
    return place === null ? null : picking.positionOf(place);
  });
  const drawn = hullsOf(facts);
  const hulls = new HullView(view, section, () => drawn.filter(({ part }) => table.isShown(part.part)));
  const colors = new ColorChoice(view, section, facts.kind, hasColor, { text: facts.values, most });
  // The colors of parts are those of their points.
  table.on('changed', () => {
    view.uniforms.partColors.value = table.instances;
    hulls.refresh();
  });
  table.refresh();
  hulls.show(true, true);
  const side = el('aside', { class: 'instances' }, figuresPanel(facts));
  if (facts.kind !== 'values') side.append(new MarksList(facts, table).element);
  area.append(colors.legend.element);
  root.prepend(makeToolbar({ camera, colors, facts, hulls, keys, section, view }));
  root.append(side);

  letGoOfButtons();
  section.apply();
  section.suggestCeiling(facts.points);
  void camera.home(false);
  view.arrive(facts.points);
  window.picture = {
    async idle() {
      do await new Promise((done) => setTimeout(done, 50));
      while (view.busy || camera.isFlying);
    },
    ceiling: () => section.ceilingHeight,
    mode: () => colors.current,
  };
}

const root = document.getElementById('page')!;
try {
  open(root);
} catch (error) {
  root.replaceChildren(el('p', { class: 'opening wrong', role: 'alert', text: error instanceof Error ? error.message : String(error) }));
}
