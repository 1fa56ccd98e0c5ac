/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Clouds for the tests: made, written as PCD or PLY, and read back. It shares nothing
 * with the program.
 */

import { readFileSync, writeFileSync } from 'node:fs';
import { randomNumbers } from '../../studio/page/mock/room.mjs';

export { randomNumbers };

/** A floor, two walls and four boxes: {x, y, z}, each an array. */
export function smallRoom(points, seed = 1) {
  const random = randomNumbers(seed);
  const sides = [
    [
      [0, 0, 0],
      [4, 0, 0],
      [0, 3, 0],
    ],
    [
      [0, 0, 0],
      [4, 0, 0],
      [0, 0, 2.5],
    ],
    [
      [0, 0, 0],
      [0, 3, 0],
      [0, 0, 2.5],
    ],
  ];
  for (const [x, y, w, d, h] of [
    [0.6, 0.5, 0.8, 0.6, 0.7],
    [2.2, 0.4, 0.5, 0.5, 1.2],
    [1.0, 1.8, 0.6, 0.7, 0.5],
    [2.7, 1.9, 0.7, 0.6, 0.9],
  ]) {
    sides.push([
      [x, y, h],
      [w, 0, 0],
      [0, d, 0],
    ]);
    sides.push(
      [
        [x, y, 0],
        [w, 0, 0],
        [0, 0, h],
      ],
      [
        [x, y + d, 0],
        [w, 0, 0],
        [0, 0, h],
      ],
    );
    sides.push(
      [
        [x, y, 0],
        [0, d, 0],
        [0, 0, h],
      ],
      [
        [x + w, y, 0],
        [0, d, 0],
        [0, 0, h],
      ],
    );
  }
  const length = (edge) => Math.hypot(...edge);
  const areas = sides.map(([, u, v]) => length(u) * length(v));
  const total = areas.reduce((sum, area) => sum + area);
  const cloud = { x: [], y: [], z: [] };
  for (let i = 0; i < points; ++i) {
    let rest = random() * total;
    let k = 0;
    while (k + 1 < sides.length && rest > areas[k]) rest -= areas[k++];
    const [corner, u, v] = sides[k];
    const [a, b] = [random(), random()];
    ['x', 'y', 'z'].forEach((axis, j) => {
      const noise = 0.004 * (random() + random() - 1);
      cloud[axis].push(Math.fround(corner[j] + a * u[j] + b * v[j] + noise));
    });
  }
  return cloud;
}

const writers = {
  F4: (view, at, v) => view.setFloat32(at, v, true),
  F8: (view, at, v) => view.setFloat64(at, v, true),
  U1: (view, at, v) => view.setUint8(at, v),
  U2: (view, at, v) => view.setUint16(at, v, true),
  U4: (view, at, v) => view.setUint32(at, v, true),
  I1: (view, at, v) => view.setInt8(at, v),
  I2: (view, at, v) => view.setInt16(at, v, true),
  I4: (view, at, v) => view.setInt32(at, v, true),
};
const readers = {
  F4: (view, at) => view.getFloat32(at, true),
  F8: (view, at) => view.getFloat64(at, true),
  U1: (view, at) => view.getUint8(at),
  U2: (view, at) => view.getUint16(at, true),
  U4: (view, at) => view.getUint32(at, true),
  I1: (view, at) => view.getInt8(at),
  I2: (view, at) => view.getInt16(at, true),
  I4: (view, at) => view.getInt32(at, true),
};
const sizeOf = (type) => Number(type[1]);

/** Fields as {name: [type, values]}, types as F4, U1, I2; ascii or binary. */
export function writePcd(path, fields, { data = 'binary', width, height = 1 } = {}) {
  const names = Object.keys(fields);
  const types = names.map((name) => fields[name][0]);
  const count = fields[names[0]][1].length;
  const header =
    `# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS ${names.join(' ')}\n` +
    `SIZE ${types.map(sizeOf).join(' ')}\nTYPE ${types.map((t) => t[0]).join(' ')}\n` +
    `COUNT ${names.map(() => 1).join(' ')}\nWIDTH ${width ?? count}\nHEIGHT ${height}\n` +
    `VIEWPOINT 0 0 0 1 0 0 0\nPOINTS ${count}\nDATA ${data}\n`;
  if (data === 'ascii') {
    const text = (v) => (Number.isNaN(v) ? 'nan' : String(v));
    let lines = '';
    for (let i = 0; i < count; ++i)
      lines += `${names.map((name) => text(fields[name][1][i])).join(' ')}\n`;
    writeFileSync(path, header + lines);
    return;
  }
  const step = types.reduce((sum, type) => sum + sizeOf(type), 0);
  const bytes = Buffer.alloc(step * count);
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  for (let i = 0, at = 0; i < count; ++i)
    names.forEach((name, k) => {
      writers[types[k]](view, at, fields[name][1][i]);
      at += sizeOf(types[k]);
    });
  writeFileSync(path, Buffer.concat([Buffer.from(header), bytes]));
}

/** Positions alone, float32. */
export function writePositions(path, { x, y, z }, options) {
  writePcd(path, { x: ['F4', x], y: ['F4', y], z: ['F4', z] }, options);
}

