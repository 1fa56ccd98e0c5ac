/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Scans and sessions of all kinds: those that are opened, and those that are refused.
 */

import assert from 'node:assert/strict';
import {
  appendFileSync,
  chmodSync,
  existsSync,
  mkdirSync,
  readFileSync,
  writeFileSync,
} from 'node:fs';
import { createServer } from 'node:net';
import { join } from 'node:path';
import { test } from 'node:test';
import {
  Program,
  runToEnd,
  sampleScan,
  start,
  temporaryFolder,
  until,
} from './client.mjs';
import { readPcd, smallRoom, writePcd, writePositions } from './clouds.mjs';
import {
  assertConsistent,
  assertSameSession,
  assertSentence,
  stateOf,
} from './session_checks.mjs';

/** The program ends with 1 and one sentence that says what is wrong. */
async function assertEnds(t, args, pattern, options) {
  const { code, signal, stderr } = await runToEnd(t, args, options);
  assert.equal(signal, null, stderr);
  assert.equal(code, 1, stderr);
  const lines = stderr
    .trim()
    .split('\n')
    .filter((line) => line.startsWith('pcl_cid_studio: '));
  assert.equal(lines.length, 1, stderr);
  assertSentence(lines[0]);
  assert.match(lines[0], pattern);
  return lines[0];
}

/** A scan of so many points whose field `mark` is made of the x and the number of each. */
function markedRoom(t, points, markOf) {
  const folder = temporaryFolder(t);
  const scan = join(folder, 'a.pcd');
  const { x, y, z } = smallRoom(points);
  const mark = x.map(markOf);
  writePcd(scan, { x: ['F4', x], y: ['F4', y], z: ['F4', z], mark: ['U4', mark] });
  return { folder, scan, mark };
}

/** A scan of 1500 points with a session of two actions; which has ended. */
async function withSession(t) {
  const folder = temporaryFolder(t);
  const scan = join(folder, 'small.pcd');
  const cloud = smallRoom(1500);
  writePositions(scan, cloud);
  const program = await start(t, [scan, '--seeds', '6']);
  const page = await program.connect();
  const replica = await stateOf(page);
  replica.apply(await page.do('click', { place: 3, class: 'chair', name: 'a' }));
  replica.apply(await page.do('click', { place: 9, label: 1 }));
  await program.interrupt();
  return {
    folder,
    scan,
    cloud,
    session: join(folder, 'small.session'),
    content: replica.content,
  };
}

async function contentOf(t, args) {
  const program = await start(t, args);
  const { content } = await stateOf(await program.connect());
  await program.interrupt();
  return content;
}

