/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The work of an engineer who wants collision geometry, against the mock or, with STUDIO_PROGRAM and
 * STUDIO_SCAN, with the real program.
 */

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, beforeEach, describe, test } from 'node:test';
import { clickPlace, counts, idle, launch, openStudio, partInView, placeWhere, press as pressOn, shot, studio } from './browser.mjs';
import { copyOf, startProgram } from './program.mjs';
import { watchRequests } from './requests.mjs';

const real = process.env.STUDIO_PROGRAM;
const onlyMock = real ? { skip: 'needs the mock' } : {};
let world, mock, copy, program, browser, page, url;

async function startMock(port = 0) {
  const { startMock: start } = await import('../mock/server.mjs');
  mock = await start(world, { port });
  url = mock.url;
}

before(async () => {
  if (real) {
    copy = copyOf(process.env.STUDIO_SCAN);
    program = await startProgram(real, copy.scan);
    url = program.url;
  } else {
    const { World } = await import('../mock/world.mjs');
    world = new World();
    await startMock();
  }
  browser = await launch();
  page = await openStudio(browser, url);
  if (real) page.setDefaultTimeout(60000);
});

after(async () => {
  await browser?.close();
  await mock?.close();
  await program?.end('SIGINT');
  copy?.remove();
});

const press = (...keys) => pressOn(page, ...keys);
/** Keys are for the view again. */
const toView = () => page.evaluate(() => document.querySelector('canvas.cloud').focus());
const parts = (on = page) => studio(on, () => window.studio.parts());
const part = async (number) => (await parts()).list.find((one) => one.part === number);
const hulls = async () => (await studio(page, () => window.studio.hulls())).sort((a, b) => a - b);
const kept = async () => (await parts()).list.filter((one) => !one.dropped).map((one) => one.part).sort((a, b) => a - b);
const allGroups = (list) => list.flatMap((one) => one.groups).sort((a, b) => a - b);
const row = (number) => `.part[data-part="${number}"]`;

const visiblePart = (holds) => partInView(page, holds);

async function decompose(groups) {
  await page.fill('.groups-row input', String(groups));
  await page.keyboard.press('Enter');
  await page.waitForFunction((n) => window.studio.parts().groups === n && !window.studio.decomposing(), groups);
  await idle(page);
  await toView();
}

/** How far, in metres, hulls are from the points of their parts at most: lies of the picture show here. */
async function worstMisfit() {
  return studio(page, () => {
    const boxes = new Map(window.studio.hulls().map((number) => [number, { low: [1e9, 1e9, 1e9], high: [-1e9, -1e9, -1e9] }]));
    const { places } = window.studio.counts();
    for (let place = 0; place < places; place++) {
      const box = boxes.get(window.studio.partOf(place));
      if (!box) continue;
      window.studio.position(place).forEach((v, k) => {
        box.low[k] = Math.min(box.low[k], v);
        box.high[k] = Math.max(box.high[k], v);
      });
    }
    let worst = 0;
    for (const [number, box] of boxes) {
      const hull = window.studio.hullBox(number);
      for (let k = 0; k < 3; k++) worst = Math.max(worst, Math.abs(hull.low[k] - box.low[k]), Math.abs(hull.high[k] - box.high[k]));
    }
    return worst;
  });
}