/** LZF as PCL writes it. */
function decompressed(bytes, size) {
  const out = Buffer.alloc(size);
  let to = 0;
  for (let at = 0; at < bytes.length;) {
    const control = bytes[at++];
    if (control < 32) {
      bytes.copy(out, to, at, at + control + 1);
      at += control + 1;
      to += control + 1;
      continue;
    }
    let length = control >> 5;
    if (length === 7) length += bytes[at++];
    let from = to - ((control & 31) << 8) - bytes[at++] - 1;
    for (let k = 0; k < length + 2; ++k) out[to++] = out[from++];
  }
  return out;
}

/** A number of a text, as its type can hold it. */
function numberOf(word, type) {
  if (/nan/i.test(word)) return NaN;
  return type === 'F4' ? Math.fround(Number(word)) : Number(word);
}

/** {fields: {name: [type, values]}, width, height, data} */
export function readPcd(path) {
  const bytes = readFileSync(path);
  const header = {};
  let at = 0;
  while (!header.DATA) {
    const end = bytes.indexOf(10, at);
    const [word, ...rest] = bytes.toString('latin1', at, end).trim().split(/\s+/);
    header[word] = rest;
    at = end + 1;
  }
  const names = header.FIELDS;
  const types = names.map((_, k) => header.TYPE[k] + header.SIZE[k]);
  if (header.COUNT.some((count) => count !== '1'))
    throw new Error('a field has several values');
  const count = Number(header.POINTS[0]);
  const [width, height] = [Number(header.WIDTH[0]), Number(header.HEIGHT[0])];
  const data = header.DATA[0];
  const fields = Object.fromEntries(names.map((name, k) => [name, [types[k], []]]));
  if (data === 'ascii') {
    const lines = bytes.toString('latin1', at).trimEnd().split('\n');
    if (lines.length !== count)
      throw new Error(`${lines.length} lines, ${count} points`);
    for (const line of lines)
      line
        .trim()
        .split(/\s+/)
        .forEach((word, k) => {
          fields[names[k]][1].push(numberOf(word, types[k]));
        });
    return { fields, width, height, data };
  }
  const isPacked = data === 'binary_compressed';
  const body = isPacked
    ? decompressed(
        bytes.subarray(at + 8, at + 8 + bytes.readUInt32LE(at)),
        bytes.readUInt32LE(at + 4),
      )
    : bytes.subarray(at);
  const view = new DataView(body.buffer, body.byteOffset, body.length);
  const step = types.reduce((sum, type) => sum + sizeOf(type), 0);
  let offset = 0;
  names.forEach((name, k) => {
    const size = sizeOf(types[k]);
    for (let i = 0; i < count; ++i)
      fields[name][1].push(
        readers[types[k]](
          view,
          isPacked ? offset * count + i * size : i * step + offset,
        ),
      );
    offset += size;
  });
  return { fields, width, height, data };
}

const plyTypes = {
  char: 'I1',
  int8: 'I1',
  uchar: 'U1',
  uint8: 'U1',
  short: 'I2',
  int16: 'I2',
  ushort: 'U2',
  uint16: 'U2',
  int: 'I4',
  int32: 'I4',
  uint: 'U4',
  uint32: 'U4',
  float: 'F4',
  float32: 'F4',
  double: 'F8',
  float64: 'F8',
};

/** Of a PLY whose first element is the points: {fields, format} */
export function readPly(path) {
  const bytes = readFileSync(path);
  const end = bytes.indexOf('end_header\n') + 'end_header\n'.length;
  const header = bytes
    .toString('latin1', 0, end)
    .split('\n')
    .map((line) => line.trim().split(/\s+/));
  const format = header.find(([word]) => word === 'format')[1];
  const first = header.findIndex(([word]) => word === 'element');
  const count = Number(header[first][2]);
  const properties = [];
  for (let k = first + 1; header[k][0] === 'property'; ++k)
    properties.push([header[k][2], plyTypes[header[k][1]]]);
  const fields = Object.fromEntries(
    properties.map(([name, type]) => [name, [type, []]]),
  );
  if (format === 'ascii') {
    const lines = bytes.toString('latin1', end).split('\n').slice(0, count);
    for (const line of lines)
      line
        .trim()
        .split(/\s+/)
        .forEach((word, k) => {
          fields[properties[k][0]][1].push(numberOf(word, properties[k][1]));
        });
    return { fields, format };
  }
  if (format !== 'binary_little_endian') throw new Error(`format ${format}`);
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  for (let i = 0, at = end; i < count; ++i)
    for (const [name, type] of properties) {
      fields[name][1].push(readers[type](view, at));
      at += sizeOf(type);
    }
  return { fields, format };
}

/** Fields as {name: [type, values]}; ascii. */
export function writePly(path, fields) {
  const names = Object.keys(fields);
  const word = (type) =>
    Object.keys(plyTypes).find((each) => plyTypes[each] === type && !/\d/.test(each));
  const count = fields[names[0]][1].length;
  let text = `ply\nformat ascii 1.0\nelement vertex ${count}\n`;
  for (const name of names) text += `property ${word(fields[name][0])} ${name}\n`;
  text += 'end_header\n';
  for (let i = 0; i < count; ++i)
    text += `${names.map((name) => fields[name][1][i]).join(' ')}\n`;
  writeFileSync(path, text);
}
