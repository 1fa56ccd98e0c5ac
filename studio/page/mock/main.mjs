/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * npm run mock [-- --places N --port N --delay ms --colorless]
 */

import { parseArgs } from 'node:util';
import { startMock } from './server.mjs';
import { World } from './world.mjs';

const { values } = parseArgs({
  options: {
    places: { type: 'string', default: '60000' },
    questions: { type: 'string', default: '24' },
    port: { type: 'string', default: '8123' },
    delay: { type: 'string', default: '0' },
    colorless: { type: 'boolean', default: false },
  },
});
const world = new World({ places: Number(values.places), questions: Number(values.questions) });
world.colorless = values.colorless;
const mock = await startMock(world, { port: Number(values.port), delay: Number(values.delay) });
console.log(mock.url);
