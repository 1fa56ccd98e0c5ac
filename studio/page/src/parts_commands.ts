/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What keys and the mouse do in parts mode.
 */

import type { Camera } from './camera';
import type { ColorModes } from './color_modes';
import { count } from './dom';
import type { HullView } from './hull_view';
import type { Keys } from './keys';
import type { Messages } from './messages';
import type { Modes } from './modes';
import type { PartPicking } from './part_picking';
import { partsBindings } from './parts_bindings';
import type { PartsCommands } from './parts_bindings';
import type { PartsPanel } from './parts_panel';
import type { PartsWork } from './parts_work';
import type { PointCloudView } from './point_cloud_view';
import type { Pointer } from './pointer';
import type { StatusBar } from './status';

/** What parts mode works on. */
export interface PartsBench {
  camera: Camera;
  colors: ColorModes;
  hulls: HullView;
  keys: Keys;
  messages: Messages;
  modes: Modes;
  partPicking: PartPicking;
  partsPanel: PartsPanel;
  partsWork: PartsWork;
  pointer: Pointer;
  status: StatusBar;
  toolbarChanged?: () => void;
  view: PointCloudView;
}

export function connectPartsCommands(bench: PartsBench): PartsCommands {
  const { colors, hulls, keys, messages, partPicking, partsPanel, partsWork, pointer, view } = bench;
  const clickHere = (add: boolean) => (): void => {
    const part = partPicking.at(pointer.cursor.x, pointer.cursor.y)?.part ?? null;
    if (part) void partsWork.clicked(part, add).then(() => partsPanel.reveal());
    else messages.note('There is no part under the cursor.');
  };
  const commands: PartsCommands = {
    split: () => void partsWork.split(),
    join: () => void partsWork.join(),
    drop: () => void partsWork.toggleDropped(),
    exact: () => void partsWork.toggleExact(),
    fewer: () => void partsWork.cutBy(-1),
    more: () => void partsWork.cutBy(1),
    select: clickHere(false),
    selectSecond: clickHere(true),
    list: () => partsPanel.focus(),
    hulls: () => {
      hulls.show(!hulls.shown);
      bench.toolbarChanged?.();
    },
    points: () => {
      view.pointsShown = !view.pointsShown;
      hulls.refreshVisible();
      bench.toolbarChanged?.();
    },
    colors: () => colors.toggle('part'),
  };
  keys.add(...partsBindings(commands));
  return commands;
}

export function connectPartsPointer(bench: PartsBench): void {
  const { camera, modes, partPicking, partsPanel, partsWork, pointer, status } = bench;
  pointer.on('click', ({ x, y, shift }) => {
    if (!modes.isParts) return;
    void partsWork.clicked(partPicking.at(x, y)?.part ?? null, shift).then(() => partsPanel.reveal());
  });
  pointer.on('double', ({ x, y }) => {
    const hit = modes.isParts ? partPicking.at(x, y) : null;
    if (hit) void camera.focus(hit.point);
  });
  pointer.on('rest', ({ x, y }) => {
    if (!modes.isParts) return;
    const part = partPicking.at(x, y)?.part;
    status.here(part ? `Part ${part.part} · ${count(part.size)} points` : '');
  });
}
