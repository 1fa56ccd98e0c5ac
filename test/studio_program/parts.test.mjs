/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Parts that a page chooses: their state, hulls and figures, and what is exported.
 */

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync, readdirSync, statSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { NO_GROUP, Refused, TOOLS, sampleScan, start, temporaryFolder } from './client.mjs';
import { randomNumbers, smallRoom, writePositions } from './clouds.mjs';
import { assertRefused, stateOf } from './session_checks.mjs';

function smallScan(t) {
  const scan = join(temporaryFolder(t), 'small.pcd');
  writePositions(scan, smallRoom(3000));
  return scan;
}

/** Parts as the protocol has them: the list, and the group of each place. */
async function partsOf(page) {
  const { parts, arrays } = await page.ask('parts');
  return { parts, groups: arrays.part_groups };
}

function assertConsistent({ parts, groups }) {
  const size = new Map();
  for (const group of groups) size.set(group, (size.get(group) ?? 0) + 1);
  assert.equal(size.get(NO_GROUP), undefined, 'each place is in a group');
  const inAPart = parts.list.flatMap((part) => part.groups).sort((a, b) => a - b);
  assert.deepEqual(inAPart, [...Array(parts.groups).keys()], 'a group is in one part');
  for (const part of parts.list) {
    assert.equal(part.part, Math.min(...part.groups));
    assert.equal(
      part.size,
      part.groups.reduce((sum, group) => sum + size.get(group), 0),
    );
    assert.equal(part.splits, part.groups.length > 1);
  }
  assert.equal(parts.heights.length, parts.groups - 1);
}

/** Each hull with its own vertices and triangles. */
async function hullsOf(page, parts) {
  const { hulls, arrays } = await page.ask('hulls', { parts });
  let vertex = 0;
  let triangle = 0;
  const found = hulls.map((hull) => {
    const vertices = arrays.vertices.subarray(vertex, (vertex += 3 * hull.vertices));
    const triangles = arrays.triangles.subarray(
      triangle,
      (triangle += 3 * hull.triangles),
    );
    return { ...hull, vertices, triangles };
  });
  assert.equal(vertex, arrays.vertices.length);
  assert.equal(triangle, arrays.triangles.length);
  return found;
}

const minus = (a, b) => a.map((x, i) => x - b[i]);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/** How far the farthest of some places is outside of a hull. */
function excessOf(hull, positions, places) {
  const corner = (k) => Array.from(hull.vertices.subarray(3 * k, 3 * k + 3));
  let most = -Infinity;
  for (let t = 0; t < hull.triangles.length; t += 3) {
    const [a, b, c] = Array.from(hull.triangles.subarray(t, t + 3), corner);
    const normal = cross(minus(b, a), minus(c, a));
    const length = Math.sqrt(dot(normal, normal));
    if (length < 1e-5) continue; // of rounded corners nothing is to be said
    for (const place of places) {
      const point = Array.from(positions.subarray(3 * place, 3 * place + 3));
      most = Math.max(most, dot(normal, minus(point, a)) / length);
    }
  }
  return most;
}

const placesOf = (part, groups) =>
  Array.from(groups.keys()).filter((place) => part.groups.includes(groups[place]));

