/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What a page asks of the server over its socket: how often, and how much of it at once.
 */

function headerOf(payload) {
  const bytes = Buffer.from(payload);
  return JSON.parse(bytes.subarray(4, 4 + bytes.readUInt32LE(0)).toString());
}

/** Counts from the next load of the page on. */
export function watchRequests(page) {
  const names = new Map();
  const open = new Set();
  const total = new Map();
  const most = new Map();
  page.on('websocket', (socket) => {
    socket.on('framesent', ({ payload }) => {
      const header = headerOf(payload);
      const name = header.do ?? header.ask;
      names.set(header.id, name);
      open.add(header.id);
      total.set(name, (total.get(name) ?? 0) + 1);
      const now = [...open].filter((id) => names.get(id) === name).length;
      most.set(name, Math.max(most.get(name) ?? 0, now));
    });
    socket.on('framereceived', ({ payload }) => open.delete(headerOf(payload).id));
  });
  return { sent: (name) => total.get(name) ?? 0, mostAtOnce: (name) => most.get(name) ?? 0 };
}