test('sessions', async (t) => {
  const { folder, scan, cloud, session, content } = await withSession(t);
  const text = readFileSync(session, 'utf8');
  const lines = text.trimEnd().split('\n');
  const other = join(folder, 'other.pcd');
  const restored = () => writeFileSync(session, text);

  await t.test('of a scan with other points is refused', async () => {
    writePositions(other, smallRoom(1400));
    await assertEnds(t, [other, '--session', session], /1500 points.*1400/);
    assert.equal(readFileSync(session, 'utf8'), text);
  });

  await t.test('of a scan with one other coordinate is refused', async () => {
    const changed = { ...cloud, y: [...cloud.y] };
    changed.y[700] = Math.fround(changed.y[700] + 1e-6);
    writePositions(other, changed);
    await assertEnds(t, [other, '--session', session], /other coordinates/);
    assert.equal(readFileSync(session, 'utf8'), text);
  });

  await t.test(
    'of the same points in a file with another name and layout is opened',
    async () => {
      const fields = {
        intensity: ['F4', cloud.x],
        x: ['F4', cloud.x],
        y: ['F4', cloud.y],
        z: ['F4', cloud.z],
      };
      writePcd(other, fields, { data: 'ascii' });
      assertSameSession(await contentOf(t, [other, '--session', session]), content);
    },
  );

  await t.test('the settings of the session are those that count', async () => {
    assertSameSession(
      await contentOf(t, [scan, '--samples', '20', '--normals', '0']),
      content,
    );
  });

  await t.test('a torn last line loses itself alone', async () => {
    for (const torn of ['{"do":"cli', '{"do":"undo"}', '\0\0\0\0', '{']) {
      restored();
      appendFileSync(session, torn);
      assertSameSession(await contentOf(t, [scan]), content);
      assert.equal(readFileSync(session, 'utf8'), text);
    }
  });

  await t.test('a torn first line is a session that was not begun', async () => {
    writeFileSync(session, lines[0].slice(0, 40));
    const begun = await contentOf(t, [scan, '--seeds', '6']);
    assert.equal(begun.revision, 1);
    assert.equal(begun.seeds.length, 6);
    restored();
  });

  await t.test('a last line that is not possible is dropped', async () => {
    appendFileSync(session, '{"do":"redo"}\n');
    assertSameSession(await contentOf(t, [scan]), content);
    assert.equal(readFileSync(session, 'utf8'), text);
  });

  await t.test('damage in the middle is refused with its line, and kept', async () => {
    const damage = [
      ['{"do":"cli', /line 3/],
      ['{"do":"dance"}', /line 3.*dance/],
      ['{"do":"remove","seed":999999}', /line 3/],
      ['{"do":"click","points":[-5],"label":0}', /line 3/],
      ['{"do":"click","points":[1],"label":77}', /line 3/],
      ['[]', /line 3/],
      ['\0\0\0\0\0\0', /line 3/],
    ];
    for (const [line, pattern] of damage) {
      const damaged = [lines[0], lines[1], line, ...lines.slice(2)].join('\n') + '\n';
      writeFileSync(session, damaged);
      await assertEnds(t, [scan], pattern);
      assert.equal(readFileSync(session, 'utf8'), damaged);
    }
    restored();
  });

  await t.test('a session with line ends of Windows is opened', async () => {
    writeFileSync(session, text.replaceAll('\n', '\r\n'));
    assertSameSession(await contentOf(t, [scan]), content);
    restored();
  });

  await t.test('what is no session is refused and kept', async () => {
    for (const [bytes, pattern] of [
      ['hello\nworld\n', /./],
      ['{"a": 1}\n', /format/],
      ['no line', /not a session/],
      [lines[0].replace('"version":1', '"version":2') + '\n', /version 2/],
    ]) {
      writeFileSync(other, bytes);
      await assertEnds(t, [scan, '--session', other], pattern);
      assert.equal(readFileSync(other, 'utf8'), bytes);
    }
    restored();
  });

  await t.test('the scan itself as the session is refused and kept', async () => {
    const bytes = readFileSync(scan);
    await assertEnds(t, [scan, '--session', scan], /small\.pcd/);
    assert.ok(readFileSync(scan).equals(bytes));
  });

  await t.test('a folder that is not there, or is a file, is refused', async () => {
    await assertEnds(t, [scan, '--session', join(folder, 'none/a.session')], /none/);
    await assertEnds(t, [scan, '--session', join(scan, 'a.session')], /a\.session/);
    await assertEnds(t, [scan, '--session', folder], /./);
  });

  await t.test('a folder in which nobody may write is refused', async () => {
    const locked = join(folder, 'locked');
    mkdirSync(locked);
    writePositions(join(locked, 'a.pcd'), cloud);
    chmodSync(folder, 0o755);
    chmodSync(locked, 0o555);
    await assertEnds(t, [join(locked, 'a.pcd')], /a\.session.*[Pp]ermission/, {
      isUnprivileged: true,
    });
    chmodSync(locked, 0o755);
  });

  await t.test('a session that may only be read is refused', async () => {
    chmodSync(session, 0o444);
    await assertEnds(t, [scan], /small\.session.*[Pp]ermission/, {
      isUnprivileged: true,
    });
    chmodSync(session, 0o644);
  });

  await t.test('--import into a session that has begun is refused', async () => {
    await assertEnds(t, [scan, '--import', 'x'], /begun/);
    assert.equal(readFileSync(session, 'utf8'), text);
  });
});

