/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * How long a person waits: node measure.mjs SCAN [CLICKS] [OPTION...]
 *
 * On a busy machine look at the time of the processors: of all threads together, so it
 * is more than the person waits on an idle one.
 */

import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { loadavg, tmpdir } from 'node:os';
import { join } from 'node:path';
import { Program } from './client.mjs';
import { randomNumbers } from './clouds.mjs';

const [scan, count = '100', ...options] = process.argv.slice(2);
const clicks = Number(count);
const folder = mkdtempSync(join(tmpdir(), 'pcl_cid_studio_'));

const times = (list) => {
  const sorted = [...list].sort((a, b) => a - b);
  const at = (share) =>
    sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))];
  return { p50: at(0.5), p95: at(0.95), most: sorted.at(-1) };
};
const shown = ({ p50, p95, most }, digits = 1) =>
  `p50 ${p50.toFixed(digits)}, p95 ${p95.toFixed(digits)}, most ${most.toFixed(digits)}`;

async function timed(work) {
  const begin = performance.now();
  const result = await work();
  return [performance.now() - begin, result];
}

/** Milliseconds that the program has worked, as Linux counts: in steps of 10. */
function worked() {
  const path = `/proc/${program.pid}/stat`;
  if (!existsSync(path)) return NaN;
  const fields = readFileSync(path, 'latin1').split(') ')[1].split(' ');
  return 10 * (Number(fields[11]) + Number(fields[12]));
}

console.log(
  `load ${loadavg()
    .map((each) => each.toFixed(1))
    .join(' ')}`,
);
const begin = performance.now();
const program = new Program([scan, '--session', join(folder, 'a.session'), ...options]);
try {
  await program.opened;
  console.log(`address after ${(performance.now() - begin).toFixed(0)} ms`);
  const [positions] = await timed(async () => {
    await program.enter();
    await program.positions();
  });
  console.log(`positions in ${positions.toFixed(0)} ms`);
  const page = await program.connect();
  const { seeds, arrays } = await page.ask('state');
  console.log(
    `state after ${(performance.now() - begin).toFixed(0)} ms (${worked()} of the processors), ${page.lastBytes} bytes`,
  );
  const places = arrays.labels.length;
  const [again] = await timed(() => page.ask('state'));
  console.log(`state again in ${again.toFixed(0)} ms`);
  for (const { key } of seeds) await page.do('answer', { seed: key, class: 'thing' });
  const random = randomNumbers(1);
  const labels = seeds.length;
  const [durations, processor, bytes, changed] = [[], [], [], []];
  for (let k = 0; k < clicks; ++k) {
    const place = Math.floor(random() * places);
    const label = 1 + (k % labels);
    const before = worked();
    const [duration, delta] = await timed(() => page.do('click', { place, label }));
    durations.push(duration);
    processor.push(worked() - before);
    bytes.push(page.lastBytes / 1024);
    changed.push(delta.arrays.places.length);
  }
  console.log(`${clicks} clicks, ms: ${shown(times(durations))}`);
  console.log(`of the processors, ms: ${shown(times(processor), 0)}`);
  console.log(
    `answers, KiB: ${shown(times(bytes), 0)}; places: ${shown(times(changed), 0)}`,
  );
  for (const word of ['preview', 'cid', 'inspect']) {
    const list = [];
    for (let k = 0; k < 10; ++k)
      list.push(
        (
          await timed(() => page.ask(word, { place: Math.floor(random() * places) }))
        )[0],
      );
    console.log(`${word}, ms: ${shown(times(list))}`);
  }
  const [undo] = await timed(() => page.do('undo'));
  console.log(`undo in ${undo.toFixed(0)} ms`);
  const [doubt] = await timed(() => page.ask('doubt'));
  const [more] = await timed(() => page.ask('doubt'));
  console.log(`doubt in ${doubt.toFixed(0)} ms, again in ${more.toFixed(0)} ms`);
} finally {
  await program.kill();
  rmSync(folder, { recursive: true });
}
console.log(
  `load ${loadavg()
    .map((each) => each.toFixed(1))
    .join(' ')}`,
);
