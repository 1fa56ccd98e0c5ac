/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What keys, buttons and the mouse work on.
 */

import type { Actions } from './actions';
import type { Asking } from './asking';
import type { Camera } from './camera';
import type { ColorModes } from './color_modes';
import type { Connection } from './connection';
import type { Corrections } from './corrections';
import type { Doubt } from './doubt';
import type { ExportDialog } from './export_dialog';
import type { Help } from './help';
import type { InstanceTable } from './instance_table';
import type { InstancesPanel } from './instances_panel';
import type { Keys } from './keys';
import type { Lasso } from './lasso';
import type { Messages } from './messages';
import type { Picking } from './picking';
import type { PointCloudView } from './point_cloud_view';
import type { Pointer } from './pointer';
import type { Questions } from './questions';
import type { SectionCut } from './section';
import type { SeedMarkers } from './seed_markers';
import type { Session } from './session';
import type { StatusBar } from './status';

export interface Workbench {
  actions: Actions;
  area: HTMLElement;
  asking: Asking;
  camera: Camera;
  colors: ColorModes;
  connection: Connection;
  corrections: Corrections;
  diagonal: number;
  doubt: Doubt;
  help: Help;
  isDrawn: (place: number) => boolean;
  keys: Keys;
  lasso: Lasso;
  messages: Messages;
  panel: InstancesPanel;
  picking: Picking;
  pointer: Pointer;
  questions: Questions;
  saving: ExportDialog;
  section: SectionCut;
  seeds: SeedMarkers;
  session: Session;
  status: StatusBar;
  table: InstanceTable;
  view: PointCloudView;
  toolbarChanged?: () => void;
}
