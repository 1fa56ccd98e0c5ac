/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The real program, on a copy of a scan in a folder of its own.
 */

import { spawn } from 'node:child_process';
import { cpSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';

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
