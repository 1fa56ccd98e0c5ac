/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What a page may ask: the answers agree with what actions then do.
 */

import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';
import { Refused, sampleScan, start, temporaryFolder } from './client.mjs';
import { randomNumbers, readPcd, smallRoom, writePositions } from './clouds.mjs';
import { assertRefused, assertSameSession, stateOf } from './session_checks.mjs';

test('the sample scan', async (t) => {
  const scan = sampleScan(t);
  const { fields } = readPcd(scan);
  const program = await start(t, [scan, '--seeds', '16']);
  const page = await program.connect();
  const random = randomNumbers(17);
  const places = fields.x[1].length;
  const somePlace = () => Math.floor(random() * places);
  const replica = await stateOf(page);

  await t.test('inspect: index and coordinates of the file', async () => {
    const positions = await program.positions();
    const { origin } = await program.scan();
    const seen = new Set();
    for (let k = 0; k < 60; ++k) {
      const place = somePlace();
      const answer = await page.ask('inspect', { place });
      const { index, position, label, seed, painted } = answer;
      seen.add(`${index} ${place}`);
      ['x', 'y', 'z'].forEach((axis, j) => {
        assert.ok(Math.abs(position[j] - fields[axis][1][index]) < 1e-5);
        assert.ok(
          Math.abs(positions[3 * place + j] + origin[j] - fields[axis][1][index]) <
            1e-5,
        );
      });
      assert.equal(label, replica.labels[place]);
      assert.equal(seed, replica.groups[place]);
      assert.equal(painted, false);
    }
    await assertRefused(page.ask('inspect', { place: places }));
    await assertRefused(page.ask('inspect'));
  });

  await t.test('preview is what a click takes', async (t) => {
    let others = 0;
    for (let k = 0; k < 12; ++k) {
      const place = k === 5 ? replica.summary.seeds[2].place : somePlace();
      const preview = new Set((await page.ask('preview', { place })).arrays.places);
      const delta = await page.do('click', { place, class: 'chair' });
      assert.deepEqual(replica.apply(delta), []);
      assert.ok(preview.has(place));
      replica.groups.forEach((group, i) => {
        if ((group === place) !== preview.has(i))
          assert.fail(`click on ${place}: place ${i}`);
      });
      others += delta.arrays.places.filter((i) => !preview.has(i)).length;
    }
    t.diagnostic(
      `${others} places went to other seeds, cut off from theirs by a click`,
    );
    await assertRefused(page.ask('preview', { place: places }));
    await assertRefused(page.ask('preview', {}));
  });

  await t.test('CID from a place: 0 at itself, finite and not below 0', async () => {
    for (const place of [0, somePlace(), places - 1]) {
      const { cid } = (await page.ask('cid', { place })).arrays;
      assert.equal(cid.length, places);
      assert.equal(cid[place], 0);
      for (const value of cid)
        if (!(value >= 0 && value < 100)) assert.fail(`CID ${value}`);
    }
    await assertRefused(page.ask('cid', { place: -1 }));
  });

  await t.test('doubt: a number where there is one, NaN elsewhere', async () => {
    const painted = Uint32Array.of(1, 2, 3, 20001);
    replica.apply(await page.do('paint', { label: 1 }, { places: painted }));
    const { doubt } = (await page.ask('doubt')).arrays;
    assert.equal(doubt.length, 20000);
    const bySeed = new Map(replica.summary.seeds.map((seed) => [seed.key, seed.label]));
    const isPainted = new Set(painted);
    let [known, below] = [0, 0];
    doubt.forEach((value, place) => {
      const label = bySeed.get(replica.groups[place]);
      const has = label !== null && label !== undefined && !isPainted.has(place);
      if (Number.isNaN(value) === has) assert.fail(`doubt of place ${place}: ${value}`);
      if (!has) return;
      ++known;
      if (value < 0) ++below;
    });
    assert.ok(known > 1000);
    t.diagnostic(
      `${below} of ${known} margins are below 0 (pieces that hang on no other)`,
    );
  });

  await t.test('doubtful: places whose doubt is below the limit', async () => {
    const { doubt } = (await page.ask('doubt')).arrays;
    for (const below of [0.001, 0.05, 1e30]) {
      const { place, size, arrays } = await page.ask('doubtful', { below });
      const any = doubt.some((value) => value < below);
      assert.equal(place !== null, any);
      assert.equal(arrays.places?.length ?? 0, size);
      if (!any) continue;
      assert.ok(arrays.places.includes(place));
      assert.ok([...arrays.places].every((each) => doubt[each] < below));
      assert.equal(new Set(arrays.places).size, size);
    }
    assert.equal((await page.ask('doubtful', { below: 1e-30 })).size >= 0, true);
    for (const below of [0, -1, 'x', null, undefined])
      await assertRefused(page.ask('doubtful', { below }));
  });

  await t.test('nothing of this has changed anything', async () => {
    assertSameSession((await stateOf(page)).content, replica.content);
  });

  await t.test(
    'the same again, or a change, cancels what waits; every id has one answer',
    async () => {
      const own = await program.connect(); // looks on; its ids are its own
      const outcomes = { answered: 0, cancelled: 0 };
      const asked = [];
      const say = (promise, mayCancel = true) =>
        asked.push(
          promise.then(
            (answer) => {
              ++outcomes.answered;
              return answer;
            },
            (error) => {
              if (
                !(error instanceof Refused) ||
                error.message !== 'cancelled' ||
                !mayCancel
              )
                throw error;
              ++outcomes.cancelled;
            },
          ),
        );
      for (let k = 0; k < 8; ++k) {
        say(page.ask('cid', { place: somePlace() }));
        say(page.ask('preview', { place: somePlace() }));
        say(page.ask('cid', { place: somePlace() }));
        say(own.ask('cid', { place: somePlace() }));
        if (k === 3)
          say(
            page
              .do('click', { place: somePlace(), label: 1 })
              .then((delta) => replica.apply(delta)),
            false,
          );
      }
      const last = page.ask('preview', { place: 5 }); // superseded by nothing
      say(last, false);
      await Promise.all(asked);
      assert.ok(outcomes.cancelled > 0, 'some are cancelled');
      for (const each of [page, own])
        for (const [id, answers] of each.answers)
          assert.equal(answers, 1, `answers to ${id}`);
      assert.equal(page.answers.size + own.answers.size > 26, true);
      assertSameSession((await stateOf(page)).content, replica.content);
      t.diagnostic(`${outcomes.answered} answered, ${outcomes.cancelled} cancelled`);
    },
  );

  await t.test(
    'what one page does not get done does not cancel what another asks',
    async () => {
      const onlooker = await program.connect();
      await onlooker.ask('state');
      const first = page.ask('cid', { place: 1 });
      const second = page.ask('preview', { place: 1 });
      await Promise.all([
        assertRefused(onlooker.do('undo'), /page/),
        assertRefused(onlooker.do('undo'), /page/),
        first,
        second,
      ]);
    },
  );
});

