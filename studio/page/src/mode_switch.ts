/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * From labels to parts and back: what belongs to the other mode is put away.
 */

import type { HullStore } from './hull_store';
import type { WorkMode } from './modes';
import type { Workbench } from './workbench';

export function connectModes(bench: Workbench, root: HTMLElement, hullStore: HullStore): void {
  const { asking, colors, connection, corrections, hulls, keys, lasso, modes, panel, parts, partsPanel, pointer, questions, seeds, status, view } = bench;

  const leaveLabels = (): void => {
    asking.close();
    questions.leave();
    lasso.toggle(false);
    corrections.clearPreview();
  };

  const showMode = (mode: WorkMode): void => {
    const isParts = mode === 'parts';
    root.dataset.mode = mode;
    keys.mode = mode;
    panel.element.hidden = isParts;
    partsPanel.element.hidden = !isParts;
    seeds.setActive(!isParts);
    view.pointsShown = true;
    hulls.show(hulls.shown, isParts);
    hullStore.want(isParts);
    view.uniforms.hidesLabels.value = !isParts;
    view.cloud.showGroups(mode);
    colors.workOn(mode);
    status.here('');
    pointer.useMiddle();
    bench.toolbarChanged?.();
  };

  modes.on('changed', (mode) => {
    if (mode === 'parts') {
      leaveLabels();
      void parts.load();
    }
    showMode(mode);
    bench.messages.say(mode === 'parts' ? 'Parts' : 'Labels');
    view.canvas.focus({ preventScroll: true });
  });
  connection.on('parts', (message) => {
    parts.apply(message);
    bench.session.noteRevision(message.header);
  });
  connection.on('connected', () => {
    // Only now is there someone to ask for the parts.
    modes.set(modes.wanted);
    parts.reload();
  });
  root.dataset.mode = modes.current;
}
