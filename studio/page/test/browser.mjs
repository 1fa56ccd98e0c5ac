/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A browser for the tests, and what every test needs: a page without errors, clicks on places, screenshots.
 */

import { mkdirSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { chromium } from 'playwright-core';

const ARGUMENTS = [
  '--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-quic', '--no-first-run',
  '--disable-background-networking', '--disable-component-update', '--disable-sync',
];

export function launch() {
  return chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', headless: true, args: ARGUMENTS });
}

/** A page on the studio that remembers what went wrong in it. */
export async function openStudio(browser, url, { width = 1100, height = 700, context } = {}) {
  const owner = context ?? (await browser.newContext({ viewport: { width, height }, reducedMotion: 'reduce' }));
  const page = await owner.newPage();
  page.setDefaultTimeout(20000);
  page.problems = [];
  page.on('console', (message) => {
    if (message.type() === 'error' || /Content.Security/i.test(message.text())) page.problems.push(message.text());
  });
  page.on('pageerror', (error) => page.problems.push(String(error)));
  await page.goto(url);
  await page.waitForFunction(() => window.studio?.connected());
  await idle(page);
  return page;
}

export const idle = (page) => page.evaluate(() => window.studio.idle());
export async function press(page, ...keys) {
  for (const key of keys) await page.keyboard.press(key);
  await idle(page);
}
export const studio = (page, f, argument) => page.evaluate(f, argument);
export const counts = (page) => page.evaluate(() => window.studio.counts());

/**
 * A place that a click would take, for which `test` (source of a function of a place) holds. Where a place is, a
 * click often takes another one a little before it: that one is as good, if the test holds for it.
 */
export async function placeWhere(page, test = 'true', tries = 6000) {
  return page.evaluate(
    ([source, most]) => {
      const holds = new Function('place', 'studio', `return ${source}`);
      const { places } = window.studio.counts();
      for (let i = 0; i < Math.min(places, most); i++) {
        const place = (i * 7919) % places;
        if (!window.studio.drawn(place) || !holds(place, window.studio)) continue;
        const at = window.studio.project(place);
        const taken = at && window.studio.pickAt(at.x, at.y);
        if (taken !== null && holds(taken, window.studio) && window.studio.visible(taken)) return taken;
      }
      return null;
    },
    [test, tries],
  );
}

export async function clickPlace(page, place, options = {}) {
  const at = await page.evaluate((p) => window.studio.project(p), place);
  for (const key of options.modifiers ?? []) await page.keyboard.down(key);
  await page.mouse.click(at.x, at.y);
  for (const key of options.modifiers ?? []) await page.keyboard.up(key);
  return at;
}

/** Where a click selects a part for which `test` (source of a function of a part) holds, on a point or a hull of it. */
export async function partInView(page, test = 'true') {
  return page.evaluate((source) => {
    const holds = new Function('part', `return ${source}`);
    const { left, top, right, bottom } = document.querySelector('canvas.cloud').getBoundingClientRect();
    for (let y = top + 40; y < bottom; y += 23) {
      for (let x = left + 20; x < right; x += 29) {
        const hit = window.studio.partAt(x, y);
        const part = hit && window.studio.parts().list.find((one) => one.part === hit.part);
        if (part && holds(part)) return { x, y, part: part.part };
      }
    }
    return null;
  }, test);
}

const folder = process.env.STUDIO_SHOTS ?? join(tmpdir(), 'studio_shots');
export async function shot(page, name) {
  mkdirSync(folder, { recursive: true });
  await page.screenshot({ path: `${folder}/${name}.png` });
}
