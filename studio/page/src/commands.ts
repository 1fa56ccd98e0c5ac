/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What each key and button does.
 */

import { bindings } from './bindings';
import type { Commands } from './bindings';
import { MARK_GROUP } from './cloud_geometry';
import type { Workbench } from './workbench';
import { chooseViewPoint } from './view_points';

export function connectCommands(bench: Workbench): Commands {
  const { actions, asking, camera, colors, corrections, doubt, help, isDrawn, keys, lasso, messages, modes } = bench;
  const { panel, partsWork, picking, pointer, questions, saving, section, seeds, session, table, view } = bench;
  const here = (): number | null => picking.pick(pointer.cursor.x, pointer.cursor.y);
  const clearMarks = (): void => {
    view.cloud.mark(MARK_GROUP, new Uint32Array(0));
    view.invalidate();
  };
  const atCursor = (act: (place: number) => void): void => {
    const place = here();
    if (place === null) messages.note('There is no point under the cursor.');
    else act(place);
  };
  const step = async (what: 'undo' | 'redo'): Promise<void> => {
    if (modes.isParts) return partsWork.step(what);
    const n = session[what];
    if (session.ready && n === 0) {
      messages.note(`There is nothing to ${what}.`);
      return;
    }
    // The open question may be about something that is no more.
    const asked = questions.current !== null;
    asking.close();
    questions.leave();
    const done = await actions.change({ do: what });
    if (done && asked) await questions.start();
  };
  const commands: Commands = {
    modes: () => modes.toggle(),
    next: () => {
      lasso.toggle(false);
      // A question is about what is seen; these two show something measured.
      if (colors.mode === 'cid' || colors.mode === 'doubt') colors.toggle(colors.mode);
      void questions.start();
    },
    skip: () => {
      lasso.toggle(false);
      void questions.skip();
    },
    escape: () => {
      if (modes.isParts) partsWork.select(null);
      else if (asking.current) asking.cancel();
      else if (lasso.on) lasso.toggle(false);
      else {
        questions.leave();
        clearMarks();
      }
      corrections.clearPreview();
    },
    pick: () => {
      if (asking.current) asking.togglePicking();
      else messages.note('Click a point first; then this picks the instance it belongs to.');
    },
    backToCard: () => asking.focus(),
    clickHere: () => atCursor((place) => corrections.ask(place)),
    giveHere: () => atCursor((place) => void corrections.giveToActive(place)),
    removeSeed: () => void corrections.removeSeed(pointer.cursor.x, pointer.cursor.y, isDrawn),
    previews: () => corrections.togglePreviews(),
    undo: () => void step('undo'),
    redo: () => void step('redo'),
    lasso: () => {
      questions.leave();
      lasso.toggle();
    },
    nextDoubt: () => {
      asking.close();
      questions.leave();
      void doubt.next();
    },
    merge: () => void panel.merge(),
    list: () => panel.focus(),
    isolate: () => panel.isolateActive(),
    showAll: () => table.showAll(),
    colors: (by) => {
      colors.step(by);
      messages.note(`Colors: ${colors.name}`);
    },
    labels: () => {
      colors.toggle('label');
      messages.note(`Colors: ${colors.name}`);
    },
    doubt: () => colors.toggle('doubt'),
    pointSize: (factor) => {
      view.pointSize = Math.min(6, Math.max(0.3, view.pointSize * factor));
      view.invalidate();
    },
    lighting: () => {
      view.lighting.enabled = !view.lighting.enabled;
      bench.toolbarChanged?.();
      view.invalidate();
    },
    seeds: () => seeds.toggle(),
    ceiling: () => {
      section.suspended = false;
      section.toggleCeiling();
    },
    moveCeiling: (part) => section.moveCeiling(part),
    section: () => section.toggleBox(),
    home: () => void camera.home(),
    top: () => void camera.top(),
    focus: () => {
      const part = modes.isParts ? partsWork.selectedPart : null;
      if (part) partsWork.focus(part);
      else atCursor((place) => void camera.focus(picking.positionOf(place)));
    },
    turn: (right, up) => camera.turn(right, up),
    zoom: (factor) => camera.zoom(factor),
    save: () => saving[modes.current].open(),
    help: () => help.toggle(),
  };
  keys.add(...bindings(commands));
  panel.goTo = (label) => {
    const places = session.placesOf(label);
    if (places.length === 0) {
      messages.note(`${session.nameOf(label)} has no points.`);
      return;
    }
    const { target, direction, distance } = chooseViewPoint(view, camera, places, bench.diagonal, isDrawn);
    void camera.lookFrom(target, direction, distance);
  };
  return commands;
}
