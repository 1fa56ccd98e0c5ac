/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Serves the built page and the protocol for development and tests; no token, one scan in memory.
 */

import { createServer } from 'node:http';
import { readFile } from 'node:fs/promises';
import { extname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';
import { WebSocketServer } from 'ws';
import { Refused } from './refused.mjs';

const DIST = fileURLToPath(new URL('../dist/', import.meta.url));
const TYPES = { '.html': 'text/html; charset=utf-8', '.js': 'text/javascript', '.css': 'text/css', '.svg': 'image/svg+xml' };
const CLASSES = ['wall', 'floor', 'ceiling', 'table', 'chair', 'sofa', 'cabinet', 'picture', 'box', 'monitor', 'window', 'door', 'other furniture'];

function encode(header, arrays = {}) {
  const list = Object.entries(arrays).map(([name, a]) => ({ name, type: a instanceof Float32Array ? 'f32' : 'u32', length: a.length }));
  const text = Buffer.from(JSON.stringify(list.length ? { ...header, arrays: list } : header));
  const head = Buffer.alloc((4 + text.length + 3) & ~3);
  head.writeUInt32LE(text.length);
  text.copy(head, 4);
  return Buffer.concat([head, ...Object.values(arrays).map((a) => Buffer.from(a.buffer, a.byteOffset, a.byteLength))]);
}

function decode(data) {
  const length = data.readUInt32LE(0);
  const header = JSON.parse(data.subarray(4, 4 + length).toString());
  const arrays = {};
  let at = (4 + length + 3) & ~3;
  for (const { name, type, length: n } of header.arrays ?? []) {
    const bytes = Uint8Array.from(data.subarray(at, at + 4 * n)).buffer;
    arrays[name] = type === 'f32' ? new Float32Array(bytes) : new Uint32Array(bytes);
    at += 4 * n;
  }
  return { header, arrays };
}

function describe(world) {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  world.positions.forEach((v, i) => {
    low[i % 3] = Math.min(low[i % 3], v);
    high[i % 3] = Math.max(high[i % 3], v);
  });
  return {
    name: 'meeting_room.pcd', places: world.places, points: world.places, low, high, origin: [0, 0, 0], up: [0, 0, 1],
    has_color: !world.colorless, classes: CLASSES.map((name) => ({ name })), session: 'meeting_room.studio', version: '0.0.0',
    meshes: ['obj', 'stl', 'ply'], scenes: [{ name: 'urdf', help: 'A robot description with one link' }, { name: 'sdf', help: 'A static model for Gazebo' }],
  };
}

/** What takes the server so long that a change may come in between. */
const SLOW = new Set(['hulls', 'tightness']);

function refuse(socket, header, error) {
  socket.send(encode({ id: header.id, ok: false, error }));
}

function guarded(socket, header, work) {
  try {
    work();
  } catch (error) {
    if (!(error instanceof Refused)) console.error(error);
    refuse(socket, header, error.message);
  }
}

/** `delay`: milliseconds before each answer, to see how waiting looks. */
export async function startMock(world, { port = 0, delay = 0 } = {}) {
  const policy = (host) =>
    `default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; connect-src 'self' ws://${host}; worker-src 'self' blob:`;
  const server = createServer(async (request, response) => {
    const path = request.url.split('?')[0];
    const send = (status, type, body) => {
      response.writeHead(status, { 'Content-Type': type, 'Content-Security-Policy': policy(request.headers.host), 'Cache-Control': 'no-store' });
      response.end(body);
    };
    if (path === '/api/scan') return send(200, 'application/json', JSON.stringify(describe(world)));
    if (path === '/api/positions') return send(200, 'application/octet-stream', Buffer.from(world.positions.buffer));
    if (path === '/api/colors' && !world.colorless) return send(200, 'application/octet-stream', Buffer.from(world.colors.buffer));
    const file = join(DIST, normalize(path === '/' ? '/index.html' : path));
    try {
      send(200, TYPES[extname(file)] ?? 'application/octet-stream', await readFile(file));
    } catch {
      send(404, 'text/plain', 'not there');
    }
  });
  const sockets = new WebSocketServer({ server, path: '/api/session' });
  const open = [];
  const tell = (socket, arrays) => socket.send(encode({ event: 'changed', ...world.summary(socket === open[0]) }, arrays));
  sockets.on('connection', (socket) => {
    open.push(socket);
    socket.on('close', () => {
      const wasWriter = socket === open[0];
      open.splice(open.indexOf(socket), 1);
      if (wasWriter && open[0]) tell(open[0], {});
    });
    socket.on('message', (data) => setTimeout(() => receive(socket, data), delay));
  });
  function receive(socket, data) {
    const { header, arrays } = decode(data);
    const reply = (fields, out) => socket.send(encode({ id: header.id, ok: true, ...fields }, out));
    const writer = socket === open[0];
    guarded(socket, header, () => {
      if (header.do && !writer) throw new Refused('Another page is the writer of this session.');
      if (world.parts.knows(header.do)) {
        if (header.do === 'decompose') socket.send(encode({ event: 'progress', id: header.id, share: 0.5 }));
        world.changeParts(header);
        reply(world.partsSummary(true));
        for (const other of open) if (other !== socket) other.send(encode({ event: 'parts', ...world.partsSummary(other === open[0]) }));
      } else if (SLOW.has(header.ask)) {
        // Every other one is on its way for so long, and meets what the parts have become.
        const met = header.id % 2 === 0 ? null : world.revision;
        setTimeout(() => {
          if (met !== null && world.revision !== met) refuse(socket, header, 'cancelled');
          else guarded(socket, header, () => reply(...world.answer(header)));
        }, 25);
      } else if (header.do) {
        const places = world.change(header, arrays);
        const delta = { places, labels: places.map((p) => world.labels[p]), groups: places.map((p) => world.groups[p]) };
        reply(world.summary(true), delta);
        for (const other of open) if (other !== socket) tell(other, delta);
      } else if (header.ask === 'state') {
        reply(world.summary(writer), { labels: world.labels, groups: world.groups });
      } else {
        reply(...world.answer(header));
      }
    });
  }
  await new Promise((done) => server.listen(port, '127.0.0.1', done));
  return {
    port: server.address().port,
    url: `http://127.0.0.1:${server.address().port}/`,
    close: () =>
      new Promise((done) => {
        for (const socket of [...open]) socket.terminate();
        server.closeAllConnections();
        server.close(done);
      }),
  };
}
