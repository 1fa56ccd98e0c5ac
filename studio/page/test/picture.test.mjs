/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The page of --html, opened as a file: what is seen, and what buttons, mouse and keys change in it. PICTURE_TOOLS is
 * the folder of the tools, STUDIO_SCAN the scan.
 */

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { launch, shot } from './browser.mjs';
import { difference, drawnShare, shareOfHue } from './pixels.mjs';

const tools = process.env.PICTURE_TOOLS;
const scan = process.env.STUDIO_SCAN;
const folder = mkdtempSync(join(tmpdir(), 'picture-'));
const ODD = '"\'&amp;<img src=x onerror=alert(1)> \u2028 <!--.pcd';
let browser;

const make = (tool, input, html, ...options) =>
  execFileSync(join(tools, tool), [input, join(folder, `out${tool === 'pcl_cid_abstract' ? '.obj' : '.pcd'}`), '--quiet', '--html', join(folder, html), ...options]);

/** A picture that remembers what went wrong in it, and each request but the one for the file. */
async function open(html) {
  const context = await browser.newContext({ viewport: { width: 840, height: 540 }, reducedMotion: 'reduce' });
  const page = await context.newPage();
  const url = pathToFileURL(join(folder, html)).href;
  page.problems = [];
  page.on('console', (message) => ['error', 'warning'].includes(message.type()) && page.problems.push(message.text()));
  page.on('pageerror', (error) => page.problems.push(String(error)));
  page.on('dialog', (dialog) => page.problems.push(dialog.message()) && dialog.dismiss());
  context.on('request', (request) => request.url().split('#')[0] !== url && !request.url().startsWith('data:') && page.problems.push(request.url()));
  await page.goto(url);
  await page.waitForFunction(() => window.picture);
  await idle(page);
  return page;
}

const idle = (page) => page.evaluate(() => window.picture.idle());

/** The canvas alone, without the frame that it has while keys go to it. */
async function look(page) {
  await page.evaluate(() => document.activeElement?.blur());
  await page.mouse.move(780, 20);
  await idle(page);
  return page.locator('canvas.cloud').screenshot();
}

async function setCeiling(page, share) {
  await page.locator('.ceiling-slider input').evaluate((input, value) => {
    input.value = String(value * Number(input.max));
    input.dispatchEvent(new Event('input'));
  }, share);
}

/** Rows come and go: it is taken from those of now. */
const swatchOf = (page, row) =>
  page.evaluate((n) => getComputedStyle(document.querySelectorAll('.marks .swatch')[n]).backgroundColor.match(/\d+/g).map(Number), row);
const colorsOf = (page) => page.getByLabel('What the colors say');
const figure = (page, name) => page.locator('.figures > div', { has: page.locator(`dt:text-is("${name}")`) }).locator('dd').first().innerText();

const pages = [
  { tool: 'pcl_cid_segment', html: 'segment.html', title: 'Groups', marks: '60' },
  { tool: 'pcl_cid_abstract', html: 'abstract.html', title: 'Parts', marks: '20' },
];