test('scans that cannot be labelled', async (t) => {
  const folder = temporaryFolder(t);
  const path = (name) => join(folder, name);

  await t.test('no file, a wrong extension, no cloud', async () => {
    await assertEnds(t, [path('none.pcd')], /none\.pcd/);
    writeFileSync(path('a.doc'), '1 2 3\n');
    await assertEnds(t, [path('a.doc')], /a\.doc/);
    writeFileSync(path('b.pcd'), 'hello');
    await assertEnds(t, [path('b.pcd')], /b\.pcd/);
    await assertEnds(t, [folder], /./);
    for (const name of ['none.session', 'a.session', 'b.session'])
      assert.equal(existsSync(path(name)), false, name);
  });

  await t.test('no usage', async () => {
    for (const args of [
      [],
      ['--dance', 'a.pcd'],
      ['a.pcd', 'b.pcd'],
      ['a.pcd', '--port', '70000'],
      ['a.pcd', '--up', 'w'],
      ['a.pcd', '--seeds', '0'],
    ]) {
      const { code, stderr } = await runToEnd(t, args);
      assert.ok(code === 1 || code === 2, `${args}: ${code}`);
      assert.match(stderr, /^pcl_cid_studio: .+\n$/);
    }
  });

  await t.test('no points, and none that is finite', async () => {
    writePositions(path('empty.pcd'), { x: [], y: [], z: [] });
    await assertEnds(t, [path('empty.pcd')], /point/);
    const nan = new Array(50).fill(NaN);
    writePositions(path('nan.pcd'), { x: nan, y: nan, z: nan });
    await assertEnds(t, [path('nan.pcd')], /finite/);
    for (const name of ['empty.session', 'nan.session'])
      assert.equal(existsSync(path(name)), false, name);
  });
});

test('small scans', async (t) => {
  const folder = temporaryFolder(t);
  const path = (name) => join(folder, name);

  await t.test('3 points', async () => {
    writePositions(path('three.pcd'), { x: [0, 1, 0], y: [0, 0, 1], z: [0, 0, 0] });
    const program = await start(t, [path('three.pcd')]);
    const page = await program.connect();
    const replica = await stateOf(page);
    assert.equal(replica.labels.length, 3);
    assertConsistent(replica.content);
    for (const place of [0, 1, 2])
      replica.apply(await page.do('click', { place, class: `${place}` }));
    assertConsistent(replica.content);
    assert.deepEqual([...replica.labels], [1, 2, 3]);
    for (const word of ['doubt', 'state']) await page.ask(word);
    await page.ask('doubtful', { below: 1 });
    await page.ask('cid', { place: 1 });
    assert.equal((await program.interrupt()).code, 0);
  });

  await t.test('1 point, and 20 in one place', async () => {
    writePositions(path('one.pcd'), { x: [5], y: [6], z: [7] });
    writePositions(path('same.pcd'), {
      x: Array(20).fill(1),
      y: Array(20).fill(2),
      z: Array(20).fill(3),
    });
    for (const name of ['one.pcd', 'same.pcd']) {
      const program = await start(t, [path(name)]);
      const page = await program.connect();
      const replica = await stateOf(page);
      replica.apply(await page.do('click', { place: 0, class: 'a' }));
      assertConsistent(replica.content);
      assertSameSession((await stateOf(page)).content, replica.content);
      assert.equal((await program.interrupt()).code, 0);
    }
  });
});

test('an organized scan with NaN', async (t) => {
  const scan = join(temporaryFolder(t), 'organized.pcd');
  const cloud = smallRoom(1200);
  const isHole = (i) => i % 7 === 3;
  for (const axis of ['x', 'y', 'z'])
    cloud[axis] = cloud[axis].map((v, i) => (isHole(i) ? NaN : v));
  cloud.z[12] = Infinity;
  writePositions(scan, cloud, { width: 40, height: 30 });
  const finite = cloud.x.filter((v, i) => !isHole(i) && i !== 12).length;
  const program = await start(t, [scan, '--seeds', '5']);
  const facts = await program.scan();
  assert.equal(facts.points, 1200);
  assert.equal(facts.places, finite);
  const positions = await program.positions();
  assert.equal(positions.length, 3 * finite);
  assert.ok(positions.every(Number.isFinite));
  const page = await program.connect();
  const replica = await stateOf(page);
  assert.equal(replica.labels.length, finite);
  assert.equal(replica.summary.unlabeled, finite);
  const seen = new Set();
  for (let place = 0; place < finite; place += 17) {
    const { index, position } = await page.ask('inspect', { place });
    assert.ok(!isHole(index) && index !== 12 && !seen.has(index));
    seen.add(index);
    ['x', 'y', 'z'].forEach((axis, k) =>
      assert.ok(Math.abs(position[k] - cloud[axis][index]) < 1e-5),
    );
  }
  replica.apply(await page.do('click', { place: 3, class: 'a' }));
  const all = Uint32Array.from({ length: finite }, (_, place) => place);
  replica.apply(await page.do('paint', { class: 'b' }, { places: all }));
  assert.equal(replica.summary.unlabeled, 0);
  replica.apply(await page.do('paint', { label: null }, { places: all }));
  assertConsistent(replica.content);
  assertSameSession((await stateOf(page)).content, replica.content);
});

