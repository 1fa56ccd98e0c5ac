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
import type { Connection } from './connection';
import type { Corrections } from './corrections';
import type { Doubt } from './doubt';
import type { ExportDialog } from './export_dialog';
import type { Help } from './help';
import type { InstanceTable } from './instance_table';
import type { InstancesPanel } from './instances_panel';
import type { Lasso } from './lasso';
import type { WorkMode } from './modes';
import type { PartsBench } from './parts_commands';
import type { PartsState } from './parts_state';
import type { Picking } from './picking';
import type { Questions } from './questions';
import type { SectionCut } from './section';
import type { SeedMarkers } from './seed_markers';
import type { Session } from './session';

export interface Workbench extends PartsBench {
  actions: Actions;
  area: HTMLElement;
  asking: Asking;
  connection: Connection;
  corrections: Corrections;
  diagonal: number;
  doubt: Doubt;
  help: Help;
  isDrawn: (place: number) => boolean;
  lasso: Lasso;
  panel: InstancesPanel;
  parts: PartsState;
  picking: Picking;
  questions: Questions;
  saving: Record<WorkMode, ExportDialog>;
  section: SectionCut;
  seeds: SeedMarkers;
  session: Session;
  table: InstanceTable;
}