describe('a picture', { skip: tools ? false : 'needs the tools' }, () => {
  before(async () => {
    make('pcl_cid_segment', scan, 'segment.html', '--seeds', '60');
    make('pcl_cid_abstract', scan, 'abstract.html', '--parts', '20', '--merging', 'cid');
    make('pcl_cid_segment', scan, 'values.html', '--cid-from', '70000');
    symlinkSync(scan, join(folder, ODD));
    make('pcl_cid_segment', join(folder, ODD), 'odd.html', '--seeds', '5', '--subsample', '2000');
    const points = Array.from({ length: 2500 }, (_, i) => `${(i % 50) / 50} ${Math.floor(i / 50) / 50} 0 200 0 0\n`);
    writeFileSync(join(folder, 'red.pcd'), `FIELDS x y z red green blue\nPOINTS 2500\nDATA ascii\n${points.join('')}`);
    make('pcl_cid_segment', join(folder, 'red.pcd'), 'red.html', '--seeds', '4');
    browser = await launch();
  });

  after(async () => {
    await browser?.close();
    rmSync(folder, { recursive: true });
  });

  for (const { tool, html, title, marks } of pages) {
    describe(`of ${tool}`, () => {
      let page;
      before(async () => (page = await open(html)));
      after(() => page?.context().close());

      test('shows the points in the colors of the list', async () => {
        await shot(page, `picture_${tool}`);
        assert.equal(await page.title(), `room · ${tool}`);
        assert.equal(await page.locator('.marks .context').innerText(), marks);
        assert.equal(await page.locator('.marks h2').innerText(), title);
        const picture = await look(page);
        assert.ok((await drawnShare(browser, picture)) > 0.2);
        const shares = [];
        for (let row = 0; row < 5; row++) shares.push(await shareOfHue(browser, picture, await swatchOf(page, row)));
        // The ceiling is cut away, and hulls lie over points of other parts.
        assert.ok(shares.filter((share) => share > 0.005).length >= 3, shares.join(' '));
      });

      test('tells the figures of the run', async () => {
        assert.equal(await figure(page, 'Points'), '140,000');
        assert.match(await figure(page, 'Coverage'), /cm|m/);
        if (tool === 'pcl_cid_abstract') assert.match(await figure(page, 'Hulls off'), /cm|m/);
        await page.locator('summary', { hasText: 'Settings' }).click();
        assert.equal(await figure(page, 'samples'), '100');
        assert.equal(await page.locator('dt:text-is("threads")').count(), 0);
        await page.locator('summary', { hasText: 'Settings' }).click();
      });

      test('hides what is clicked in the list', async () => {
        const color = await swatchOf(page, 0);
        const start = await look(page);
        await page.locator('.marks [role=option]').first().click();
        const without = await look(page);
        assert.ok((await difference(browser, start, without)) > 0.01);
        assert.ok((await shareOfHue(browser, without, color)) < 0.5 * (await shareOfHue(browser, start, color)));
        await page.getByText('Show all').click();
        assert.equal(await difference(browser, start, await look(page)), 0);
      });

      test('cuts away what is above the slider', async () => {
        const start = await look(page);
        await setCeiling(page, 0.3);
        const low = await look(page);
        await shot(page, `picture_${tool}_cut`);
        assert.ok((await difference(browser, start, low)) > 0.05);
        await setCeiling(page, 0);
        assert.ok((await drawnShare(browser, await look(page))) < 0.02);
        await setCeiling(page, 1);
        const whole = await look(page);
        await page.locator('[data-tool=ceiling]').click();
        assert.ok((await difference(browser, whole, await look(page))) < 0.01);
        await setCeiling(page, 0.9);
      });

      test('has the height as colors, too, with a legend', async () => {
        const start = await look(page);
        assert.ok(await page.locator('.legend').isHidden());
        await colorsOf(page).selectOption('height');
        const height = await look(page);
        assert.ok((await difference(browser, start, height)) > 0.1);
        assert.match(await page.locator('.legend').innerText(), /Height/);
        await shot(page, `picture_${tool}_height`);
        await page.keyboard.press('v');
        assert.equal(await page.evaluate(() => window.picture.mode()), 'label');
        assert.equal(await difference(browser, start, await look(page)), 0);
      });

      test('turns where the mouse drags, and zooms by its wheel', async () => {
        const start = await look(page);
        await page.mouse.move(270, 300);
        await page.mouse.down();
        await page.mouse.move(390, 280, { steps: 3 });
        await page.mouse.up();
        const turned = await look(page);
        await shot(page, `picture_${tool}_turned`);
        assert.ok((await difference(browser, start, turned)) > 0.1);
        await page.mouse.move(270, 300);
        await page.mouse.wheel(0, -900);
        const near = await look(page);
        assert.ok((await difference(browser, turned, near)) > 0.1);
        await page.keyboard.press('h');
        assert.equal(await difference(browser, start, await look(page)), 0);
      });

      test('did nothing wrong, and asked for nothing', () => assert.deepEqual(page.problems, []));
    });
  }

  test('shows and hides hulls and points', async () => {
    const page = await open('abstract.html');
    const both = await look(page);
    await page.locator('[data-tool=hulls]').click();
    const points = await look(page);
    assert.ok((await difference(browser, both, points)) > 0.1);
    await page.locator('[data-tool=points]').click();
    assert.ok((await drawnShare(browser, await look(page))) < 0.001);
    await page.keyboard.press('k');
    const hulls = await look(page);
    await shot(page, 'picture_hulls');
    assert.ok((await drawnShare(browser, hulls)) > 0.2);
    assert.ok((await shareOfHue(browser, hulls, await swatchOf(page, 0))) > 0.004);
    await page.keyboard.press('p');
    assert.equal(await difference(browser, both, await look(page)), 0);
    assert.deepEqual(page.problems, []);
  });

  test('shows the colors of a scan that has any', async () => {
    const page = await open('red.html');
    assert.equal(await colorsOf(page).locator('option').count(), 3);
    assert.ok((await shareOfHue(browser, await look(page), [200, 0, 0])) < 0.001);
    await colorsOf(page).selectOption('rgb');
    await shot(page, 'picture_red');
    assert.ok((await shareOfHue(browser, await look(page), [200, 0, 0])) > 0.05);
    assert.deepEqual(page.problems, []);
  });

  test('turns another axis up', async () => {
    const page = await open('segment.html');
    const start = await look(page);
    await Promise.all([page.waitForEvent('load'), page.locator('select.up').selectOption('-y')]);
    await page.waitForFunction(() => window.picture);
    await shot(page, 'picture_up');
    assert.ok((await difference(browser, start, await look(page))) > 0.2);
    assert.equal(await page.locator('select.up').inputValue(), '-y');
    assert.deepEqual(page.problems, []);
  });

  test('shows measured values', async () => {
    const page = await open('values.html');
    await shot(page, 'picture_values');
    assert.match(await page.locator('.legend').innerText(), /CID from point 70000/);
    assert.ok((await drawnShare(browser, await look(page))) > 0.2);
    assert.equal(await page.locator('.marks').count(), 0);
    assert.deepEqual(page.problems, []);
  });

  test('is not moved by the name of the scan', async () => {
    const page = await open('odd.html');
    assert.equal(await page.locator('.scan-name h1').getAttribute('title'), ODD.replace('.pcd', ''));
    assert.equal(await page.locator('img').count(), 0);
    assert.deepEqual(page.problems, []);
  });

  test('lets nothing in and nothing out', async () => {
    const page = await open('segment.html');
    const went = await page.evaluate(async () => {
      const script = document.createElement('script');
      script.textContent = 'window.came = true';
      document.body.append(script);
      const answer = await fetch('https://example.com/').then(() => 'went', () => 'refused');
      return [answer, window.came ?? false];
    });
    assert.deepEqual(went, ['refused', false]);
    assert.equal(page.problems.filter((text) => text.includes('Content Security Policy')).length, page.problems.length);
  });
});
