/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The program opens a scan and asks its first questions; actions change what they say.
 */

import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';
import {
  Page,
  Replica,
  encode,
  sampleScan,
  start,
  temporaryFolder,
  truthOfSample,
  within,
} from './client.mjs';
import {
  randomNumbers,
  readPcd,
  smallRoom,
  writePcd,
  writePositions,
} from './clouds.mjs';
import {
  RandomActions,
  assertConsistent,
  assertRefused,
  assertSameSession,
  assertSentence,
  stateOf,
} from './session_checks.mjs';

test('the sample scan is served and asked about', async (t) => {
  const scan = sampleScan(t);
  const { fields } = readPcd(scan);
  const program = await start(t, [scan, '--classes', 's3dis', '--seeds', '20']);

  await t.test('HTTP: scan, positions, no colors', async () => {
    const facts = await program.scan();
    assert.equal(facts.name, 'room');
    assert.equal(facts.session, 'room.session');
    assert.equal(facts.points, 140000);
    assert.equal(facts.places, 140000);
    assert.equal(facts.has_color, false);
    assert.deepEqual(facts.up, [0, 0, 1]);
    assert.deepEqual(
      facts.classes.map(({ name }) => name).slice(0, 13),
      Object.values(truthOfSample().class_names).slice(-13),
    );
    assert.match(facts.version, /^\d+\.\d+\.\d+$/);
    const positions = await program.positions();
    assert.equal(positions.length, 3 * facts.places);
    for (const [axis, name] of ['x', 'y', 'z'].entries()) {
      let [low, high] = [Infinity, -Infinity];
      for (let place = 0; place < facts.places; ++place) {
        low = Math.min(low, positions[3 * place + axis]);
        high = Math.max(high, positions[3 * place + axis]);
      }
      assert.equal(Math.fround(facts.low[axis]), low);
      assert.equal(Math.fround(facts.high[axis]), high);
      const lowest = fields[name][1].reduce((a, b) => Math.min(a, b));
      assert.ok(Math.abs(low + facts.origin[axis] - lowest) < 1e-5);
    }
    assert.equal((await program.get('/api/colors')).status, 404);
    assert.equal((await program.get('/api/scan', { cookie: '' })).status, 401);
  });

  await t.test('the first places are a thinned scan', async () => {
    const positions = await program.positions();
    // Each eighth of the room has its share of the first places.
    const corner = (place) =>
      [0, 1, 2].reduce(
        (sum, axis) => sum + (positions[3 * place + axis] > 0 ? 1 << axis : 0),
        0,
      );
    const share = (count) => {
      const shares = new Array(8).fill(0);
      for (let place = 0; place < count; ++place) shares[corner(place)] += 1 / count;
      return shares;
    };
    const all = share(positions.length / 3);
    share(5000).forEach((each, k) => assert.ok(Math.abs(each - all[k]) < 0.03));
  });

  const page = await program.connect();

  await t.test('the state has all places, and the proposals as questions', async () => {
    const state = await page.ask('state');
    assert.equal(state.writer, true);
    assert.equal(state.revision, 1);
    assert.equal(state.undo, 1);
    assert.equal(state.redo, 0);
    assert.deepEqual(Object.keys(state.arrays).sort(), ['groups', 'labels']);
    assert.equal(state.arrays.labels.length, 140000);
    assert.equal(state.arrays.groups.length, 140000);
    assert.equal(state.seeds.length, 20);
    assert.ok(state.seeds.every((seed) => seed.label === null));
    assert.deepEqual(state.instances, []);
    assert.equal(state.unlabeled, 140000);
    assertConsistent(new Replica(state).content);
  });

  await t.test('questions come by the size of their groups, each once', async () => {
    const { content } = await stateOf(page);
    const expected = content.seeds
      .map((seed, number) => ({ ...seed, number }))
      .sort((a, b) => b.size - a.size || a.number - b.number);
    let after = null;
    for (const seed of expected) {
      const { question, left, arrays } = await page.ask('question', { after });
      assert.deepEqual(question, {
        seed: seed.key,
        place: seed.place,
        size: seed.size,
      });
      assert.equal(left, 20);
      assert.equal(arrays.places.length, seed.size);
      assert.ok(arrays.places.every((place) => content.groups[place] === seed.key));
      after = question.seed;
    }
    assert.equal((await page.ask('question', { after })).question, null);
  });

  await t.test('an answer labels the group of the question', async () => {
    const replica = await stateOf(page);
    const { question, arrays } = await page.ask('question', { after: null });
    const answer = await page.do('answer', {
      seed: question.seed,
      class: 'wall',
      name: 'north',
    });
    assert.deepEqual(replica.apply(answer), []);
    assert.deepEqual([...answer.arrays.places].sort(), [...arrays.places].sort());
    assert.deepEqual(answer.instances, [
      { label: 1, class: 'wall', name: 'north', size: question.size },
    ]);
    assert.equal(answer.unlabeled, 140000 - question.size);
    assert.equal(answer.writer, true);
    assertConsistent(replica.content);
    assertSameSession((await stateOf(page)).content, replica.content);
    const next = await page.ask('question', { after: null });
    assert.equal(next.left, 19);
    assert.notEqual(next.question.seed, question.seed);
  });

  await t.test(
    'when no question is left after one, `left` still tells how many there are',
    async () => {
      const { content } = await stateOf(page);
      const questions = content.seeds.filter((seed) => seed.label === null);
      const last = questions.sort((a, b) => a.size - b.size).at(0);
      const { question, left } = await page.ask('question', { after: last.key });
      assert.equal(question, null);
      assert.equal(left, questions.length);
    },
  );

  await t.test('random actions on the sample scan', async () => {
    await actRandomly(page, 60, 11);
  });

  await t.test('what is no frame, or has no word in it, gets a sentence', async () => {
    page.sendRaw(Buffer.from([1, 2, 3]));
    const isAnswer = ({ header }) => header.event === undefined;
    const { header } = await page.event(isAnswer, 'a refusal');
    assert.equal(header.ok, false);
    assert.equal(header.id, null);
    assertSentence(header.error);
    await assertRefused(page.say({}));
    await assertRefused(page.say({ ask: 'the way' }));
    await assertRefused(page.say({ ask: 7 }));
    await assertRefused(page.say({ do: ['undo'] }));
    await assertRefused(page.say({ do: null }));
    await assertRefused(page.say({ ask: null }));
    page.sendRaw(encode({ ask: 'state', id: 'a text' }));
    const other = await program.connect();
    await within(other.ask('state'), 'an answer after all of this');
    assert.equal(page.answers.get('a text'), 1);
    await other.close();
  });
});