test('parts of a small room', async (t) => {
  const scan = smallScan(t);
  const program = await start(t, [scan, '--seeds', '5', '--max-vertices', '12']);
  const page = await program.connect();
  const positions = await program.positions();
  const labels = await stateOf(page);

  await t.test('before there are any', async () => {
    const { parts, groups } = await partsOf(page);
    assert.deepEqual(
      [parts.groups, parts.list, parts.heights, parts.undo, parts.redo],
      [0, [], [], 0, 0],
    );
    assert.equal(groups.length, 0);
    for (const [word, fields] of [
      ['cut', { parts: 3 }],
      ['split', { part: 0 }],
      ['undo parts', {}],
    ])
      await assertRefused(page.do(word, fields));
    await assertRefused(
      page.ask('export parts', { mesh: 'obj', scenes: [], primitives: false, report: false }),
      /decompose/,
    );
    await assertRefused(page.do('decompose', { groups: 0 }), /at least 1/);
    await assertRefused(page.do('decompose'), /groups/);
  });

  await t.test('a decomposition, and what is done to it', async () => {
    const first = await page.do('decompose', { groups: 20 });
    assert.equal(first.parts.groups, 20);
    assert.equal(first.writer, true);
    const before = await partsOf(page);
    assertConsistent(before);
    assert.deepEqual(before.parts, first.parts);
    const random = randomNumbers(3);
    const some = (list) => list[Math.floor(random() * list.length)];
    let now = first;
    for (let k = 0; k < 60; ++k) {
      const part = some(now.parts.list).part;
      const [word, fields] = some([
        ['cut', { parts: 1 + Math.floor(random() * 20) }],
        ['split', { part }],
        ['split', { part }],
        ['join', { part, with: some(now.parts.list).part }],
        ['drop', { part }],
        ['keep', { part }],
        ['exact', { part, exact: random() < 0.5 }],
        ['undo parts', {}],
        ['redo parts', {}],
      ]);
      try {
        const next = await page.do(word, fields);
        assert.equal(next.revision, now.revision + 1);
        assert.equal(next.parts.decomposition, first.parts.decomposition);
        now = next;
      } catch (error) {
        if (!(error instanceof Refused)) throw error;
      }
      assertConsistent({ parts: now.parts, groups: before.groups });
    }
    assert.deepEqual((await partsOf(page)).parts, now.parts);
    const again = await page.do('decompose', { groups: 8 });
    assert.notEqual(again.parts.decomposition, first.parts.decomposition);
    assertConsistent(await partsOf(page));
    const undone = await page.do('undo parts');
    assert.notEqual(undone.parts.decomposition, again.parts.decomposition);
    assert.deepEqual(undone.parts.list, now.parts.list);
  });

  await t.test('labels know nothing of it', async () => {
    const { seeds, instances, undo, redo } = (await stateOf(page)).content;
    const then = labels.content;
    assert.deepEqual({ seeds, instances, undo, redo }, {
      seeds: then.seeds,
      instances: then.instances,
      undo: then.undo,
      redo: then.redo,
    });
  });

  await t.test('a hull holds all points of its part', async () => {
    await page.do('cut', { parts: 6 });
    const { groups } = await partsOf(page);
    const some = (await partsOf(page)).parts.list[2];
    await page.do('exact', { part: some.part, exact: true });
    const { parts } = await partsOf(page);
    const numbers = parts.list.map(({ part }) => part).reverse();
    const hulls = await hullsOf(page, numbers);
    assert.deepEqual(
      hulls.map(({ part }) => part),
      numbers,
    );
    for (const hull of hulls) {
      const part = parts.list.find((each) => each.part === hull.part);
      assert.ok(excessOf(hull, positions, placesOf(part, groups)) < 1e-3);
      assert.equal(hull.vertices.length / 3 > 12, part.exact, 'exact: more vertices');
      assert.equal(hull.vertices.length / 3 - 2, hull.triangles.length / 6);
      assert.ok(hull.volume > 0 && hull.thickness > 0.0049);
    }
    const { tightness } = await page.ask('tightness', { parts: numbers });
    assert.equal(tightness.length, hulls.length);
    for (const { max_concavity, mean_concavity, free_share } of tightness) {
      assert.ok(mean_concavity >= 0 && mean_concavity <= max_concavity);
      assert.ok(free_share >= 0 && free_share <= 1);
    }
    await assertRefused(page.ask('hulls', { parts: [999] }), /999/);
    await assertRefused(page.ask('hulls', { parts: ['0'] }));
    await assertRefused(page.ask('tightness', { parts: 3 }), /list/);
  });

  await t.test('a second page looks on', async () => {
    const second = await program.connect();
    await assertRefused(second.do('cut', { parts: 2 }), /page/);
    const told = second.event(({ header }) => header.event === 'parts');
    const done = await page.do('cut', { parts: 4 });
    const { header } = await told;
    assert.deepEqual(header.parts, done.parts);
    assert.equal(header.writer, false);
    assert.deepEqual((await partsOf(second)).parts, done.parts);
    second.close();
  });

  await t.test('nothing that was answered is lost by a kill', async () => {
    await page.do('drop', { part: (await partsOf(page)).parts.list[1].part });
    const before = await partsOf(page);
    const hulls = await hullsOf(page, [before.parts.list[0].part]);
    await program.kill();
    const next = await start(t, [scan, '--max-vertices', '12']);
    const other = await next.connect();
    const after = await partsOf(other);
    assert.deepEqual(after.groups, before.groups);
    const withoutNumber = ({ decomposition, ...rest }) => rest;
    assert.deepEqual(withoutNumber(after.parts), withoutNumber(before.parts));
    assert.deepEqual(await hullsOf(other, [before.parts.list[0].part]), hulls);
    await next.interrupt();
  });
});

