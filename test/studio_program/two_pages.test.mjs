/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Several pages, and several programs, on one session: one of them writes.
 */

import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';
import { runToEnd, sampleScan, start, temporaryFolder } from './client.mjs';
import { randomNumbers, smallRoom, writePositions } from './clouds.mjs';
import {
  RandomActions,
  assertRefused,
  assertSameSession,
  assertSentence,
  stateOf,
} from './session_checks.mjs';

function smallScan(t) {
  const scan = join(temporaryFolder(t), 'small.pcd');
  writePositions(scan, smallRoom(2000));
  return scan;
}

const isChange = ({ header }) => header.event === 'changed' && !header.writer;
const isPromotion = ({ header }) => header.event === 'changed' && header.writer;

test('a second page looks on, and works on when the first is gone', async (t) => {
  const program = await start(t, [smallScan(t), '--seeds', '8']);
  const first = await program.connect();
  const second = await program.connect();
  const replica = await stateOf(first);
  assert.equal((await second.ask('state')).writer, false);
  const onlooker = await stateOf(second);

  await t.test('what it does is refused, and changes nothing', async () => {
    await assertRefused(second.do('propose', { seeds: 1 }), /page/);
    await assertRefused(second.do('undo'), /page/);
    assertSameSession((await stateOf(second)).content, replica.content);
    assert.equal(first.events.filter(isChange).length, 0);
  });

  await t.test('events keep its replica equal', async () => {
    const actions = new RandomActions(randomNumbers(8));
    let possible = 0;
    for (let k = 0; k < 60; ++k) {
      const [word, fields, arrays, isPossible] = actions.next(replica);
      if (!isPossible) {
        await assertRefused(first.do(word, fields, arrays));
        continue;
      }
      ++possible;
      replica.apply(await first.do(word, fields, arrays));
      const { revision } = replica.summary;
      const { header, arrays: delta } = await second.event(
        (frame) => isChange(frame) && frame.header.revision === revision,
      );
      assert.equal(header.id, undefined);
      assert.equal(header.writer, false);
      assert.deepEqual(onlooker.apply({ ...header, arrays: delta }), []);
      assertSameSession(onlooker.content, replica.content);
    }
    assert.equal(second.events.filter(isChange).length, possible);
    assert.equal(first.events.filter(isChange).length, 0);
  });

  await t.test(
    'the one that came first of those that are there is promoted',
    async () => {
      const third = await program.connect();
      await third.ask('state');
      first.break();
      const { header } = await second.event(isPromotion, 'a promotion');
      assert.equal(header.writer, true);
      assert.equal((await second.ask('state')).writer, true);
      assert.equal((await third.ask('state')).writer, false);
      await assertRefused(third.do('undo'), /page/);
      onlooker.apply(await second.do('click', { place: 5, class: 'chair' }));
      assertSameSession((await stateOf(third)).content, onlooker.content);
      await second.close();
      await third.event(isPromotion, 'a promotion');
      await third.do('undo');
      await third.close();
    },
  );

  await t.test('who comes when nobody is there writes', async () => {
    const fourth = await program.connect();
    assert.equal((await fourth.ask('state')).writer, true);
    await fourth.do('redo');
  });
});

test(
  'who is promoted amid a change knows that it writes',
  async (t) => {
    const program = await start(t, [sampleScan(t), '--seeds', '4']);
    const first = await program.connect();
    const second = await program.connect();
    const state = await second.ask('state');
    assert.equal(state.writer, false);
    // Long work: its progress is told, so the writer can go in the middle of it.
    const seeds = 250;
    first.do('propose', { seeds }).catch(() => {});
    await first.event(
      ({ header }) => header.event === 'progress' && header.id !== null,
      'progress',
    );
    first.break();
    await second.event(isPromotion, 'a promotion');
    await second.event(isChange, 'the change');
    const said = second.events
      .map(({ header }) => header.writer)
      .filter((word) => word !== undefined);
    assert.equal(said.at(-1), true, 'what was said last of who writes');
  },
);

test(
  'progress of what one page asks does not look like that of another',
  async (t) => {
    const program = await start(t, [sampleScan(t), '--seeds', '4']);
    const first = await program.connect();
    const second = await program.connect();
    await second.ask('state');
    second.events.length = 0;
    await first.do('propose', { seeds: 150 });
    await second.event(isChange, 'the change');
    const ids = second.events
      .map(({ header }) => header.id)
      .filter((id) => typeof id === 'number');
    assert.deepEqual(ids, []);
  },
);

test('a second program on the session is refused, and the first goes on', async (t) => {
  const scan = smallScan(t);
  const program = await start(t, [scan, '--seeds', '8']);
  const page = await program.connect();
  const replica = await stateOf(page);
  const { code, stdout, stderr } = await runToEnd(t, [scan, '--seeds', '8']);
  assert.equal(code, 1);
  assert.doesNotMatch(stdout, /http/);
  const sentence = stderr.trim().split('\n').at(-1);
  assertSentence(sentence);
  assert.match(sentence, /small\.session: another program works on this session/);
  replica.apply(await page.do('click', { place: 1, class: 'chair' }));
  assertSameSession((await stateOf(page)).content, replica.content);
  assert.equal((await program.interrupt()).code, 0);
  const again = await start(t, [scan]);
  const reopened = await stateOf(await again.connect());
  assertSameSession(reopened.content, replica.content);
});