test('a scan in UTM coordinates, as double', async (t) => {
  const scan = join(temporaryFolder(t), 'utm.pcd');
  const cloud = smallRoom(1500);
  const shift = { x: 448262.125, y: 5411932.25, z: 117.5 };
  const file = {};
  for (const axis of ['x', 'y', 'z'])
    file[axis] = cloud[axis].map((v) => v + shift[axis]);
  writePcd(scan, { x: ['F8', file.x], y: ['F8', file.y], z: ['F8', file.z] });
  const program = await start(t, [scan, '--seeds', '5']);
  const facts = await program.scan();
  const positions = await program.positions();
  assert.ok(
    positions.every((v) => Math.abs(v) < 10),
    'positions are local',
  );
  const page = await program.connect();
  for (let place = 0; place < facts.places; place += 50) {
    const { index, position } = await page.ask('inspect', { place });
    ['x', 'y', 'z'].forEach((axis, k) => {
      assert.ok(
        Math.abs(positions[3 * place + k] + facts.origin[k] - file[axis][index]) < 2e-6,
      );
      assert.ok(Math.abs(position[k] - file[axis][index]) < 2e-6);
    });
  }
  // The same points without the shift are in the same order of places.
  facts.low.forEach((low, k) =>
    assert.ok(low <= positions[k] && positions[k] <= facts.high[k]),
  );
});

test('colors are those of the places', async (t) => {
  const scan = join(temporaryFolder(t), 'color.pcd');
  const cloud = smallRoom(500);
  const rgb = cloud.x.map((_, i) => ((i % 251) << 16) | ((i % 13) << 8) | (i % 7));
  writePcd(scan, {
    x: ['F4', cloud.x],
    y: ['F4', cloud.y],
    z: ['F4', cloud.z],
    rgb: ['U4', rgb],
  });
  const program = await start(t, [scan, '--seeds', '5']);
  assert.equal((await program.scan()).has_color, true);
  const { status, body } = await program.get('/api/colors');
  assert.equal(status, 200);
  assert.equal(body.length, 3 * 500);
  const page = await program.connect();
  for (let place = 0; place < 500; place += 9) {
    const { index } = await page.ask('inspect', { place });
    assert.deepEqual(
      [...body.subarray(3 * place, 3 * place + 3)],
      [index % 251, index % 13, index % 7],
    );
  }
});

