/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What the tool put into the page: facts as JSON, arrays of numbers as base64.
 */

import type { HullFacts, Tightness } from '../protocol';

export type Kind = 'labels' | 'groups' | 'parts' | 'values';

/** What a color stands for: a label, a group or a part. */
export interface Mark extends Partial<HullFacts>, Partial<Tightness> {
  /** By which points and hulls have it; 0 for none. */
  index: number;
  name: string;
  /** Of the whole scan. */
  points: number;
}

/** The report of the run, without what differs from run to run. */
export interface Report {
  tool: string;
  version: string;
  input: string;
  remarks?: string[];
  parameters: Record<string, string | number | boolean | null>;
  points: { in: number; finite: number; grouped: number; dropped?: number };
  density?: { weighted: boolean; isolated_points: number };
  blind_spot?: { points: number };
  seeds?: { number: number; coverage: number };
  parts?: number;
  score?: { field: string; points: number; share_right: number };
  exact_vertices?: number;
  places?: { free: number; refused_share: number };
  tightness?: Omit<Tightness, 'part'> & { volume: number };
}

export interface Facts {
  kind: Kind;
  name: string;
  /** What the values are, where there are any. */
  values: string;
  points: number;
  origin: [number, number, number];
  low: [number, number, number];
  high: [number, number, number];
  /** How many there are; those with the most points are listed, by their index. */
  indices: number;
  marks: Mark[];
  hulls: HullFacts[];
  report: Report;
}

function textOf(id: string): string {
  const element = document.getElementById(id);
  if (!element) throw new Error(`This page is not whole: '${id}' is missing. Make it again.`);
  return element.textContent ?? '';
}

export function readFacts(): Facts {
  return JSON.parse(textOf('facts')) as Facts;
}

export function readBytes(id: string): Uint8Array {
  const text = atob(textOf(id));
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; i++) bytes[i] = text.charCodeAt(i);
  return bytes;
}

export const readFloats = (id: string): Float32Array => new Float32Array(readBytes(id).buffer);
export const readNumbers = (id: string): Uint32Array => new Uint32Array(readBytes(id).buffer);
