/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Opens the scan and puts the page together.
 */

import './style.css';
import { Box3, Vector3 } from 'three';
import { Actions } from './actions';
import { Asking } from './asking';
import { Camera } from './camera';
import { CloudGeometry } from './cloud_geometry';
import { ColorModes } from './color_modes';
import { connectCommands } from './commands';
import { Connection } from './connection';
import { Corrections } from './corrections';
import { el, letGoOfButtons } from './dom';
import { Doubt } from './doubt';
import { ExportDialog } from './export_dialog';
import { GroupView } from './group_view';
import { Help } from './help';
import { makeHook } from './hook';
import type { StudioHook } from './hook';
import { InstanceTable } from './instance_table';
import { InstancesPanel } from './instances_panel';
import { Keys } from './keys';
import { labelsExport } from './labels_export';
import { Lasso } from './lasso';
import { Messages } from './messages';
import { connectModes } from './mode_switch';
import { Modes } from './modes';
import { connectPartsCommands } from './parts_commands';
import { partsExport } from './parts_export';
import { makePartsHook } from './parts_hook';
import { makePartsMode } from './parts_mode';
import { PartsState } from './parts_state';
import { Picking } from './picking';
import { PointCloudView } from './point_cloud_view';
import { Pointer } from './pointer';
import { connectPointer } from './pointer_work';
import { Questions } from './questions';
import { openScan, streamColors, streamPositions } from './scan';
import type { OpenedScan } from './scan';
import { SectionCut } from './section';
import { SeedMarkers } from './seed_markers';
import { Session } from './session';
import { spacingOf } from './spacing';
import { StatusBar } from './status';
import { makeToolbar } from './tools';
import type { Workbench } from './workbench';

declare global {
  interface Window {
    /** Only for reading; see hook.ts. */
    studio?: StudioHook;
  }
}