test('ports, pages and classes', async (t) => {
  const folder = temporaryFolder(t);
  const scan = join(folder, 'small.pcd');
  const session = join(folder, 'small.session');
  writePositions(scan, smallRoom(800));

  await t.test(
    'a port in use is refused, and the session can be begun later',
    async () => {
      const taken = createServer().listen(0, '127.0.0.1');
      await until(() => taken.listening, 'a port');
      const { port } = taken.address();
      await assertEnds(
        t,
        [scan, '--port', String(port)],
        new RegExp(`${port}.*in use`),
      );
      taken.close();
      const content = await contentOf(t, [scan, '--seeds', '5']);
      assert.equal(content.seeds.length, 5);
    },
  );

  await t.test(
    'a folder without a page is refused before anything is made',
    async () => {
      const fresh = join(folder, 'fresh.session');
      await assertEnds(t, [scan, '--session', fresh, '--page', folder], /index\.html/);
      await assertEnds(
        t,
        [scan, '--session', fresh, '--page', join(folder, 'none')],
        /--page/,
      );
      assert.equal(existsSync(fresh), false);
    },
  );

  await t.test('a page from a folder is served', async () => {
    const page = join(folder, 'page');
    mkdirSync(page);
    writeFileSync(join(page, 'index.html'), '<p>hello</p>');
    const program = await start(t, [scan, '--page', page]);
    assert.equal((await program.get('/')).body.toString(), '<p>hello</p>');
    for (const path of [
      '/../small.pcd',
      '/%2e%2e/small.pcd',
      '/..%2fsmall.pcd',
      '/none',
    ])
      assert.notEqual((await program.get(path)).status, 200, path);
    await program.interrupt();
  });

  await t.test(
    'classes come in their order; twice the same, or none, is refused',
    async () => {
      const classes = join(folder, 'classes.txt');
      writeFileSync(classes, 'Stuhl\r\nTür  \n\n椅子\n');
      const program = await start(t, [scan, '--classes', classes]);
      assert.deepEqual((await program.scan()).classes, [
        { name: 'Stuhl' },
        { name: 'Tür' },
        { name: '椅子' },
      ]);
      await program.interrupt();
      writeFileSync(classes, 'chair\ntable\nchair\n');
      await assertEnds(t, [scan, '--classes', classes], /line 3.*chair/);
      writeFileSync(classes, '\n\n');
      await assertEnds(t, [scan, '--classes', classes], /class/);
      await assertEnds(t, [scan, '--classes', join(folder, 'none')], /none/);
      writeFileSync(classes, Buffer.from([0xff, 0xfe, 0x41, 0x0a]));
      const strange = await start(t, [scan, '--classes', classes]);
      assert.equal((await strange.scan()).classes.length, 1);
      assert.ok(existsSync(session));
    },
  );
});

/** The labels of a state by the points of the file. */
async function labelsByPoint(page, count) {
  const { arrays } = await page.ask('state');
  const labels = new Array(count).fill(0);
  // One after another: the same question again cancels the one before.
  for (let place = 0; place < arrays.labels.length; ++place) {
    const { index } = await page.ask('inspect', { place });
    labels[index] = arrays.labels[place];
  }
  return labels;
}

