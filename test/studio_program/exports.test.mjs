/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What is saved for other programs, read back by a reader of our own.
 */

import assert from 'node:assert/strict';
import {
  chmodSync,
  existsSync,
  mkdirSync,
  readFileSync,
  readdirSync,
  statSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { test } from 'node:test';
import { sampleScan, start, temporaryFolder } from './client.mjs';
import {
  randomNumbers,
  readPcd,
  readPly,
  smallRoom,
  writePcd,
  writePly,
} from './clouds.mjs';
import { assertRefused, assertSameSession, stateOf } from './session_checks.mjs';

const COUNT = 900;
const isHole = (i) => i % 11 === 5;

/** A scan with many fields, of which some numbers are hard to keep. */
function fieldsOfTest({ holes = true } = {}) {
  const random = randomNumbers(4);
  const cloud = smallRoom(COUNT);
  for (const axis of ['x', 'y', 'z'])
    cloud[axis] = cloud[axis].map((v, i) => (holes && isHole(i) ? NaN : v));
  const some = (make) => Array.from({ length: COUNT }, (_, i) => make(i));
  return {
    x: ['F4', cloud.x],
    y: ['F4', cloud.y],
    z: ['F4', cloud.z],
    intensity: ['F4', some(() => Math.fround(random() * 1e-3))],
    time: ['F8', some((i) => 1.7e9 + i / 1024)],
    ring: ['U2', some((i) => i % 64)],
    label: ['U2', some((i) => i % 5)],
    flags: ['U1', some((i) => i % 256)],
    echo: ['I4', some((i) => 7 - i)],
  };
}

/** A program with some instances, seeds and painted points. */
async function labelled(t, scan, args = ['--seeds', '6']) {
  const program = await start(t, [scan, ...args]);
  const page = await program.connect();
  await page.do('click', { place: 10, class: 'chair', name: 'left' });
  await page.do('click', { place: 200, class: 'Tür "ä"', name: '' });
  await page.do('click', { place: 300, label: 1 });
  await page.do('paint', { class: 'wall' }, { places: Uint32Array.of(3, 4, 5, 6) });
  return { program, page, folder: dirname(scan), replica: await stateOf(page) };
}

/** The labels of the state, by the points of the input; 0 for those without a place. */
async function expectedLabels(page, replica, count) {
  const labels = new Array(count).fill(0);
  for (let place = 0; place < replica.labels.length; ++place) {
    const { index, label } = await page.ask('inspect', { place });
    assert.equal(label, replica.labels[place]);
    labels[index] = label;
  }
  return labels;
}

function assertSameFields(actual, expected, labels) {
  const names = Object.keys(expected).filter((name) => name !== 'label');
  assert.deepEqual(
    Object.keys(actual).filter((name) => name !== 'label'),
    names,
  );
  for (const name of names) assert.deepEqual(actual[name], expected[name], name);
  assert.equal(actual.label[0], 'U4');
  assert.deepEqual(actual.label[1], labels);
}

for (const [data, width, height] of [
  ['ascii', COUNT, 1],
  ['binary', 30, 30],
])
  test(`PCD (${data}, ${width} x ${height}) and PLY have every field and point`, async (t) => {
    const scan = join(temporaryFolder(t), 'many.pcd');
    const fields = fieldsOfTest();
    writePcd(scan, fields, { data, width, height });
    const { page, folder, replica } = await labelled(t, scan);
    const labels = await expectedLabels(page, replica, COUNT);
    assert.ok(new Set(labels).size === 4);

    const pcd = await page.ask('export', { format: 'pcd', file: 'out' });
    assert.deepEqual(
      pcd.files.map((file) => basename(file)),
      ['out.pcd', 'out.instances.json'],
    );
    const read = readPcd(join(folder, 'out.pcd'));
    assert.deepEqual([read.data, read.width, read.height], [data, width, height]);
    assertSameFields(read.fields, fields, labels);

    const list = JSON.parse(readFileSync(join(folder, 'out.instances.json'), 'utf8'));
    assert.deepEqual(
      list.map(({ label, class: name, name: text, points }) => [
        label,
        name,
        text,
        points,
      ]),
      replica.summary.instances.map((each) => [
        each.label,
        each.class,
        each.name,
        each.size,
      ]),
    );

    await page.ask('export', { format: 'ply', file: 'out' });
    assertSameFields(readPly(join(folder, 'out.ply')).fields, fields, labels);
    assertSameSession((await stateOf(page)).content, replica.content);
  });

test('the sample scan, and its cleaned labels', async (t) => {
  const scan = sampleScan(t);
  const { page, folder, replica } = await labelled(t, scan);
  await page.ask('export', { format: 'pcd', file: 'out' });
  const [given, out] = [readPcd(scan), readPcd(join(folder, 'out.pcd'))];
  assert.equal(out.data, given.data);
  for (const name of ['x', 'y', 'z', 'semantic'])
    assert.deepEqual(out.fields[name], given.fields[name]);
  const count = (labels) =>
    labels.reduce((sum, label) => sum.set(label, (sum.get(label) ?? 0) + 1), new Map());
  const sizes = count(out.fields.label[1]);
  assert.equal(sizes.get(0), replica.summary.unlabeled);
  for (const { label, size } of replica.summary.instances)
    assert.equal(sizes.get(label), size);
  await page.ask('export', { format: 'pcd', file: 'clean', clean_up: true });
  const clean = readPcd(join(folder, 'clean.pcd')).fields.label[1];
  const changed = clean.filter((label, i) => label !== out.fields.label[1][i]).length;
  assert.ok(changed < 7000, `${changed} points were cleaned`);
  assertSameSession((await stateOf(page)).content, replica.content);
});

test('a PLY stays one, with its fields', async (t) => {
  const scan = join(temporaryFolder(t), 'many.ply');
  const { flags, echo, ring, intensity, x, y, z } = fieldsOfTest({ holes: false });
  const fields = { x, y, z, intensity, ring, flags, echo };
  writePly(scan, fields);
  const { page, folder, replica } = await labelled(t, scan);
  const labels = await expectedLabels(page, replica, COUNT);
  await page.ask('export', { format: 'ply' });
  const read = readPly(join(folder, 'many_labelled.ply'));
  assert.equal(read.format, 'ascii');
  assertSameFields(read.fields, fields, labels);
});

test('seeds, and the formats of data sets', async (t) => {
  const scan = join(temporaryFolder(t), 'many.pcd');
  const fields = fieldsOfTest();
  writePcd(scan, fields);
  const { page, folder, replica } = await labelled(t, scan);
  const labels = await expectedLabels(page, replica, COUNT);
  const rename = (name) => page.do('edit', { label: 2, class: name, name: '' });

  await t.test('seeds.csv', async () => {
    await page.ask('export', { format: 'seeds', file: 'out' });
    const [head, ...rows] = readFileSync(join(folder, 'out.seeds.csv'), 'utf8')
      .trim()
      .split('\n');
    assert.equal(head, 'index,x,y,z,label');
    const seeds = replica.summary.seeds;
    assert.equal(rows.length, seeds.length);
    for (const [k, row] of rows.entries()) {
      const [index, x, y, z, label] = row.split(',');
      const inspected = await page.ask('inspect', { place: seeds[k].place });
      assert.equal(Number(index), inspected.index);
      assert.equal(label, seeds[k].label === null ? '' : String(seeds[k].label));
      [x, y, z].forEach((v, j) =>
        assert.ok(Math.abs(Number(v) - inspected.position[j]) < 1e-5),
      );
    }
  });

  await t.test('s3dis', async () => {
    const { files, remarks } = await page.ask('export', { format: 's3dis', file: 'room_1' });
    assert.ok(remarks.some((sentence) => /no colors/.test(sentence)), remarks.join());
    assert.deepEqual(
      files.map((file) => basename(file)),
      ['room_1'],
    );
    const lines = (path) => readFileSync(join(folder, path), 'utf8').trim().split('\n');
    const finite = fields.x[1].filter((v) => !Number.isNaN(v)).length;
    assert.equal(lines('room_1/room_1.txt').length, finite);
    const annotations = readdirSync(join(folder, 'room_1/Annotations'));
    assert.deepEqual(
      annotations.filter((name) => name.startsWith('chair')),
      ['chair_1.txt'],
    );
    for (const [name, label] of [
      ['chair_1.txt', 1],
      ['wall_1.txt', 3],
    ])
      assert.equal(
        lines(`room_1/Annotations/${name}`).length,
        labels.filter((each) => each === label).length,
      );
  });

  await t.test(
    'scannet makes its folder',
    async () => {
      await rename('table');
      await page.ask('export', { format: 'scannet', file: 'new_scene' });
      assert.ok(existsSync(join(folder, 'new_scene')));
    },
  );

  await t.test('scannet', async () => {
    await rename('Tür "ä"');
    await assertRefused(
      page.ask('export', { format: 'scannet', file: 'scene' }),
      /Tür/,
    );
    assert.equal(existsSync(join(folder, 'scene')), false);
    await rename('');
    await assertRefused(
      page.ask('export', { format: 'scannet', file: 'scene' }),
      /class/,
    );
    await rename('table');
    mkdirSync(join(folder, 'scene'));
    const { files } = await page.ask('export', { format: 'scannet', file: 'scene' });
    assert.deepEqual(
      files.map((file) => basename(file)),
      ['scene'],
    );
    const all = readdirSync(join(folder, 'scene'), { recursive: true });
    assert.ok(
      all.some((name) => /aggregation\.json$/.test(name)),
      `${all}`,
    );
    const segments = all.find((name) => /segs\.json$/.test(name));
    const { segIndices } = JSON.parse(
      readFileSync(join(folder, 'scene', segments), 'utf8'),
    );
    assert.equal(segIndices.length, COUNT);
    const aggregation = JSON.parse(
      readFileSync(
        join(
          folder,
          'scene',
          all.find((name) => /aggregation\.json$/.test(name)),
        ),
        'utf8',
      ),
    );
    assert.deepEqual(
      aggregation.segGroups.map(({ label }) => label),
      ['chair', 'table', 'wall'],
    );
    // The points of the segments of an instance are those of the instance.
    for (const [k, group] of aggregation.segGroups.entries()) {
      const own = new Set(group.segments);
      segIndices.forEach((segment, i) =>
        assert.equal(own.has(segment), labels[i] === k + 1, `point ${i}`),
      );
    }
  });

  await t.test('kitti', async () => {
    await page.ask('export', { format: 'kitti', file: 'out' });
    const bytes = readFileSync(join(folder, 'out.label'));
    assert.equal(bytes.length, 4 * COUNT);
    labels.forEach((label, i) => assert.equal(bytes.readUInt32LE(4 * i) >>> 16, label));
  });

  await t.test('again, over what was exported before', async () => {
    mkdirSync(join(folder, 'again_scannet'));
    for (const format of ['pcd', 'ply', 'seeds', 's3dis', 'scannet', 'kitti'])
      for (let k = 0; k < 2; ++k)
        await page.ask('export', { format, file: `again_${format}` });
    const hidden = readdirSync(folder, { recursive: true }).filter((name) =>
      basename(name).startsWith('.'),
    );
    assert.deepEqual(hidden, []);
  });
});

/** Names and contents of all that is in a folder. */
function contentsOf(folder) {
  return readdirSync(folder, { recursive: true })
    .sort()
    .map((name) => {
      const path = join(folder, name);
      return [name, statSync(path).isFile() ? readFileSync(path, 'latin1') : null];
    });
}

test('what may not be written is refused, and nothing is changed', async (t) => {
  const parent = temporaryFolder(t);
  const folder = join(parent, 'inner');
  mkdirSync(folder);
  const scan = join(folder, 'many.pcd');
  writePcd(scan, fieldsOfTest());
  symlinkSync(scan, join(folder, 'link.pcd'));
  writeFileSync(join(folder, 'file'), 'a file');
  mkdirSync(join(folder, 'dir.pcd'));
  // A session whose name an export could have.
  const session = join(folder, 'work.label');
  const { program, page, replica } = await labelled(t, scan, [
    '--seeds',
    '6',
    '--session',
    session,
  ]);
  const before = contentsOf(parent);

  const refused = {
    'a format that is not there': { format: 'docx', file: 'out' },
    'no format': { file: 'out' },
    'a format that is no text': { format: 3 },
    'a name that is no text': { format: 'pcd', file: 5 },
    'a folder': { format: 'pcd', file: 'a/b' },
    'a path': { format: 'pcd', file: '/elsewhere/out' },
    '..': { format: 's3dis', file: '..' },
    '.': { format: 's3dis', file: '.' },
    'up and away': { format: 'pcd', file: '../out' },
    'a hidden name': { format: 'pcd', file: '.out' },
    'a folder at its end': { format: 'scannet', file: 'out/' },
    'the scan': { format: 'pcd', file: 'many' },
    'the scan by a link': { format: 'pcd', file: 'link' },
    'the session': { format: 'kitti', file: 'work' },
    'the session as a folder': { format: 's3dis', file: 'work.label' },
    'the scan as a folder': { format: 'scannet', file: 'many.pcd' },
    'a file as a folder': { format: 's3dis', file: 'file' },
    'a folder as a file': { format: 'pcd', file: 'dir' },
    'a name that is too long': { format: 'pcd', file: 'n'.repeat(300) },
    'a folder name that is too long': { format: 's3dis', file: 'n'.repeat(300) },
    'a name that is much too long': { format: 'scannet', file: 'n'.repeat(9000) },
  };
  for (const [what, fields] of Object.entries(refused))
    await t.test(what, async () => {
      await assertRefused(page.ask('export', fields));
      assert.deepEqual(contentsOf(parent), before);
    });

  await t.test(
    'a name with a zero in it',
    async (t) => {
      const names = ['file\0', 'new\0x'];
      for (const file of names)
        await assertRefused(page.ask('export', { format: 'pcd', file }));
      assert.deepEqual(contentsOf(parent), before);
      t.diagnostic('nothing was written');
    },
  );

  await t.test('the session goes on', async () => {
    assertSameSession((await stateOf(page)).content, replica.content);
    await page.do('undo');
    assert.equal((await program.interrupt()).code, 0);
  });
});

test('a class whose name no file can have is refused by data sets, and others write it', async (t) => {
  const scan = join(temporaryFolder(t), 'many.pcd');
  writePcd(scan, fieldsOfTest());
  const { page, folder } = await labelled(t, scan);
  await page.do('click', { place: 400, class: '../'.repeat(80) });
  const before = contentsOf(folder);
  for (const format of ['s3dis', 'scannet'])
    await assertRefused(page.ask('export', { format, file: 'room' }));
  assert.deepEqual(contentsOf(folder), before);
  for (const format of ['pcd', 'ply', 'seeds', 'kitti'])
    await page.ask('export', { format, file: 'out' });
});

test('a room of S3DIS is read, and never written over', async (t) => {
  const folder = temporaryFolder(t);
  const room = join(folder, 'office_1');
  mkdirSync(join(room, 'Annotations'), { recursive: true });
  const { x, y, z } = smallRoom(400);
  const lines = x.map((v, i) => `${v} ${y[i]} ${z[i]} 10 20 30\n`);
  writeFileSync(join(room, 'office_1.txt'), lines.join(''));
  writeFileSync(join(room, 'Annotations/chair_1.txt'), lines.slice(0, 200).join(''));
  writeFileSync(join(room, 'Annotations/table_1.txt'), lines.slice(200).join(''));
  const before = contentsOf(room);
  const { page } = await labelled(t, room, ['--seeds', '5']);
  for (const format of ['s3dis', 'scannet'])
    await page.ask('export', { format, file: 'office_1' }).catch(() => {});
  assert.deepEqual(contentsOf(room), before);
  await page.ask('export', { format: 's3dis', file: 'office_2' });
});

test('a folder in which nobody may write any more', async (t) => {
  const folder = temporaryFolder(t);
  chmodSync(folder, 0o777);
  const scan = join(folder, 'many.pcd');
  writePcd(scan, fieldsOfTest());
  const program = await start(t, [scan, '--seeds', '5'], { isUnprivileged: true });
  const page = await program.connect();
  await page.ask('state'); // its first questions are in its file
  chmodSync(folder, 0o555);
  const before = contentsOf(folder);
  for (const format of ['pcd', 's3dis', 'kitti', 'seeds'])
    await assertRefused(page.ask('export', { format, file: 'out' }), /ermission/);
  assert.deepEqual(contentsOf(folder), before);
  chmodSync(folder, 0o777);
  await page.ask('export', { format: 'pcd', file: 'out' });
});