test('where groups need not hang together, a click changes what its preview has', async (t) => {
  const scan = join(temporaryFolder(t), 'small.pcd');
  writePositions(scan, smallRoom(2500));
  const program = await start(t, [scan, '--seeds', '10', '--connected', 'off']);
  const page = await program.connect();
  const random = randomNumbers(2);
  for (let k = 0; k < 40; ++k) {
    const place = Math.floor(random() * 2500);
    const { arrays } = await page.ask('preview', { place });
    const delta = await page.do('click', { place, class: 'chair' });
    assert.deepEqual([...delta.arrays.places].sort(), [...arrays.places].sort());
  }
  await page.do('settle');
  // Each point is with its nearest seed, so its own label is the nearest.
  const { doubt } = (await page.ask('doubt')).arrays;
  assert.ok(doubt.every((value) => value >= 0));
  const below = [...doubt].sort((a, b) => a - b)[500];
  const { arrays } = await page.ask('doubtful', { below });
  assert.ok(arrays.places.length > 0 && arrays.places.length <= 500);
});

test('doubt where there is one label, or none', async (t) => {
  const scan = join(temporaryFolder(t), 'small.pcd');
  writePositions(scan, smallRoom(800));
  const program = await start(t, [scan, '--seeds', '6']);
  const page = await program.connect();
  const allNaN = async () => (await page.ask('doubt')).arrays.doubt.every(Number.isNaN);
  assert.ok(await allNaN());
  await page.do('click', { place: 0, class: 'a' });
  assert.ok(await allNaN());
  assert.equal((await page.ask('doubtful', { below: 1 })).place, null);
  await page.do('click', { place: 1, label: 1 });
  assert.ok(await allNaN());
  await page.do('settle');
  assert.ok(await allNaN());
  await page.do('click', { place: 2, class: 'b' });
  const { doubt } = (await page.ask('doubt')).arrays;
  assert.equal(doubt.length, 800);
  assert.ok(doubt.every((value) => !Number.isNaN(value)));
  await page.do('remove', { seed: 0 });
  await page.do('remove', { seed: 1 });
  await page.do('remove', { seed: 2 });
  assert.ok(await allNaN());
  assert.equal((await page.ask('question', { after: null })).question, null);
  const state = await stateOf(page);
  assert.equal(state.summary.unlabeled, 800);
  assert.deepEqual(state.summary.seeds, []);
  assert.ok(state.groups.every((group) => group === 0xffffffff));
  assert.equal((await page.ask('inspect', { place: 4 })).seed, null);
  assert.equal((await page.ask('preview', { place: 4 })).arrays.places.length, 800);
});