test('labels that were given elsewhere', async (t) => {
  await t.test(
    'a field of the sample scan: equal afterwards, to the point',
    async () => {
      const scan = sampleScan(t);
      const { fields } = readPcd(scan);
      const program = await start(t, [
        scan,
        '--import',
        'label',
        '--classes',
        's3dis',
        '--seeds',
        '30',
      ]);
      const page = await program.connect();
      const replica = await stateOf(page);
      const { files } = await page.ask('export', { format: 'pcd', file: 'imported' });
      assert.ok(files[0].endsWith('imported.pcd'), files[0]);
      const imported = readPcd(join(scan, '../imported.pcd')).fields.label[1];
      assert.deepEqual(imported, fields.label[1]);
      const classes = (await program.scan()).classes.map(({ name }) => name);
      const sizes = new Map();
      fields.label[1].forEach((label) => sizes.set(label, (sizes.get(label) ?? 0) + 1));
      assert.equal(replica.summary.instances.length, sizes.size);
      for (const instance of replica.summary.instances) {
        assert.equal(instance.size, sizes.get(instance.label));
        const at = fields.label[1].indexOf(instance.label);
        assert.equal(instance.class, classes[fields.semantic[1][at] - 1]);
      }
      const { content } = replica;
      await program.interrupt();
      assertSameSession(await contentOf(t, [scan]), content);
    },
  );

  await t.test('fields of strange numbers', async () => {
    const folder = temporaryFolder(t);
    const cloud = smallRoom(600);
    const write = (name, type, labels) => {
      const scan = join(folder, name);
      writePcd(scan, {
        x: ['F4', cloud.x],
        y: ['F4', cloud.y],
        z: ['F4', cloud.z],
        mark: [type, labels],
      });
      return scan;
    };
    const some = cloud.x.map((x) => (x < 1 ? 7 : x < 2 ? 0 : 200));
    for (const type of ['U1', 'U2', 'I4', 'U4', 'F4']) {
      const program = await start(t, [
        write(`${type}.pcd`, type, some),
        '--import',
        'mark',
        '--seeds',
        '4',
      ]);
      assert.deepEqual(await labelsByPoint(await program.connect(), 600), some, type);
      await program.interrupt();
    }
    const high = cloud.x.map((x) => (x < 1 ? 0xfffffffd : 3));
    const program = await start(t, [
      write('high.pcd', 'U4', high),
      '--import',
      'mark',
      '--seeds',
      '4',
    ]);
    assert.deepEqual(await labelsByPoint(await program.connect(), 600), high);
    await program.interrupt();
    const none = cloud.x.map((x) => (x < 1 ? 1 : -1)); // as others write no label
    const minus = await start(t, [
      write('minus.pcd', 'I4', none),
      '--import',
      'mark',
      '--seeds',
      '4',
    ]);
    assert.deepEqual(
      await labelsByPoint(await minus.connect(), 600),
      none.map((label) => Math.max(label, 0)),
    );
    await minus.interrupt();
    const half = cloud.x.map((x) => (x < 1 ? 1 : 0.5));
    await assertEnds(
      t,
      [write('half.pcd', 'F4', half), '--import', 'mark', '--seeds', '4'],
      /0\.5/,
    );
    await assertEnds(t, [write('a.pcd', 'U4', some), '--import', 'none'], /none/);
    await assertEnds(
      t,
      [write('a.pcd', 'U4', some), '--import', 'none.csv'],
      /none\.csv/,
    );
  });

  await t.test(
    'a label that is none of ours is refused before a session is begun',
    async () => {
      const { scan } = markedRoom(t, 600, (x) => (x < 1 ? 1 : 0xffffffff));
      await assertEnds(t, [scan, '--import', 'mark', '--seeds', '4'], /4294967295/);
      // The next try is not "begun already".
      await assertEnds(t, [scan, '--import', 'mark', '--seeds', '4'], /4294967295/);
    },
  );

  await t.test(
    'the same command goes on after an import',
    async () => {
      const { scan } = markedRoom(t, 600, (x) => (x < 1 ? 7 : 2));
      const args = [scan, '--import', 'mark', '--seeds', '4'];
      const content = await contentOf(t, args);
      assertSameSession(await contentOf(t, args), content);
    },
  );

  await t.test(
    'an import that was killed is not taken for a whole one',
    async () => {
      const { folder, scan, mark } = markedRoom(t, 4000, (_, i) => 1 + (i % 500));
      const args = [scan, '--import', 'mark', '--seeds', '4'];
      const first = new Program(args);
      t.after(() => first.kill());
      const session = join(folder, 'a.session');
      await until(
        () =>
          existsSync(session) && readFileSync(session, 'utf8').split('\n').length > 6,
        'a part',
      );
      await first.kill();
      const program = await start(t, args);
      assert.deepEqual(await labelsByPoint(await program.connect(), 4000), mark);
    },
  );

  await t.test('a table of seeds, which was exported', async () => {
    const folder = temporaryFolder(t);
    const scan = join(folder, 'a.pcd');
    writePositions(scan, smallRoom(1500));
    const program = await start(t, [scan, '--seeds', '6']);
    const page = await program.connect();
    await page.do('click', { place: 10, class: 'chair', name: 'x' });
    await page.do('click', { place: 20, class: 'table' });
    await page.do('click', { place: 30, label: 1 });
    await page.do('settle');
    const { content } = await stateOf(page);
    await page.ask('export', { format: 'seeds', file: 'given' });
    await program.interrupt();
    const table = join(folder, 'given.seeds.csv');
    const fresh = join(folder, 'fresh.session');
    const imported = await contentOf(t, [scan, '--session', fresh, '--import', table]);
    assert.deepEqual([...imported.labels], [...content.labels]);
    const bySeed = (a, b) => a.key - b.key;
    assert.deepEqual(imported.seeds.sort(bySeed), content.seeds.sort(bySeed));
    writeFileSync(table, 'hello\n1,2\n');
    await assertEnds(
      t,
      [scan, '--session', join(folder, 'b.session'), '--import', table],
      /given\.seeds\.csv/,
    );
  });
});
