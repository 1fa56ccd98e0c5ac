/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The real program, on a copy of a scan in a folder of its own.
 */

import { spawn } from 'node:child_process';
import { cpSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';

/** How many points of a binary PLY have each label. */
export function labelCounts(path) {
  const bytes = readFileSync(path);
  const end = bytes.indexOf('end_header\n') + 'end_header\n'.length;
  const header = bytes.toString('latin1', 0, end);
  const points = Number(/element vertex (\d+)/.exec(header)[1]);
  const size = { char: 1, uchar: 1, short: 2, ushort: 2, int: 4, uint: 4, float: 4, double: 8 };
  const vertex = header.slice(header.indexOf('element vertex')).split('\nelement')[0];
  let at = 0;
  let stride = 0;
  for (const [, type, name] of vertex.matchAll(/property (\w+) (\w+)/g)) {
    if (name === 'label') at = stride;
    stride += size[type];
  }
  const counts = new Map();
  for (let i = 0; i < points; i++) {
    const label = bytes.readUInt32LE(end + i * stride + at);
    counts.set(label, (counts.get(label) ?? 0) + 1);
  }
  return counts;
}

export function copyOf(scan) {
  const folder = mkdtempSync(join(tmpdir(), 'studio-'));
  cpSync(scan, join(folder, basename(scan)));
  return { folder, scan: join(folder, basename(scan)), remove: () => rmSync(folder, { recursive: true }) };
}

/** Starts the program; the promise is kept once it has told its address. */
export function startProgram(program, scan, options = []) {
  const child = spawn(program, [scan, '--no-browser', ...options], { stdio: ['ignore', 'pipe', 'inherit'] });
  const ended = new Promise((resolve) => child.on('exit', resolve));
  return new Promise((resolve, reject) => {
    let printed = '';
    child.stdout.on('data', (bytes) => {
      printed += bytes;
      const url = /Open (http\S+)/.exec(printed)?.[1];
      if (url) resolve({ url, end: (signal) => (child.kill(signal), ended) });
    });
    child.on('exit', () => reject(new Error(`the program ended: ${printed}`)));
  });
}
