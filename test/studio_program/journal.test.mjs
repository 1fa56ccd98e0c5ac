/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The program is killed again and again: what it answered is there when it starts anew.
 *
 * STUDIO_TEST_KILLS=200 STUDIO_TEST_SEED=7 node --test journal.test.mjs
 */

import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';
import { Program, start, temporaryFolder, within } from './client.mjs';
import { randomNumbers, smallRoom, writePositions } from './clouds.mjs';
import { RandomActions, assertSameSession, stateOf } from './session_checks.mjs';

const KILLS = Number(process.env.STUDIO_TEST_KILLS ?? 12);
const SEED = Number(process.env.STUDIO_TEST_SEED ?? 3);

const pause = (milliseconds) =>
  new Promise((resolve) => setTimeout(resolve, milliseconds));

test(`${KILLS} kills`, async (t) => {
  const random = randomNumbers(SEED);
  const actions = new RandomActions(random);
  const scan = join(temporaryFolder(t), 'small.pcd');
  writePositions(scan, smallRoom(2000));
  const args = [scan, '--seeds', '8', '--threads', '1'];
  let known = null; // the session as it was answered
  let open = null; // the word of the action that was not
  const seen = { lost: 0, kept: 0 };
  for (let kill = 0; kill <= KILLS; ++kill) {
    if (random() < 0.2) {
      const early = new Program(args);
      await pause(random() * 150);
      await early.kill();
    }
    const program = await start(t, args);
    const page = await program.connect();
    const replica = await stateOf(page);
    if (known) {
      const more = replica.summary.revision - known.revision;
      if (more !== 0) await requireOneMore(page, replica, known, open);
      else assertSameSession(replica.content, known);
      if (open) ++seen[more ? 'kept' : 'lost'];
    }
    if (kill === KILLS) {
      const { code } = await program.interrupt();
      assert.equal(code, 0);
      break;
    }
    for (let count = 1 + Math.floor(random() * 8); count > 0; --count) {
      const [word, fields, arrays, isPossible] = actions.next(replica);
      const answered = page.do(word, fields, arrays);
      if (isPossible) replica.apply(await answered);
      else await answered.catch(() => {});
    }
    known = replica.content;
    const [word, fields, arrays, isPossible] = actions.next(replica);
    const answered = page.do(word, fields, arrays).then(
      (answer) => (isPossible ? replica.apply(answer) : null),
      () => {},
    );
    open = isPossible ? word : null;
    const revision = known.revision;
    // Mostly before the answer is there; an action takes some milliseconds.
    for (let turns = Math.floor(random() * 8); turns > 0; --turns)
      await new Promise((resolve) => setImmediate(resolve));
    if (random() < 0.5) await pause(random() * 4);
    await program.kill();
    await within(answered, 'the end of the socket');
    if (replica.summary.revision > revision) open = null; // it was answered after all
    known = {
      ...replica.content,
      labels: replica.labels.slice(),
      groups: replica.groups.slice(),
    };
  }
  t.diagnostic(`unanswered actions: ${seen.kept} are there, ${seen.lost} are not`);
});

/** The action that nobody answered is there, whole: what takes it back leads to what
 *  was answered. */
async function requireOneMore(page, replica, known, word) {
  assert.ok(word, 'there is an action more, and none was without an answer');
  assert.equal(replica.summary.revision, known.revision + 1);
  const [there, back] = word === 'undo' ? ['undo', 'redo'] : ['redo', 'undo'];
  const step = word === 'undo' ? -1 : 1;
  assert.equal(replica.summary.undo, known.undo + step);
  assert.equal(
    replica.summary.redo,
    word === 'redo' || word === 'undo' ? known.redo - step : 0,
  );
  const after = {
    ...replica.content,
    labels: replica.labels.slice(),
    groups: replica.groups.slice(),
  };
  replica.apply(await page.do(back));
  assertSameSession(replica.content, known, { exact: false });
  replica.apply(await page.do(there));
  assertSameSession(replica.content, after, { exact: false });
}