describe('parts mode', () => {
  beforeEach(async () => {
    await toView();
    await press('Escape', 'h');
  });

  test('has a place of its own', async () => {
    await press('g');
    assert.equal(await studio(page, () => window.studio.workMode()), 'parts');
    assert.equal(await page.getAttribute('[data-tool=parts]', 'aria-pressed'), 'true');
    assert.equal(await studio(page, () => window.studio.mode()), 'part');
    assert.equal((await parts()).groups, 0);
    assert.ok(await page.isVisible('.cut >> text=nearly convex'));
    for (const what of ['[aria-label=Instances]', '[data-tool=next]', '[data-tool=lasso]']) assert.equal(await page.isVisible(what), false, what);
    await press('Space', 'l', '1');
    assert.equal(await studio(page, () => window.studio.asking()), null);
    await shot(page, '20_no_parts');
  });

  test('decomposes', async () => {
    await decompose(30);
    await shot(page, '21_decomposed');
    const { groups, list, undo } = await parts();
    assert.equal(groups, 30);
    assert.equal(undo, 1);
    assert.deepEqual(allGroups(list), Array.from({ length: 30 }, (_, i) => i));
    assert.deepEqual(await hulls(), await kept());
    assert.equal(await studio(page, () => window.studio.measured()), list.length);
    const found = await studio(page, () => {
      let n = 0;
      for (let place = 0; place < window.studio.counts().places; place++) if (window.studio.partOf(place) !== null) n++;
      return n;
    });
    assert.equal(found, list.reduce((sum, one) => sum + one.size, 0));
    assert.ok((await worstMisfit()) < 0.15, String(await worstMisfit()));
  });

  test('the slider chooses how many, and hulls follow', async () => {
    for (const [key, n] of [['End', 30], ['Home', 1], ['ArrowRight', 2]]) {
      await page.focus('.cut input[type=range]');
      await press(key);
      assert.equal((await parts()).list.length, n);
      assert.equal(await page.inputValue('.cut-row input[type=number]'), String(n));
      assert.deepEqual(await hulls(), await kept());
      assert.ok((await worstMisfit()) < 0.15);
      assert.match(await page.textContent('.cost'), n === 1 ? /one part/ : /next merge costs/);
    }
    await page.fill('.cut-row input[type=number]', '17');
    await press('Enter');
    assert.equal((await parts()).list.length, 17);
    await toView();
    await press(',', ',', '.');
    assert.equal((await parts()).list.length, 16);
  });

  test('dragging the slider never queues, and shows no hull of another state', async () => {
    const requests = watchRequests(page);
    await page.reload();
    await page.waitForFunction(() => window.studio?.parts().groups === 30);
    await idle(page);
    assert.equal(await studio(page, () => window.studio.workMode()), 'parts');
    const { x, y, width, height } = await (await page.$('.cut input[type=range]')).boundingBox();
    await page.mouse.move(x + 0.2 * width, y + height / 2);
    await page.mouse.down();
    for (let i = 0; i <= 6; i++) {
      // Several steps at once: questions meet what the parts have become.
      await page.mouse.move(x + width * (0.95 - 0.75 * Math.abs(Math.sin(i))), y + height / 2, { steps: 4 });
      const ghosts = await studio(page, () => window.studio.hulls().filter((number) => !window.studio.parts().list.some((one) => one.part === number)));
      assert.deepEqual(ghosts, []);
      if (i % 3 === 0) assert.ok((await worstMisfit()) < 0.15);
    }
    await page.mouse.up();
    await idle(page);
    assert.equal((await parts()).list.length, Number(await page.inputValue('.cut input[type=range]')));
    assert.deepEqual(await hulls(), await kept());
    await toView();
    for (let i = 0; i < 4; i++) {
      await press(',');
      assert.ok((await worstMisfit()) < 0.15, `${(await parts()).list.length} parts`);
    }
    assert.ok(requests.sent('cut') > 1);
    assert.equal(requests.mostAtOnce('cut'), 1);
    // The slider has the focus; keys of the page still work.
    await page.focus('.cut input[type=range]');
    const before_ = (await parts()).undo;
    await press('Control+z');
    assert.equal((await parts()).undo, before_ - 1);
    await page.fill('.cut-row input[type=number]', '12');
    await press('Enter');
  });

  test('a click selects what it meets first', async () => {
    const place = await placeWhere(page, 'studio.partOf(place) !== null');
    const at = await studio(page, (p) => window.studio.project(p), place);
    await press('k');
    assert.deepEqual(await hulls(), []);
    await clickPlace(page, place);
    assert.equal((await parts()).selected, await studio(page, (p) => window.studio.partOf(p), place));
    await press('k');
    const first = await studio(page, ({ x, y }) => window.studio.partAt(x, y).part, at);
    await clickPlace(page, place);
    assert.equal((await parts()).selected, first);
    assert.equal(await page.getAttribute(row(first), 'aria-selected'), 'true');
    await shot(page, '22_selected');
    await press('f');
    await shot(page, '23_focused');
    await press('p');
    assert.equal(await studio(page, () => window.studio.pickAt(500, 400)), null);
    assert.notEqual(await visiblePart(), null);
    await shot(page, '24_hulls_alone');
    await press('p', 'Escape');
    assert.equal((await parts()).selected, null);
  });

  test('the keyboard alone selects what is in the middle', async () => {
    await toView();
    await press('ArrowRight', 'Enter');
    assert.notEqual((await parts()).selected, null);
    await press('j', 'Home', 'Enter');
    const first = await page.getAttribute('.part.cursor', 'data-part');
    assert.equal((await parts()).selected, Number(first));
  });

  test('splits, takes it back, does it again', async () => {
    const start = await parts();
    const at = await visiblePart('part.splits');
    await page.mouse.click(at.x, at.y);
    await press('/');
    const split = await parts();
    assert.equal(split.list.length, start.list.length + 1);
    assert.deepEqual(allGroups(split.list), allGroups(start.list));
    assert.equal(split.selected, at.part);
    assert.deepEqual(await hulls(), await kept());
    await press('Control+z');
    assert.deepEqual((await parts()).list, start.list);
    assert.deepEqual(await hulls(), await kept());
    await press('Control+y');
    assert.deepEqual((await parts()).list, split.list);
    assert.ok((await worstMisfit()) < 0.15);
  });

  test('joins two: by keys, and by the button', async () => {
    const start = await parts();
    const one = await visiblePart();
    const two = await visiblePart(`part.part !== ${one.part}`);
    await page.mouse.click(one.x, one.y);
    await page.keyboard.down('Shift');
    await page.mouse.click(two.x, two.y);
    await page.keyboard.up('Shift');
    assert.equal((await parts()).second, two.part);
    await shot(page, '25_two');
    await press('m');
    const joined = await parts();
    const into = Math.min(one.part, two.part);
    assert.equal(joined.list.length, start.list.length - 1);
    assert.deepEqual((await part(into)).groups, allGroups(start.list.filter((x) => x.part === one.part || x.part === two.part)));
    assert.equal(joined.selected, into);
    assert.equal((await part(into)).height, null);
    await press('Control+z');
    await page.mouse.click(one.x, one.y);
    await page.click('[data-act=join]');
    await page.click(row(two.part));
    await idle(page);
    assert.deepEqual((await parts()).list, joined.list);
    await press('Control+z');
  });

  test('a part that is dropped has no hull, and is kept again', async () => {
    const at = await visiblePart();
    await page.mouse.click(at.x, at.y);
    await press('Delete');
    assert.equal((await part(at.part)).dropped, true);
    assert.equal((await hulls()).includes(at.part), false);
    assert.ok(await page.isVisible(`${row(at.part)} .badge.dropped`));
    await shot(page, '26_dropped');
    await page.click('[data-act=drop]');
    await idle(page);
    assert.equal((await part(at.part)).dropped, false);
    assert.deepEqual(await hulls(), await kept());
    await press('Delete');
  });

  test('an exact hull holds all its points', async () => {
    const at = await visiblePart('!part.dropped');
    await page.mouse.click(at.x, at.y);
    await press('r');
    assert.equal((await part(at.part)).exact, true);
    assert.ok(await page.isVisible(`${row(at.part)} .badge.exact`));
    const outside = await studio(page, (number) => {
      const { low, high } = window.studio.hullBox(number);
      for (let place = 0; place < window.studio.counts().places; place++) {
        if (window.studio.partOf(place) !== number) continue;
        if (window.studio.position(place).some((v, k) => v < low[k] - 1e-4 || v > high[k] + 1e-4)) return place;
      }
      return null;
    }, at.part);
    assert.equal(outside, null);
    assert.equal(await page.getAttribute('[data-act=exact]', 'aria-pressed'), 'true');
  });

  test('lists the worst fit first', async () => {
    await page.selectOption('.parts header select', 'fit');
    const off = await page.$$eval('.part-fit', (all) => all.map((one) => /off ([\d.]+) (c?)m/.exec(one.textContent)).map(([, n, c]) => Number(n) / (c ? 100 : 1)));
    assert.ok(off.length > 3);
    assert.deepEqual(off, [...off].sort((a, b) => b - a));
    await shot(page, '27_worst_first');
    await page.selectOption('.parts header select', 'points');
  });

  test('what the ceiling cut takes away is never selected', async () => {
    const heights = async () =>
      studio(page, () => {
        const found = [];
        for (let x = 40; x < 820; x += 78) {
          for (let y = 90; y < 660; y += 71) {
            const hit = window.studio.partAt(x, y);
            if (hit) found.push(hit.point[2]);
          }
        }
        return found;
      });
    if ((await studio(page, () => window.studio.ceiling())) < 1e6) await press('c');
    const whole = await heights();
    await press('c', ...Array.from({ length: 12 }, () => '['));
    const ceiling = await studio(page, () => window.studio.ceiling());
    await shot(page, '28_ceiling');
    assert.ok(whole.some((z) => z > ceiling));
    const left = await heights();
    assert.ok(left.length > 5);
    assert.ok(left.every((z) => z <= ceiling), `${Math.max(...left)} is above ${ceiling}`);
    await press('p');
    const ofHulls = await heights();
    assert.ok(ofHulls.length > 5);
    assert.ok(ofHulls.every((z) => z <= ceiling + 1e-6));
    await press('p', ...Array.from({ length: 12 }, () => ']'));
  });

  test('saves the parts, and says why it could not', async () => {
    await press('Control+s');
    assert.ok(await page.isVisible('dialog.export >> text=verified in the written files'));
    for (const box of await page.$$('dialog[open] input[name=scenes]')) await box.check();
    await page.check('dialog[open] input[name=report]');
    await shot(page, '29_save');
    await page.focus('dialog[open] input[name=file]');
    await page.keyboard.press('Enter');
    await page.waitForSelector('dialog[open] .outcome .right');
    await shot(page, '30_saved');
    const files = await page.$$eval('dialog[open] .outcome li', (all) => all.map((one) => one.textContent));
    assert.ok(files.length >= 3, files.join());
    assert.match(files[0], /_parts\.obj$/);
    if (real) {
      assert.ok(files[0].startsWith(copy.folder));
      const objects = readFileSync(files[0], 'latin1').match(/^o /gm).length;
      assert.equal(objects, (await kept()).length);
    }
    await page.fill('dialog[open] input[name=file]', real ? 'no/where' : 'fail');
    await page.keyboard.press('Enter');
    await page.waitForSelector('dialog[open] .outcome .wrong');
    await page.keyboard.press('Escape');
  });

  test('help lists the keys of the mode', async () => {
    await page.keyboard.press('?');
    const text = await page.textContent('dialog.help');
    for (const what of ['Split the selected part', 'One part fewer', 'Cut the ceiling away', 'Labels or parts']) assert.ok(text.includes(what), what);
    assert.ok(!text.includes('Next question'));
    await shot(page, '31_help');
    await page.keyboard.press('Escape');
  });

  test('labels are as before, and the parts are there after a reload', async () => {
    const before_ = await parts();
    await press('g');
    assert.equal(await studio(page, () => window.studio.workMode()), 'labels');
    assert.notEqual(await studio(page, () => window.studio.mode()), 'part');
    assert.deepEqual(await hulls(), []);
    assert.ok(await page.isVisible('[aria-label=Instances]'));
    await shot(page, '32_labels_again');
    const { undo, unlabeled, places } = await counts(page);
    assert.equal(unlabeled, places);
    await press('Space');
    assert.equal(await studio(page, () => window.studio.asking()), 'question');
    await page.keyboard.type('lamp');
    await press('Enter', 'Escape');
    assert.equal((await counts(page)).undo, undo + 1);
    await press('Control+z');
    assert.equal((await counts(page)).undo, undo);
    await page.reload();
    await page.waitForFunction(() => window.studio?.connected());
    await idle(page);
    assert.equal(await studio(page, () => window.studio.workMode()), 'labels');
    await press('g');
    assert.deepEqual((await parts()).list, before_.list);
    assert.equal((await parts()).undo, before_.undo);
    assert.deepEqual(await hulls(), await kept());
  });

  test('a second tab looks on', async () => {
    const second = await openStudio(browser, url.replace(/\?.*/, '') + '#parts', { context: page.context() });
    assert.deepEqual((await parts(second)).list, (await parts()).list);
    assert.ok(await second.isDisabled('.groups-row button'));
    assert.ok(await second.isDisabled('.cut input[type=range]'));
    await page.bringToFront();
    await press('.');
    await second.bringToFront();
    await second.waitForFunction((n) => window.studio.hulls().length === n, (await kept()).length);
    assert.deepEqual((await parts(second)).list, (await parts()).list);
    assert.deepEqual(second.problems, []);
    await second.close();
    await page.bringToFront();
  });

  test('comes back by itself when the server was away', onlyMock, async () => {
    if ((await studio(page, () => window.studio.workMode())) === 'labels') await press('g');
    await decompose(20);
    const { list } = await parts();
    const { port } = mock;
    await mock.close();
    await page.waitForSelector('.banner.away');
    world.changeParts({ do: 'cut', parts: 5 });
    await press('.');
    await page.waitForSelector('.message.error');
    await startMock(port);
    await page.waitForFunction(() => window.studio.connected());
    await idle(page);
    assert.notEqual(list.length, 5);
    assert.equal((await parts()).list.length, 5);
    assert.deepEqual(await hulls(), await kept());
    page.problems = page.problems.filter((text) => !/ERR_CONNECTION_REFUSED|WebSocket connection/.test(text));
    await page.click('.message.error button');
  });

  test('decomposes anew, and the choice of before comes back', async () => {
    const before_ = await parts();
    await decompose(40);
    assert.equal(allGroups((await parts()).list).length, 40);
    assert.ok((await worstMisfit()) < 0.15);
    await press('Control+z');
    await page.waitForFunction((n) => window.studio.parts().groups === n, before_.groups);
    await idle(page);
    assert.deepEqual((await parts()).list, before_.list);
    assert.deepEqual(await hulls(), await kept());
    assert.ok((await worstMisfit()) < 0.15);
  });

  test('fits a small window', async () => {
    await page.setViewportSize({ width: 1024, height: 700 });
    await idle(page);
    const at = await visiblePart();
    await page.mouse.click(at.x, at.y);
    await shot(page, '33_small');
    const wide = await studio(page, () => [...document.querySelectorAll('button, select')].filter((one) => one.offsetParent && one.getBoundingClientRect().right > innerWidth + 0.5).length);
    assert.equal(wide, 0);
  });

  test('nothing went wrong on the way', () => assert.deepEqual(page.problems, []));
});
