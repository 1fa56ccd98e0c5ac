/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The work of an annotator, against the mock or, with STUDIO_PROGRAM and STUDIO_SCAN, with the real program.
 */

import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { clickPlace, counts, idle, launch, openStudio, placeWhere, press as pressOn, shot, studio } from './browser.mjs';
import { copyOf, labelCounts, startProgram } from './program.mjs';

const real = process.env.STUDIO_PROGRAM;
const onlyMock = real ? { skip: 'needs the mock' } : {};
const onlyReal = real ? {} : { skip: 'needs the real program' };
let world, mock, copy, program, browser, page, url;

async function startMock(port = 0) {
  const { startMock: start } = await import('../mock/server.mjs');
  mock = await start(world, { port });
  url = mock.url;
}

async function startReal(options = []) {
  program = await startProgram(real, copy.scan, ['--classes', 's3dis', ...options]);
  url = program.url;
}

before(async () => {
  if (real) {
    copy = copyOf(process.env.STUDIO_SCAN);
    await startReal();
  } else {
    const { World } = await import('../mock/world.mjs');
    world = new World();
    await startMock();
  }
  browser = await launch();
  page = await openStudio(browser, url);
});

after(async () => {
  await browser?.close();
  await mock?.close();
  await program?.end('SIGINT');
  copy?.remove();
});

const press = (...keys) => pressOn(page, ...keys);

/** From another test nothing may be open, and the whole scan is seen. */
const calm = async () => {
  await press('Escape', 'Escape', 'Escape');
  await page.evaluate(() => document.querySelector('canvas.cloud').focus());
  await press('h');
  await page.mouse.move(700, 500);
  await idle(page);
};

