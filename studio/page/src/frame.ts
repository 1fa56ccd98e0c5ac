/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * One message of the socket as bytes: a header in JSON, then its arrays.
 */

import type { Arrays, Header, Message, TypedArray } from './protocol';

interface ArrayEntry {
  name: string;
  type: 'u32' | 'f32';
  length: number;
}

const padded = (bytes: number): number => (bytes + 3) & ~3;

export function encodeFrame(header: Header, arrays: Arrays = {}): ArrayBuffer {
  const entries: ArrayEntry[] = Object.entries(arrays).map(([name, array]) => ({
    name,
    type: array instanceof Float32Array ? 'f32' : 'u32',
    length: array.length,
  }));
  const full = entries.length > 0 ? { ...header, arrays: entries } : header;
  const text = new TextEncoder().encode(JSON.stringify(full));
  let at = padded(4 + text.length);
  const total = Object.values(arrays).reduce((sum, array) => sum + array.byteLength, at);
  const frame = new ArrayBuffer(total);
  new DataView(frame).setUint32(0, text.length, true);
  new Uint8Array(frame, 4, text.length).set(text);
  for (const array of Object.values(arrays)) {
    new Uint8Array(frame, at, array.byteLength).set(
      new Uint8Array(array.buffer, array.byteOffset, array.byteLength),
    );
    at += array.byteLength;
  }
  return frame;
}

/** The arrays of the result are views into the frame: nothing is copied. */
export function decodeFrame(frame: ArrayBuffer): Message {
  const length = new DataView(frame).getUint32(0, true);
  const header = JSON.parse(new TextDecoder().decode(new Uint8Array(frame, 4, length))) as Header;
  const arrays: Arrays = {};
  let at = padded(4 + length);
  for (const entry of (header.arrays as ArrayEntry[] | undefined) ?? []) {
    const array: TypedArray =
      entry.type === 'f32'
        ? new Float32Array(frame, at, entry.length)
        : new Uint32Array(frame, at, entry.length);
    arrays[entry.name] = array;
    at += array.byteLength;
  }
  return { header, arrays };
}