test('random actions on a small scan', async (t) => {
  const scan = join(temporaryFolder(t), 'small.pcd');
  writePositions(scan, smallRoom(3000));
  const program = await start(t, [scan, '--seeds', '8']);
  const page = await program.connect();
  await actRandomly(page, Number(process.env.STUDIO_TEST_ACTIONS ?? 400), 5);
});

/** After each: the replica equals a fresh state, and undo leads back to what it was. */
async function actRandomly(page, count, seed) {
  const actions = new RandomActions(randomNumbers(seed));
  const replica = await stateOf(page);
  const copy = () => ({
    ...replica.content,
    labels: replica.labels.slice(),
    groups: replica.groups.slice(),
  });
  const done = [copy()]; // the states that undo leads back to; the last one is this
  const undone = [];
  const before = replica.summary.undo;
  const painted = new Set();
  for (let k = 0; k < count; ++k) {
    const [word, fields, arrays, isPossible] = actions.next(replica);
    const what = `action ${k}: ${word} ${JSON.stringify(fields)}`;
    try {
      if (!isPossible) await assertRefused(page.do(word, fields, arrays));
      else if (word === 'undo' && done.length === 1) continue;
      else {
        for (const place of arrays.places ?? []) painted.add(place);
        const { revision } = replica.summary;
        assert.deepEqual(replica.apply(await page.do(word, fields, arrays)), []);
        assert.equal(replica.summary.revision, revision + 1);
        if (word === 'undo') undone.push(done.pop());
        else if (word === 'redo') done.push(undone.pop());
        else {
          done.push(copy());
          undone.length = 0;
        }
        assertSameSession(copy(), { ...done.at(-1) }, { exact: false });
        assert.equal(replica.summary.undo, before + done.length - 1);
        assert.equal(replica.summary.redo, undone.length);
      }
      const fresh = await stateOf(page);
      assertSameSession(fresh.content, replica.content);
      assertConsistent(fresh.content, painted);
    } catch (error) {
      error.message = `${what}: ${error.message}`;
      throw error;
    }
  }
  for (const [id, answers] of page.answers)
    assert.equal(answers, 1, `answers to ${id}`);
}
