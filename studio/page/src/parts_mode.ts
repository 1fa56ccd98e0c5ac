/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Puts together what parts mode is made of, and keeps the picture and the panel with the parts.
 */

import type { Actions } from './actions';
import type { Camera } from './camera';
import type { Connection } from './connection';
import { CutControls } from './cut_controls';
import { HullStore } from './hull_store';
import { HullView } from './hull_view';
import type { DrawnHull } from './hull_view';
import type { Messages } from './messages';
import { PartPicking } from './part_picking';
import { PartTable } from './part_table';
import { PartsPanel } from './parts_panel';
import type { PartsState } from './parts_state';
import { PartsWork } from './parts_work';
import type { Picking } from './picking';
import type { PointCloudView } from './point_cloud_view';
import type { SectionCut } from './section';
import type { Session } from './session';

export interface PartsNeeds {
  actions: Actions;
  camera: Camera;
  connection: Connection;
  diagonal: number;
  isDrawn: (place: number) => boolean;
  messages: Messages;
  parts: PartsState;
  picking: Picking;
  section: SectionCut;
  session: Session;
  view: PointCloudView;
}

export interface PartsMode {
  hulls: HullView;
  hullStore: HullStore;
  partPicking: PartPicking;
  partsPanel: PartsPanel;
  partsWork: PartsWork;
}

/** Only hulls of the parts of now, as far as they have come. */
function hullsOf(parts: PartsState, store: HullStore): DrawnHull[] {
  return parts.list.flatMap((part) => {
    const hull = part.dropped ? null : store.hullOf(part);
    return hull ? [{ part, hull }] : [];
  });
}

export function makePartsMode(needs: PartsNeeds): PartsMode {
  const { actions, camera, connection, diagonal, isDrawn, messages, parts, picking, section, session, view } = needs;
  const hullStore = new HullStore(parts, connection, messages);
  const hulls = new HullView(view, section, () => hullsOf(parts, hullStore));
  parts.on('changed', () => hulls.refresh());
  hullStore.on('changed', (what) => what === 'hulls' && hulls.refresh());
  const partPicking = new PartPicking(view, picking, hulls, parts);
  const table = new PartTable(parts, (texture) => (view.uniforms.partColors.value = texture));
  const partsWork = new PartsWork(parts, actions, view, camera, diagonal, messages, isDrawn);
  const partsPanel = new PartsPanel(parts, hullStore, table, partsWork, new CutControls(parts, partsWork, session), session);
  const refresh = (): void => {
    table.refresh(partsWork.selectedPart, partsWork.secondPart);
    partsPanel.refresh();
    view.invalidate();
  };
  parts.on('changed', ({ groups }) => groups && view.cloud.partGroupsChanged());
  // It tells of every change of the parts, too, after it has forgotten what is gone.
  partsWork.on('changed', refresh);
  hullStore.on('changed', () => partsPanel.refresh());
  session.on('changed', () => partsPanel.refresh());
  return { hulls, hullStore, partPicking, partsPanel, partsWork };
}