describe('the page of the studio', () => {
  test('opens with the scan in view', async () => {
    await shot(page, '01_open');
    assert.ok((await counts(page)).questions >= 10);
    assert.notEqual(await placeWhere(page), null);
  });

  test('answers ten questions by the keyboard alone', async () => {
    const start = await counts(page);
    await press('Space');
    for (let i = 0; i < 10; i++) {
      const question = await studio(page, () => window.studio.question());
      assert.ok(question, `question ${i}`);
      if (i === 0) await shot(page, '02_question');
      if (i === 4) {
        await page.keyboard.type('cha');
        await shot(page, '03_typing');
        await press('Enter');
      } else if (i === 5) await press('Enter');
      else if (i === 6) await press('0');
      else if (i === 7) await press('Shift+Digit1');
      else if (i === 8) {
        await press('Shift+Space');
        const next = await studio(page, () => window.studio.question());
        assert.notEqual(next.seed, question.seed);
        await page.keyboard.type('strange lamp');
        await press('Enter');
      } else await press(String(Math.min(1 + i, 9)));
      const seed = i === 8 ? null : question.seed;
      if (seed !== null) {
        const label = await studio(page, (k) => window.studio.seeds().find((one) => one.key === k).label, seed);
        assert.equal(i === 6 ? label === 0 : label > 0, true, `answer ${i}`);
      }
    }
    const end = await counts(page);
    assert.equal(end.questions, start.questions - 10);
    assert.equal(end.undo, start.undo + 10);
    const classes = (await studio(page, () => window.studio.instances())).map((one) => one.class);
    assert.ok(classes.includes('strange lamp'));
    assert.ok(classes.filter((name) => name === 'chair').length >= 2); // typed, and the same by Enter
  });

  test('undo takes the last answer back, redo gives it again', async () => {
    await calm();
    const start = await counts(page);
    await press('Control+z', 'Control+z');
    assert.equal((await counts(page)).undo, start.undo - 2);
    assert.equal((await counts(page)).redo, 2);
    await press('Control+y', 'Control+Shift+Z');
    assert.equal((await counts(page)).undo, start.undo);
  });

  test('corrects points by clicks: class, active instance, picked instance', async () => {
    await calm();
    await press('b');
    await shot(page, '04_instances');
    const one = await placeWhere(page, 'studio.labelOf(place) > 0');
    await clickPlace(page, one);
    await idle(page);
    await shot(page, '05_correct');
    assert.equal(await studio(page, () => window.studio.asking()), 'point');
    const before = await studio(page, () => window.studio.instances().length);
    await press('9');
    assert.equal(await studio(page, () => window.studio.instances().length), before + 1);
    const label = await studio(page, (p) => window.studio.labelOf(p), one);

    await clickPlace(page, one, { modifiers: ['Alt'] });
    const two = await placeWhere(page, `studio.labelOf(place) !== ${label}`);
    await clickPlace(page, two, { modifiers: ['Shift'] });
    await idle(page);
    assert.equal(await studio(page, (p) => window.studio.labelOf(p), two), label);

    const three = await placeWhere(page, `studio.labelOf(place) > 0 && studio.labelOf(place) !== ${label}`);
    await clickPlace(page, three);
    await idle(page);
    await press('Control+i');
    const target = await placeWhere(page, `studio.labelOf(place) === ${label}`);
    await clickPlace(page, target);
    await idle(page);
    assert.equal(await studio(page, (p) => window.studio.labelOf(p), three), label);
  });

  test('the keyboard alone corrects what is in the middle', async () => {
    await calm();
    const start = await counts(page);
    await press('ArrowRight', 'Enter');
    assert.equal(await studio(page, () => window.studio.asking()), 'point');
    await press('2');
    assert.equal((await counts(page)).undo, start.undo + 1);
  });

  test('letters after a turn of the view begin a class in the open card', async () => {
    await calm();
    const start = await counts(page);
    await clickPlace(page, await placeWhere(page));
    await idle(page);
    assert.equal(await studio(page, () => window.studio.asking()), 'point');
    await page.mouse.move(300, 500);
    await page.mouse.down();
    await page.mouse.move(340, 500, { steps: 3 });
    await page.mouse.up();
    await idle(page);
    const focused = () => studio(page, () => document.activeElement.className);
    assert.match(await focused(), /cloud/);
    const mode = await studio(page, () => window.studio.mode());
    await page.keyboard.press('Shift+KeyV'); // V and Shift+V, C and U are keys of the view
    await page.keyboard.type('cu lamp');
    assert.match(await focused(), /class-field/);
    assert.equal(await page.inputValue('.class-field'), 'Vcu lamp');
    await press('Enter');
    assert.equal(await studio(page, () => window.studio.mode()), mode);
    assert.ok((await studio(page, () => window.studio.instances())).some((one) => one.class === 'Vcu lamp'));
    await press('Control+z');
    assert.equal((await counts(page)).undo, start.undo);
  });

  test('a lasso labels what is seen in it, and undo takes it back', async () => {
    await calm();
    await press('l');
    const middle = { x: 560, y: 440 };
    const draw = async () => {
      await page.mouse.move(middle.x + 60, middle.y);
      await page.mouse.down();
      for (let a = 1; a < 12; a++) {
        await page.mouse.move(middle.x + 60 * Math.cos(a / 2), middle.y + 60 * Math.sin(a / 2));
      }
      await page.mouse.up();
      await idle(page);
    };
    await draw();
    await shot(page, '06_lasso');
    assert.equal(await studio(page, () => window.studio.asking()), 'lasso');
    await page.keyboard.type('picture');
    await press('Enter');
    const painted = (await studio(page, () => window.studio.instances())).at(-1);
    assert.equal(painted.class, 'picture');
    assert.ok(painted.size > 20);
    const outside = await studio(page, ([label, m]) => {
      const { places } = window.studio.counts();
      for (let p = 0; p < places; p++) {
        if (window.studio.labelOf(p) !== label) continue;
        const at = window.studio.project(p);
        if (Math.hypot(at.x - m.x, at.y - m.y) > 62 || !window.studio.drawn(p)) return p;
      }
      return null;
    }, [painted.label, middle]);
    assert.equal(outside, null);
    await page.keyboard.down('Alt');
    await draw();
    await page.keyboard.up('Alt');
    const left = (await studio(page, () => window.studio.instances())).find((one) => one.label === painted.label);
    assert.equal(left?.size ?? 0, 0);
    await press('Escape', 'Control+z', 'Control+z');
    assert.equal((await studio(page, () => window.studio.instances())).some((one) => one.label === painted.label), false);
  });

  test('what the ceiling cut takes away is never picked', async () => {
    await calm();
    if ((await studio(page, () => window.studio.ceiling())) > 1e6) await press('c');
    for (let i = 0; i < 12; i++) await page.keyboard.press('[');
    await idle(page);
    await shot(page, '07_ceiling');
    const wrong = await studio(page, () => {
      let hits = 0;
      for (let x = 200; x < 1000; x += 80) {
        for (let y = 120; y < 820; y += 70) {
          const place = window.studio.pickAt(x, y);
          if (place === null) continue;
          hits++;
          if (window.studio.position(place)[2] > window.studio.ceiling() || !window.studio.drawn(place)) return 'cut';
        }
      }
      return hits > 5 ? null : 'nothing is hit';
    });
    assert.equal(wrong, null);
    for (let i = 0; i < 12; i++) await page.keyboard.press(']');
  });

  test('a hidden instance is neither drawn nor picked; isolate and show all', async () => {
    await calm();
    const place = await placeWhere(page, 'studio.labelOf(place) > 0');
    const label = await studio(page, (p) => window.studio.labelOf(p), place);
    await page.hover(`.instance[data-label="${label}"]`);
    await page.click(`.instance[data-label="${label}"] .eye`);
    await idle(page);
    const at = await studio(page, (p) => window.studio.project(p), place);
    const hit = await studio(page, ({ x, y }) => window.studio.pickAt(x, y), at);
    assert.ok(hit === null || (await studio(page, (p) => window.studio.labelOf(p), hit)) !== label);
    await page.click(`.instance[data-label="${label}"] .eye`, { modifiers: ['Alt'] });
    await idle(page);
    assert.notEqual(await placeWhere(page, `studio.labelOf(place) === ${label}`), null);
    assert.equal(await placeWhere(page, `studio.labelOf(place) !== ${label}`), null);
    await shot(page, '08_isolated');
    await page.evaluate(() => document.querySelector('canvas.cloud').focus());
    await press('Shift+H');
    assert.notEqual(await placeWhere(page, `studio.labelOf(place) !== ${label}`), null);
  });

  test('the list renames, merges and deletes', async () => {
    await calm();
    await press('j', 'ArrowDown', 'F2');
    await page.keyboard.type('lamp');
    await page.keyboard.press('Tab');
    await page.keyboard.type('by the door');
    await press('Enter');
    const all = await studio(page, () => window.studio.instances());
    assert.ok(all.some((one) => one.class === 'lamp' && one.name === 'by the door'));
    await press('Home', 'ArrowDown', 'Enter', 'ArrowDown', 'Shift+Enter');
    await shot(page, '09_merge');
    await press('m');
    assert.equal((await studio(page, () => window.studio.instances().length)), all.length - 1);
    await press('Delete');
    assert.equal((await studio(page, () => window.studio.instances().length)), all.length - 2);
    await press('Control+z', 'Control+z', 'Control+z');
    assert.equal((await studio(page, () => window.studio.instances().length)), all.length);
  });

  test('the view turns about the point under the cursor, and flies', async () => {
    await calm();
    const place = await studio(page, () => window.studio.pickAt(480, 380));
    assert.notEqual(place, null);
    const where = () => studio(page, (p) => window.studio.project(p), place);
    const [start, middle] = [await where(), 123];
    const other = await studio(page, (p) => window.studio.project(p), middle);
    await page.mouse.move(480, 380);
    await page.mouse.down();
    await page.mouse.move(580, 410, { steps: 4 });
    await page.mouse.up();
    await idle(page);
    const turned = await where();
    assert.ok(Math.hypot(turned.x - start.x, turned.y - start.y) < 2);
    const after = await studio(page, (p) => window.studio.project(p), middle);
    assert.ok(Math.hypot(after.x - other.x, after.y - other.y) > 5);
    await page.keyboard.down('d');
    // As long as it takes: a software renderer draws few frames a second.
    await page.waitForFunction(([p, x]) => window.studio.project(p).x < x, [place, turned.x - 5]);
    await page.keyboard.up('d');
    await idle(page);
  });

  test('all color modes', async () => {
    await calm();
    const seen = new Set();
    for (let i = 0; i < 7; i++) {
      await press('v');
      const mode = await studio(page, () => window.studio.mode());
      if (mode === 'cid') {
        await page.mouse.move(600, 470);
        await page.waitForTimeout(250);
        await idle(page);
      }
      await page.waitForTimeout(50);
      await idle(page);
      await shot(page, `10_${mode}`);
      seen.add(mode);
    }
    assert.ok(seen.size >= 6);
    await press('Shift+U');
    await shot(page, '11_doubtful');
  });

  test('saves as other formats, and says why it could not', onlyMock, async () => {
    await calm();
    await press('Control+s', 'Enter');
    await page.waitForSelector('.outcome .right');
    await page.fill('.export input[name=file]', 'fail');
    await press('Enter');
    await page.waitForSelector('.outcome .wrong');
    assert.match(await page.textContent('.outcome'), /no space left/);
    await shot(page, '12_save');
    await page.keyboard.press('Escape');
  });

  test('saves files that are there', onlyReal, async () => {
    await calm();
    await press('Control+s');
    await page.check('.export input[value=ply]');
    await page.focus('.export input[name=file]');
    await press('Enter');
    await page.waitForSelector('.outcome .right');
    await shot(page, '12_save');
    const [file] = await page.$$eval('.outcome li', (all) => all.map((one) => one.textContent));
    assert.ok(file.startsWith(copy.folder), file);
    const given = new Map((await studio(page, () => window.studio.instances())).map((one) => [one.label, one.size]));
    given.set(0, (await counts(page)).unlabeled);
    const saved = labelCounts(file);
    for (const [label, size] of given) assert.equal(saved.get(label) ?? 0, size, `label ${label}`);
    assert.equal([...saved.values()].reduce((a, b) => a + b), 140000);
    await page.fill('.export input[name=file]', 'no/where');
    await press('Enter');
    await page.waitForSelector('.outcome .wrong');
    assert.match(await page.textContent('.outcome'), /without folders/);
    await page.keyboard.press('Escape');
  });

  test('loses nothing when the program is killed', onlyReal, async () => {
    await calm();
    const before = await counts(page);
    const seen = (p) => studio(p, () => [window.studio.instances(), window.studio.seeds(), window.studio.counts()]);
    const state = await seen(page);
    await program.end('SIGKILL');
    await page.waitForSelector('.banner.away');
    const { port } = new URL(url);
    await startReal(['--port', port]);
    await page.waitForSelector('.banner.away:has-text("started again")');
    await page.goto(url);
    await page.waitForFunction(() => window.studio?.connected());
    await idle(page);
    assert.deepEqual(await seen(page), state);
    assert.equal((await counts(page)).undo, before.undo);
    page.problems = page.problems.filter((text) => !/ERR_CONNECTION_REFUSED|WebSocket connection|401/.test(text));
  });

  test('help lists all keys that are bound', async () => {
    await calm();
    await page.keyboard.press('?');
    await shot(page, '13_help');
    const text = await page.textContent('dialog.help');
    for (const what of ['Next question', 'Lasso', 'Undo', 'Cut the ceiling away', 'Section box', 'From above']) {
      assert.ok(text.includes(what), what);
    }
    await page.keyboard.press('Escape');
  });

  test('a second tab looks on and cannot write', async () => {
    const second = await openStudio(browser, url, { context: page.context() });
    assert.equal(await studio(second, () => window.studio.writer()), false);
    const before = await counts(second);
    await second.keyboard.press('Space');
    await idle(second);
    assert.equal((await counts(second)).revision, before.revision);
    assert.ok(await second.isVisible('.banner.looks'));
    assert.ok(await second.isDisabled('[data-tool=next]'));
    await shot(second, '14_second_tab');
    await page.bringToFront();
    await calm();
    await press('Control+z', 'Control+y');
    await second.bringToFront();
    await idle(second);
    assert.equal((await counts(second)).revision, (await counts(page)).revision);
    assert.deepEqual(second.problems, []);
    await second.close();
    await page.bringToFront();
  });

  test('comes back by itself when the server was away', onlyMock, async () => {
    await calm();
    const before = await counts(page);
    const { port } = mock;
    await mock.close();
    await page.waitForSelector('.banner.away');
    await press('Space');
    await page.waitForSelector('.message.error');
    await shot(page, '15_away');
    await startMock(port);
    await page.waitForFunction(() => window.studio.connected());
    await page.waitForSelector('.banner.away', { state: 'detached' });
    assert.deepEqual(await counts(page), before);
    // The browser itself reports the refused connections.
    page.problems = page.problems.filter((text) => !/ERR_CONNECTION_REFUSED|WebSocket connection/.test(text));
    await page.click('.message.error button');
  });

  test('a small window', async () => {
    await page.setViewportSize({ width: 1024, height: 700 });
    await press('Escape', 'Space');
    await shot(page, '16_small');
    const wide = await studio(page, () => [...document.querySelectorAll('button, select')].filter((one) => one.offsetParent && one.getBoundingClientRect().right > innerWidth + 0.5).length);
    assert.equal(wide, 0);
  });

  test('nothing went wrong on the way', () => assert.deepEqual(page.problems, []));
});
