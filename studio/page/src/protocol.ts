/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The messages of doc/studio_protocol.md as types.
 */

export interface ScanInfo {
  name: string;
  places: number;
  points: number;
  low: [number, number, number];
  high: [number, number, number];
  origin: [number, number, number];
  up: [number, number, number];
  has_color: boolean;
  classes: { name: string }[];
  session: string;
  version: string;
  /** Formats that parts can be exported in. */
  meshes: string[];
  scenes: { name: string; help: string }[];
}

export interface Seed {
  key: number;
  place: number;
  label: number | null;
  size: number;
}

export interface Instance {
  label: number;
  class: string;
  name: string;
  size: number;
}

export interface Part {
  /** The lowest of its groups. */
  part: number;
  groups: number[];
  size: number;
  /** CID_g of its last merge; null for one group, and for what was joined by hand. */
  height: number | null;
  splits: boolean;
  dropped: boolean;
  exact: boolean;
}

export interface PartsSummary {
  /** 0 before the first decomposition. */
  groups: number;
  decomposition: number;
  heights: number[];
  list: Part[];
  undo: number;
  redo: number;
}

export interface HullFacts {
  part: number;
  vertices: number;
  triangles: number;
  volume: number;
  thickness: number;
  thickened: boolean;
  boxed: boolean;
}

export interface Tightness {
  part: number;
  max_concavity: number;
  mean_concavity: number;
  free_share: number;
}

export interface Question {
  seed: number;
  place: number;
  size: number;
}

/** What a person says a place is: a new instance of a class, or an instance that is there (0: none). */
export type Answer = { class: string } | { label: number };

export type TypedArray = Uint32Array | Float32Array;
export type Arrays = Record<string, TypedArray>;

export interface Header {
  [field: string]: unknown;
}

export interface Message {
  header: Header;
  arrays: Arrays;
}

/** The group of a place that no seed reaches. */
export const NO_GROUP = 0xffffffff;
