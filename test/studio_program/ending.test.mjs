/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The program ends when it is told to, says nothing that it should not, and opens again.
 */

import assert from 'node:assert/strict';
import { chmodSync, existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import {
  Program,
  sampleScan,
  start,
  temporaryFolder,
  until,
  within,
} from './client.mjs';
import { smallRoom, writePositions } from './clouds.mjs';
import { assertSameSession, stateOf } from './session_checks.mjs';

function smallScan(t, points = 2000) {
  const scan = join(temporaryFolder(t), 'small.pcd');
  writePositions(scan, smallRoom(points));
  return scan;
}

for (const signal of ['SIGINT', 'SIGTERM'])
  test(`${signal} ends it with a close frame and 0, and it opens again`, async (t) => {
    const scan = smallScan(t);
    const program = await start(t, [scan, '--seeds', '8', '--quiet']);
    const page = await program.connect();
    const onlooker = await program.connect();
    const replica = await stateOf(page);
    replica.apply(await page.do('click', { place: 7, class: 'chair' }));
    assert.deepEqual(await program.kill(signal), { code: 0, signal: null });
    for (const each of [page, onlooker])
      assert.equal((await within(each.closed, 'the close frame')).code, 1001);
    assert.equal(program.stderr, '');
    assert.equal(program.stdout, `Open ${program.url}\n`);
    const again = await start(t, [scan]);
    assertSameSession((await stateOf(await again.connect())).content, replica.content);
  });

test('SIGINT in the middle of work ends it soon, and the work was not begun', async (t) => {
  const scan = sampleScan(t);
  const program = await start(t, [scan, '--seeds', '4']);
  const page = await program.connect();
  const replica = await stateOf(page);
  page.do('propose', { seeds: 20000 }).catch(() => {});
  await page.event(
    ({ header }) => header.event === 'progress' && header.id !== null,
    'progress',
  );
  const begin = Date.now();
  assert.deepEqual(await program.interrupt(), { code: 0, signal: null });
  t.diagnostic(`ended after ${Date.now() - begin} ms`);
  assert.equal((await page.closed).code, 1001);
  const again = await start(t, [scan]);
  assertSameSession((await stateOf(await again.connect())).content, replica.content);
});

test('SIGINT while the session is opened ends it with 0, and it opens again', async (t) => {
  const scan = sampleScan(t);
  const program = await start(t, [scan, '--seeds', '5000']);
  assert.deepEqual(await program.interrupt(), { code: 0, signal: null });
  assert.doesNotMatch(program.stderr, /terminate|exception|abort/i);
  const again = await start(t, [scan, '--seeds', '5']);
  assert.equal((await (await again.connect()).ask('state')).seeds.length, 5);
});

/** A program that stands for xdg-open. */
function browser(t, script) {
  const folder = temporaryFolder(t);
  const path = join(folder, 'xdg-open');
  writeFileSync(path, `#!/bin/sh\n${script}\n`);
  chmodSync(path, 0o755);
  return { DISPLAY: ':99', PATH: `${folder}:${process.env.PATH}` };
}

test('a browser is opened with the address', async (t) => {
  const told = join(temporaryFolder(t), 'told');
  const env = browser(t, `echo "$1" > '${told}.part' && mv '${told}.part' '${told}'`);
  const program = await start(t, [smallScan(t), '--seeds', '4'], {
    env,
    browser: true,
  });
  await until(() => existsSync(told), 'the browser');
  assert.equal(readFileSync(told, 'utf8').trim(), program.url.href);
  assert.equal((await program.interrupt()).code, 0);
});

test(
  'it serves while xdg-open runs: some run the browser until it is closed',
  async (t) => {
    const env = browser(t, 'exec sleep 8');
    const program = new Program([smallScan(t), '--seeds', '4'], { env, browser: true });
    t.after(() => program.kill());
    await within(program.opened, 'the address');
    await within(program.enter(), 'the page while the browser runs', 5000);
  },
);

test('the session is free when the program ends, though its browser stays', async (t) => {
  const env = browser(t, '(sleep 5 >/dev/null 2>&1 &) ; exit 0');
  const scan = smallScan(t);
  const args = [scan, '--seeds', '4'];
  const program = await start(t, args, { env, browser: true });
  await (await program.connect()).ask('state');
  await program.kill();
  const again = await start(t, [...args, '--port', String(program.port)]);
  await (await again.connect()).ask('state');
});