test('exported parts are those of pcl_cid_abstract', async (t) => {
  const scan = sampleScan(t);
  const folder = dirname(scan);
  const program = await start(t, [scan, '--seeds', '5', '--padding', '0.01']);
  const page = await program.connect();
  await page.do('decompose', { groups: 40 });
  const { parts } = await page.do('cut', { parts: 15 });
  const [a, b, c, d] = [...parts.list].sort((x, y) => y.size - x.size);
  const wanted = {
    mesh: 'ply',
    scenes: ['urdf', 'moveit', 'gltf', 'usd'],
    labels: 'pcd',
    primitives: false,
    report: true,
  };
  const session = join(folder, 'room.session');
  const tool = (options) =>
    execFileSync(join(TOOLS, 'pcl_cid_abstract'), [
      scan,
      join(folder, 'other.ply'),
      ...['--verify', '--padding', '0.01', '--report', join(folder, 'other.json')],
      ...['--labels', join(folder, 'other.pcd')],
      ...['--urdf', join(folder, 'other.urdf')],
      ...['--gltf', join(folder, 'other.glb'), '--usd', join(folder, 'other.usda')],
      ...options,
    ]);
  const assertSame = (name, other) =>
    assert.ok(
      readFileSync(join(folder, name)).equals(readFileSync(join(folder, other))),
      `${name} and ${other} differ`,
    );

  await t.test('of a cut', async () => {
    const { files } = await page.ask('export parts', { ...wanted, file: 'cut' });
    for (const file of files) assert.ok(existsSync(file), `${file} is not there`);
    tool(['--seeds', '40', '--parts', '15', '--merging', 'cid']);
    assertSame('cut.ply', 'other.ply');
    assertSame('cut_labels.pcd', 'other.pcd');
    assertSame('cut_gltf.glb', 'other.glb');
    assertSame('cut_usd.usda', 'other.usda');
    assert.match(readFileSync(join(folder, 'cut.urdf'), 'utf8'), /<link name="room">/);
  });

  await t.test('of what was chosen', async () => {
    await page.do('drop', { part: a.part });
    await page.do('exact', { part: b.part, exact: true });
    await page.do('join', { part: c.part, with: d.part });
    const { files } = await page.ask('export parts', { ...wanted, file: '' });
    assert.ok(files.includes(join(folder, 'room_parts.ply')), files.join());
    tool(['--session', session]);
    assertSame('room_parts.ply', 'other.ply');
    assertSame('room_parts_labels.pcd', 'other.pcd');
    const report = JSON.parse(readFileSync(join(folder, 'room_parts_report.json')));
    assert.equal(report.parts.length, 13);
    assert.equal(report.points.dropped, a.size);
    assert.equal(report.parameters.padding, 0.01);
    const other = JSON.parse(readFileSync(join(folder, 'other.json')));
    assert.deepEqual(report.parts, other.parts);
    assert.deepEqual(report.tightness, other.tightness);
    const meshes = files.find((file) => statSync(file).isDirectory());
    assert.equal(readdirSync(meshes).length, 13);
    // The figures that the page showed before.
    const { parts: now } = await partsOf(page);
    const kept = now.list.filter(({ dropped }) => !dropped).map(({ part }) => part);
    const { tightness } = await page.ask('tightness', { parts: kept });
    tightness.forEach(({ max_concavity, free_share }, k) => {
      assert.equal(max_concavity, report.parts[k].max_concavity);
      assert.equal(free_share, report.parts[k].free_share);
    });
  });

  await t.test('what is not possible leaves nothing behind', async () => {
    const before = readdirSync(folder);
    const cases = [
      [{ mesh: 'blend' }, /obj/],
      [{ scenes: ['blend'] }, /urdf/],
      [{ labels: 'txt' }, /pcd/],
      [{ file: 'a/b' }, /folders/],
      [{ scenes: 'urdf' }, /list/],
      [{ primitives: 1 }, /true or false/],
    ];
    for (const [wrong, said] of cases)
      await assertRefused(
        page.ask('export parts', { ...wanted, file: 'new', ...wrong }),
        said,
      );
    const { parts: now } = await partsOf(page);
    for (const { part } of now.list) await page.do('drop', { part });
    await assertRefused(page.ask('export parts', { ...wanted, file: 'new' }), /dropped/);
    assert.deepEqual(readdirSync(folder), before);
    // It goes on.
    await page.do('keep', { part: a.part });
    await page.ask('export parts', { ...wanted, file: 'new' });
  });

  await t.test('the session itself is never written over', async () => {
    assert.match(readFileSync(session, 'utf8'), /^{"format":"pcl_cid session"/);
  });
});
