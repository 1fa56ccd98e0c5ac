/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What clicks and a resting cursor do, by what is open.
 */

import { connectPartsPointer } from './parts_commands';
import type { Workbench } from './workbench';

export function connectPointer(bench: Workbench): void {
  const { asking, camera, colors, corrections, lasso, modes, picking, pointer, questions, session, status, view } = bench;

  pointer.on('click', ({ x, y, shift, alt }) => {
    if (modes.isParts) return;
    const place = picking.pick(x, y);
    if (place === null) {
      if (asking.current?.kind === 'point') asking.cancel();
      return;
    }
    if (asking.clicked(place, alt)) return;
    if (alt) corrections.takeFrom(place);
    else if (shift) void corrections.giveToActive(place);
    else corrections.ask(place);
  });

  pointer.on('double', ({ x, y }) => {
    if (modes.isParts) return;
    // The first of the two clicks opened a card, which is not what was wanted.
    if (asking.current?.kind === 'point') asking.cancel();
    const place = picking.pick(x, y);
    if (place !== null) void camera.focus(picking.positionOf(place));
  });

  pointer.on('rest', ({ x, y }) => {
    if (modes.isParts) return;
    const place = picking.pick(x, y);
    if (place === null) {
      status.here('');
      corrections.clearPreview();
      return;
    }
    const seed = session.seedAt.get(place);
    const what = `${session.nameOf(session.labels[place])}${seed ? ' · a seed' : ''}`;
    status.here(what);
    colors.from(place);
    if (!asking.current && !questions.current && !lasso.on && colors.mode !== 'cid') void corrections.preview(place);
  });

  pointer.on('move', () => {
    if (!asking.current) corrections.clearPreview();
  });

  connectPartsPointer(bench);

  // The middle counts for keys as soon as the keyboard moves the view.
  view.canvas.addEventListener('keydown', (event) => {
    if (event.key.startsWith('Arrow')) pointer.useMiddle();
  });
}
