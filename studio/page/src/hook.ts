/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * window.studio: what tests and the curious may read.
 */

import type { Asking } from './asking';
import type { Connection } from './connection';
import type { ColorModes } from './color_modes';
import type { PartsHook } from './parts_hook';
import type { Picking } from './picking';
import type { PointCloudView } from './point_cloud_view';
import type { Questions } from './questions';
import type { SectionCut } from './section';
import type { Session } from './session';

export interface StudioHook extends PartsHook {
  /** Numbers of what there is. */
  counts(): { places: number; seeds: number; questions: number; instances: number; unlabeled: number; undo: number; redo: number; revision: number };
  labelOf(place: number): number;
  groupOf(place: number): number;
  instances(): { label: number; class: string; name: string; size: number }[];
  seeds(): { key: number; place: number; label: number | null }[];
  position(place: number): [number, number, number];
  /** Pixels from the upper left corner of the window; null behind the camera. */
  project(place: number): { x: number; y: number } | null;
  /** Whether neither the section nor a hidden instance keeps it from being drawn. */
  drawn(place: number): boolean;
  /** What a click at these pixels of the window would take. */
  pickAt(x: number, y: number): number | null;
  /** Whether a click where it is takes it. */
  visible(place: number): boolean;
  /** The seed that is asked about. */
  question(): { seed: number; place: number; size: number } | null;
  asking(): string | null;
  mode(): string;
  writer(): boolean;
  connected(): boolean;
  ceiling(): number;
  frames(): number;
  /** Milliseconds of JavaScript that the last change took. */
  lastApply(): number;
  /** When nothing is awaited, nothing moves and all is drawn. */
  idle(): Promise<void>;
}

export function makeHook(
  session: Session,
  view: PointCloudView,
  picking: Picking,
  section: SectionCut,
  colors: ColorModes,
  questions: Questions,
  asking: Asking,
  connection: Connection,
  partsHook: PartsHook,
  isDrawn: (place: number) => boolean,
  busy: () => boolean,
): StudioHook {
  const corner = (): DOMRect => view.canvas.getBoundingClientRect();
  const hook: StudioHook = {
    ...partsHook,
    counts: () => ({
      places: session.places,
      seeds: session.seeds.size,
      questions: session.questions,
      instances: session.instances.size,
      unlabeled: session.unlabeled,
      undo: session.undo,
      redo: session.redo,
      revision: session.revision,
    }),
    labelOf: (place) => session.labels[place],
    groupOf: (place) => session.groups[place],
    instances: () => [...session.instances.values()].map((one) => ({ ...one })),
    seeds: () => [...session.seeds.values()].map(({ key, place, label }) => ({ key, place, label })),
    position: (place) => picking.positionOf(place).toArray(),
    project(place) {
      const at = picking.project(place);
      return at && { x: at.x + corner().left, y: at.y + corner().top };
    },
    drawn: isDrawn,
    pickAt: (x, y) => picking.pick(x - corner().left, y - corner().top),
    visible(place) {
      const at = hook.project(place);
      const { left, top, right, bottom } = corner();
      if (!at || at.x < left || at.y < top || at.x >= right || at.y >= bottom) return false;
      // Another card or panel may lie over the cloud there.
      return document.elementFromPoint(at.x, at.y) === view.canvas && hook.pickAt(at.x, at.y) === place;
    },
    question: () => questions.current && { ...questions.current },
    asking: () => asking.current?.kind ?? null,
    mode: () => colors.mode,
    writer: () => session.writer,
    connected: () => connection.isOpen && session.ready,
    ceiling: () => section.ceilingHeight,
    frames: () => view.frames,
    lastApply: () => session.lastApply,
    async idle() {
      // Quiet twice in a row: an answer may start something new.
      for (let quiet = 0; quiet < 2; ) {
        await new Promise((done) => setTimeout(done, 25));
        quiet = busy() ? 0 : quiet + 1;
      }
    },
  };
  return hook;
}
