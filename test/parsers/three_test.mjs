/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * USD and glTF opened by the loaders of three.js, which comes with the studio's page:
 * for USD, the one parser that is not ours and at hand.
 */

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';

const { NODE_MODULES, PCL_CID_ABSTRACT, SCAN } = process.env;
const three = (path) => import(pathToFileURL(join(NODE_MODULES, 'three', path)));
const { Scene, SRGBColorSpace, Vector3 } = await three('build/three.module.js');
const { USDLoader } = await three('examples/jsm/loaders/USDLoader.js');
const { GLTFLoader } = await three('examples/jsm/loaders/GLTFLoader.js');
globalThis.self = globalThis; // as in a browser

/** A box of points in UTM. */
function writeFarScan(path) {
  const points = [];
  for (let i = 0; i < 1000; ++i)
    points.push(
      [524288 + (i % 10) / 4, 4194304 + (Math.floor(i / 10) % 10) / 3, 100 + Math.floor(i / 100) / 5]
        .map((x) => x.toFixed(4))
        .join(' '),
    );
  writeFileSync(
    path,
    `VERSION .7\nFIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nCOUNT 1 1 1\nWIDTH ${points.length}\n` +
      `HEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS ${points.length}\nDATA ascii\n${points.join('\n')}\n`,
  );
  return path;
}

/** Vertices and triangles of each object of our OBJ, and its color. */
function readOBJ(path) {
  const colors = {};
  let material;
  for (const line of readFileSync(path.replace('.obj', '.mtl'), 'utf8').split('\n')) {
    const [word, ...rest] = line.split(' ');
    if (word === 'newmtl') material = rest[0];
    if (word === 'Kd') colors[material] = rest.map(Number);
  }
  const parts = new Map();
  let part;
  for (const line of readFileSync(path, 'utf8').split('\n')) {
    const [word, ...rest] = line.split(' ');
    if (word === 'o') {
      part = { vertices: [], triangles: 0, color: colors[rest[0]] };
      parts.set(rest[0], part);
    }
    if (word === 'v') part.vertices.push(rest.map(Number));
    if (word === 'f') ++part.triangles;
  }
  return parts;
}

const loaders = {
  usda: (path) => new USDLoader().parse(readFileSync(path, 'utf8'), ''),
  glb: async (path) => {
    const bytes = readFileSync(path);
    const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length);
    return (await new GLTFLoader().parseAsync(buffer, '')).scene;
  },
};

/** What three.js draws: y is up. */
function assertIsMesh(mesh, part) {
  const { position } = mesh.geometry.attributes;
  const corners = mesh.geometry.index?.count ?? position.count;
  assert.equal(corners, 3 * part.triangles);
  const places = new Set();
  for (let i = 0; i < position.count; ++i) {
    const local = [position.getX(i), position.getY(i), position.getZ(i)];
    places.add(local.join());
    const { x, y, z } = new Vector3(...local).applyMatrix4(mesh.matrixWorld);
    const distances = part.vertices.map(([a, b, c]) => Math.hypot(x - a, y - c, z + b));
    assert.ok(Math.min(...distances) < 1e-5, `${mesh.name} has a corner at ${[x, y, z]}`);
  }
  assert.equal(places.size, part.vertices.length);
  const color = mesh.material.color.clone();
  color.getRGB(color, SRGBColorSpace);
  color.toArray().forEach((value, k) => assert.ok(Math.abs(value - part.color[k]) < 1e-3));
}

for (const [extension, load] of Object.entries(loaders))
  test(`two scenes as ${extension}`, async (t) => {
    const folder = mkdtempSync(join(tmpdir(), 'pcl_cid_'));
    t.after(() => rmSync(folder, { recursive: true }));
    const scans = { near: SCAN, far: writeFarScan(join(folder, 'far.pcd')) };
    const together = new Scene();
    const expected = new Map();
    for (const [name, scan] of Object.entries(scans)) {
      const mesh = join(folder, `${name}.obj`);
      const scene = join(folder, `${name}.${extension}`);
      const option = extension === 'glb' ? '--gltf' : '--usd';
      execFileSync(PCL_CID_ABSTRACT, [
        scan, mesh, option, scene, '--name', name,
        '--parts', '6', '--seeds', '60', '--verify', '--quiet',
      ]);
      for (const [part, content] of readOBJ(mesh)) expected.set(part, content);
      together.add(await load(scene));
    }
    together.updateMatrixWorld(true);
    const meshes = [];
    together.traverse((object) => object.isMesh && meshes.push(object));
    assert.ok(expected.size >= 7);
    assert.deepEqual(meshes.map(({ name }) => name).sort(), [...expected.keys()].sort());
    for (const mesh of meshes) assertIsMesh(mesh, expected.get(mesh.name));
  });
