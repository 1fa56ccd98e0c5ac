/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The pictures of doc/pcl_cid_studio.md, from the real program in Chromium:
 *
 *   (cd studio/page && npm ci)
 *   STUDIO_PROGRAM=build/release/bin/pcl_cid_studio node scripts/studio_pictures.mjs doc/images
 *
 * One session has just begun, another one has the true labels of the sample scan.
 */

import { fileURLToPath } from 'node:url';
import { idle, launch, openStudio, partInView, placeWhere } from '../studio/page/test/browser.mjs';
import { copyOf, startProgram } from '../studio/page/test/program.mjs';

const folder = process.argv[2] ?? 'doc/images';
const sample = fileURLToPath(new URL('../data/room.pcd', import.meta.url));
const browser = await launch();

async function withSession(options, work) {
  const copy = copyOf(sample);
  const program = await startProgram(process.env.STUDIO_PROGRAM, copy.scan, ['--classes', 's3dis', ...options]);
  const page = await openStudio(browser, program.url, { width: 1280, height: 800 });
  const press = async (...keys) => {
    for (const key of keys) await page.keyboard.press(key);
    await idle(page);
  };
  const shot = async (name) => {
    await page.waitForTimeout(4000); // notes are gone, flights are over
    await page.screenshot({ path: `${folder}/studio_${name}.jpg`, type: 'jpeg', quality: 68 });
  };
  await work({ page, press, shot });
  await program.end('SIGINT');
  copy.remove();
}

const at = (page, place) => page.evaluate((p) => window.studio.project(p), place);

await withSession([], async ({ press, shot }) => {
  await press('Space');
  await shot('question');
});

await withSession(['--import', 'label', '--seeds', '150'], async ({ page, press, shot }) => {
  await press('b');
  await shot('instances');
  const table = await placeWhere(page, "studio.instances().find((one) => one.label === studio.labelOf(place))?.class === 'table'");
  const { x, y } = await at(page, table);
  await page.mouse.move(x, y);
  await page.evaluate(() => document.querySelector('canvas.cloud').focus());
  while ((await page.evaluate(() => window.studio.mode())) !== 'cid') await press('v');
  await page.mouse.move(x + 1, y);
  await shot('cid');
  while ((await page.evaluate(() => window.studio.mode())) !== 'doubt') await press('v');
  await shot('doubt');
  await press('b', 'l');
  await page.mouse.move(x - 45, y - 30);
  await page.mouse.down();
  for (const [dx, dy] of [[45, -35], [55, 25], [-30, 40], [-45, -30]]) await page.mouse.move(x + dx, y + dy, { steps: 8 });
  await page.mouse.up();
  await idle(page);
  await shot('lasso');
});

await withSession([], async ({ page, press, shot }) => {
  await press('g');
  await page.focus('.groups-row input');
  await press('Enter');
  await page.waitForFunction(() => window.studio.parts().groups > 0, null, { timeout: 300_000 });
  await idle(page);
  await shot('parts');
  const { x, y } = await partInView(page);
  await page.mouse.click(x, y);
  await press('p');
  await shot('hulls');
});

await browser.close();