async function open(root: HTMLElement): Promise<void> {
  const scan = await openScan();
  const { info } = scan;
  document.title = `${info.name} · pcl_cid studio`;
  const bounds = new Box3(new Vector3(...info.low), new Vector3(...info.high));
  const diagonal = bounds.getSize(new Vector3()).length();
  const session = new Session(info.places);
  const scheme = location.protocol === 'https:' ? 'wss' : 'ws';
  const connection = new Connection(`${scheme}://${location.host}/api/session`);

  const canvas = el('canvas', { class: 'cloud', tabindex: '0', 'aria-label': 'The scan. Arrow keys turn it, Enter asks about the point in the middle.' });
  const area = el('main', { class: 'area' }, canvas, el('div', { class: 'crosshair', 'aria-hidden': 'true' }));
  root.replaceChildren(area);
  const messages = new Messages(area);
  const actions = new Actions(connection, session, messages);
  const parts = new PartsState(info.places, actions);
  const modes = new Modes();
  const table = new InstanceTable(session, info.classes.map((one) => one.name));
  const cloud = new CloudGeometry(info.places, info.has_color, session, parts);
  let spacing = diagonal / 300;
  const view = new PointCloudView(canvas, cloud, table, info.has_color, new Vector3(...info.up).normalize(), () => spacing);
  const section = new SectionCut(view, bounds);
  const isDrawn = (place: number): boolean =>
    view.pointsShown && (modes.isParts || table.isShown(session.labels[place])) && section.keeps(place);
  const picking = new Picking(view);
  const keys = new Keys();
  const pointAt = (x: number, y: number): Vector3 | null => {
    if (modes.isParts) return partsMode.partPicking.at(x, y)?.point ?? null;
    const place = picking.pick(x, y);
    return place === null ? null : picking.positionOf(place);
  };
  const camera = new Camera(view, bounds, keys.down, pointAt);
  const partsMode = makePartsMode({ actions, camera, connection, diagonal, isDrawn, messages, parts, picking, section, session, view });
  const colors = new ColorModes(view, session, section, actions, info.has_color);
  const asking = new Asking(area, view, session, table, picking, messages, info.classes.map((one) => one.name), (place) => section.heightAt(place));
  const corrections = new Corrections(actions, asking, session, view, picking, messages);
  const groups = new GroupView(view, camera, section, diagonal, isDrawn);
  const doubt = new Doubt(session, actions, colors, groups, messages);
  const questions = new Questions(actions, asking, session, groups, messages, () => void doubt.next());
  const lasso = new Lasso(area, view, camera, picking, actions, asking, session, messages, isDrawn);
  const panel = new InstancesPanel(session, table, corrections, actions, asking, messages);
  const seeds = new SeedMarkers(view, session);
  const status = new StatusBar(info, session, connection, parts, modes);
  const help = new Help(root, keys);
  const saving = {
    labels: new ExportDialog(root, connection, labelsExport(info.name)),
    parts: new ExportDialog(root, connection, partsExport(info)),
  };
  const pointer = new Pointer(view);
  const bench: Workbench = {
    ...partsMode, actions, area, asking, camera, colors, connection, corrections, diagonal, doubt, help, isDrawn, keys, lasso, messages, modes,
    panel, parts, picking, pointer, questions, saving, section, seeds, session, status, table, view,
  };
  const ofParts = connectPartsCommands(bench);
  const commands = connectCommands(bench);
  const toolbar = makeToolbar(bench, commands, ofParts, info);
  connectModes(bench, root, partsMode.hullStore);
  connectPointer(bench);
  area.append(section.panel, colors.legend.element, questions.done);
  root.prepend(toolbar.element);
  root.append(panel.element, partsMode.partsPanel.element, status.element);

  // What a click would have taken is no part of a question.
  asking.on('opened', ({ kind }) => {
    if (kind === 'question') corrections.clearPreview();
  });
  session.on('changed', ({ places }) => {
    cloud.labelsChanged(places);
    messages.banner('looks', session.writer ? null : 'Another tab is working on this scan; this one looks on');
    view.invalidate();
  });
  connection.on('session', (message) => session.apply(message));
  connection.on('connected', () => messages.banner('away', null));
  connection.on('replaced', () => messages.banner('away', 'pcl_cid_studio was started again: open the address that it printed'));
  connection.on('disconnected', () => {
    messages.banner('away', 'The server is not there; trying again');
    asking.close();
    questions.leave();
  });
  letGoOfButtons();
  table.refresh();
  colors.set(colors.mode);
  section.apply();
  void camera.home(false);
  connection.open();

  let loading = true;
  const busy = (): boolean =>
    loading || connection.waiting > 0 || view.busy || camera.isFlying || questions.busy || colors.pending > 0 || partsMode.hullStore.busy;
  window.studio = makeHook(session, view, picking, section, colors, questions, asking, connection, makePartsHook(view, modes, parts, partsMode), isDrawn, busy);
  canvas.focus({ preventScroll: true });
  await load(scan, cloud, view, section, status, () => (spacing = spacingOf(cloud.positions, view.arrivedPlaces)), () => seeds.refresh());
  loading = false;
}

/** Positions and colors together: what has both is drawn. */
async function load(
  { info, positions, colors }: OpenedScan,
  cloud: CloudGeometry,
  view: PointCloudView,
  section: SectionCut,
  status: StatusBar,
  measureSpacing: () => void,
  positionsMoved: () => void,
): Promise<void> {
  const there = { position: 0, color: info.has_color ? 0 : info.places };
  let suggested = false;
  const arrived = (name: 'position' | 'color') => (from: number, to: number): void => {
    cloud.arrived(name, from, to);
    there[name] = to;
    view.arrive(Math.min(there.position, there.color));
    if (!suggested && there.position >= Math.min(20000, info.places)) {
      suggested = true;
      measureSpacing();
      section.suggestCeiling(there.position);
    }
    const share = (there.position + (info.has_color ? there.color : 0)) / (info.places * (info.has_color ? 2 : 1));
    status.loading(Math.min(share, 0.999));
  };
  await Promise.all([
    streamPositions(positions, cloud.positions, arrived('position')),
    colors && streamColors(colors, cloud.colors, arrived('color')),
  ]);
  measureSpacing();
  positionsMoved();
  status.loading(null);
  view.invalidate();
}

const root = document.getElementById('page')!;
open(root).catch((error: unknown) => {
  root.replaceChildren(el('p', { class: 'opening wrong', role: 'alert', text: error instanceof Error ? error.message : String(error) }));
});
