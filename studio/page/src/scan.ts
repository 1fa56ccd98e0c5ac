/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The scan over HTTP: its description, then positions and colors as they stream in.
 */

import type { ScanInfo } from './protocol';

export interface OpenedScan {
  info: ScanInfo;
  /** On their way while the page is built. */
  positions: Promise<Response>;
  colors: Promise<Response> | null;
}

export async function openScan(): Promise<OpenedScan> {
  const info = await fetchScanInfo();
  return { info, positions: fetch('/api/positions'), colors: info.has_color ? fetch('/api/colors') : null };
}

async function fetchScanInfo(): Promise<ScanInfo> {
  const answer = await fetch('/api/scan');
  if (answer.status === 401) {
    throw new Error('This page needs the address that the program printed, with its token.');
  }
  if (!answer.ok) throw new Error(`The server did not describe the scan (${answer.status}).`);
  return (await answer.json()) as ScanInfo;
}

/**
 * Fills `target` as the bytes come. `arrived` is told how many whole elements of `stride` bytes are
 * there; it is called for each piece, so that the first points are drawn before the last ones come.
 */
async function stream(
  requested: Promise<Response>,
  target: Uint8Array,
  stride: number,
  arrived: (from: number, to: number) => void,
): Promise<void> {
  const answer = await requested;
  const url = new URL(answer.url).pathname;
  if (!answer.ok || !answer.body) throw new Error(`The server did not send ${url} (${answer.status}).`);
  const reader = answer.body.getReader();
  let bytes = 0;
  let told = 0;
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    if (bytes + value.length > target.length) throw new Error(`${url} is longer than the scan.`);
    target.set(value, bytes);
    bytes += value.length;
    const whole = Math.floor(bytes / stride);
    if (whole > told) arrived(told, whole);
    told = whole;
  }
  if (bytes !== target.length) throw new Error(`${url} ended early; reload the page to try again.`);
}

export function streamPositions(
  requested: Promise<Response>,
  positions: Float32Array,
  arrived: (from: number, to: number) => void,
): Promise<void> {
  return stream(requested, new Uint8Array(positions.buffer), 12, arrived);
}

/** Colors come as three bytes and are kept as four, which is how graphics cards like them. */
export function unpackColors(packed: Uint8Array, colors: Uint8Array, from: number, to: number): void {
  for (let i = from; i < to; i++) {
    colors[4 * i] = packed[3 * i];
    colors[4 * i + 1] = packed[3 * i + 1];
    colors[4 * i + 2] = packed[3 * i + 2];
  }
}

export function streamColors(
  requested: Promise<Response>,
  colors: Uint8Array,
  arrived: (from: number, to: number) => void,
): Promise<void> {
  const packed = new Uint8Array((colors.length / 4) * 3);
  return stream(requested, packed, 3, (from, to) => {
    unpackColors(packed, colors, from, to);
    arrived(from, to);
  });
}
