/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Starts pcl_cid_studio and talks to it as a page does (doc/studio_protocol.md).
 */

import { spawn } from 'node:child_process';
import { copyFileSync, existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { request } from 'node:http';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const ROOT = fileURLToPath(new URL('../../', import.meta.url));
const MODULES =
  process.env.STUDIO_NODE_MODULES ?? join(ROOT, 'studio/page/node_modules');
const PROGRAM =
  process.env.STUDIO_PROGRAM ?? join(ROOT, 'build/dev/bin/pcl_cid_studio');
/** Where the other programs are. */
export const TOOLS = dirname(PROGRAM);
const WebSocket = createRequire(join(MODULES, 'here.js'))('ws');

export const NO_GROUP = 0xffffffff;

/** A busy machine may take long; what takes longer than this hangs. */
const PATIENCE = Number(process.env.STUDIO_TEST_PATIENCE ?? 60000);

export function within(promise, what, milliseconds = PATIENCE) {
  let timer;
  const late = new Promise((_, reject) => {
    timer = setTimeout(
      () => reject(new Error(`waited too long for ${what}`)),
      milliseconds,
    );
  });
  return Promise.race([promise, late]).finally(() => clearTimeout(timer));
}

/** Until something is so; for what is not told. */
export async function until(isSo, what) {
  for (const end = Date.now() + PATIENCE; Date.now() < end;) {
    const found = await isSo();
    if (found) return found;
    await new Promise((resolve) => setTimeout(resolve, 10));
  }
  throw new Error(`waited too long for ${what}`);
}

/** A folder that goes with the test. */
export function temporaryFolder(test) {
  const folder = mkdtempSync(join(tmpdir(), 'pcl_cid_studio_'));
  test.after(() => rmSync(folder, { recursive: true, force: true }));
  return folder;
}

/** A copy of the sample scan in a folder of its own. */
export function sampleScan(test) {
  const scan = join(temporaryFolder(test), 'room.pcd');
  copyFileSync(join(ROOT, 'data/room.pcd'), scan);
  return scan;
}

export function truthOfSample() {
  return JSON.parse(readFileSync(join(ROOT, 'data/room_truth.json'), 'utf8'));
}

/** The program, running or ended. */
export class Program {
  #child;
  stdout = '';
  stderr = '';

  constructor(args, { env = {}, isUnprivileged = false, browser = false } = {}) {
    if (!existsSync(PROGRAM))
      throw new Error(`${PROGRAM} is not there; set STUDIO_PROGRAM to the program`);
    const options = browser ? args : ['--no-browser', ...args];
    const nobody = { uid: 65534, gid: 65534 };
    this.#child = spawn(PROGRAM, options, {
      env: { ...process.env, ...env },
      stdio: ['ignore', 'pipe', 'pipe'],
      ...(isUnprivileged && process.getuid() === 0 ? nobody : {}),
    });
    this.#child.stdout.on('data', (bytes) => (this.stdout += bytes));
    this.#child.stderr.on('data', (bytes) => (this.stderr += bytes));
    /** {code, signal} */
    this.ended = new Promise((resolve, reject) => {
      this.#child.on('error', reject);
      this.#child.on('close', (code, signal) => resolve({ code, signal }));
    });
    this.ended.catch(() => {});
    this.opened = new Promise((resolve, reject) => {
      this.#child.stdout.on('data', () => {
        const found = /^Open (http:\S+)\r?\n/m.exec(this.stdout);
        if (found) resolve((this.url = new URL(found[1])));
      });
      this.ended.then(
        ({ code, signal }) =>
          reject(
            new Error(`ended with ${code ?? signal} and no address: ${this.stderr}`),
          ),
        reject,
      );
    });
    this.opened.catch(() => {});
  }

  get port() {
    return Number(this.url.port);
  }

  get origin() {
    return this.url.origin;
  }

  get pid() {
    return this.#child.pid;
  }

  kill(signal = 'SIGKILL') {
    this.#child.kill(signal);
    return within(this.ended, 'the end of the program');
  }

  /** As with Ctrl-C. */
  interrupt() {
    return this.kill('SIGINT');
  }

  /** {status, headers, body}; with the cookie, once there is one. */
  get(path, headers = {}) {
    const all = this.cookie ? { cookie: this.cookie, ...headers } : headers;
    const answered = new Promise((resolve, reject) => {
      const options = { host: '127.0.0.1', port: this.port, path, agent: false };
      const asked = request({ ...options, headers: all }, (response) => {
        const pieces = [];
        response.on('data', (piece) => pieces.push(piece));
        response.on('error', reject);
        response.on('end', () => {
          const { statusCode: status, headers } = response;
          resolve({ status, headers, body: Buffer.concat(pieces) });
        });
      });
      asked.on('error', reject);
      asked.end();
    });
    return within(answered, `the answer to GET ${path}`);
  }

  /** Give the token away for the cookie. */
  async enter() {
    await within(this.opened, 'the address of the program');
    const { status, headers } = await this.get(this.url.pathname + this.url.search);
    if (status !== 303) throw new Error(`the token is answered with ${status}`);
    this.cookie = headers['set-cookie'][0].split(';')[0];
  }

  async scan() {
    return JSON.parse((await this.get('/api/scan')).body.toString());
  }

  async positions() {
    const { body } = await this.get('/api/positions');
    return new Float32Array(
      body.buffer.slice(body.byteOffset, body.byteOffset + body.length),
    );
  }

  /** A page's socket. */
  async connect() {
    if (!this.cookie) await this.enter();
    const page = new Page(this);
    await within(page.opened, 'a socket');
    return page;
  }
}

/** Start, and kill when the test is over. */
export async function start(test, args, options) {
  const program = new Program(args, options);
  test.after(() => program.kill());
  await program.enter();
  return program;
}

/** A run that is to end by itself. */
export async function runToEnd(test, args, options) {
  const program = new Program(args, options);
  test.after(() => program.kill());
  // What is wrong with a session may be found when the address is printed already.
  const soon = program.opened.then(
    () => within(program.ended, 'the end of the program, which is open', PATIENCE / 4),
    () => program.ended,
  );
  const { code, signal } = await within(soon, 'the end of the program');
  return { code, signal, stdout: program.stdout, stderr: program.stderr };
}

export function encode(header, arrays = {}) {
  const list = Object.entries(arrays).map(([name, array]) => ({
    name,
    type: array instanceof Float32Array ? 'f32' : 'u32',
    length: array.length,
  }));
  const text = Buffer.from(
    JSON.stringify(list.length ? { ...header, arrays: list } : header),
  );
  const head = Buffer.alloc(4 + Math.ceil(text.length / 4) * 4);
  head.writeUInt32LE(text.length);
  text.copy(head, 4);
  const rest = Object.values(arrays).map((array) =>
    Buffer.from(array.buffer, array.byteOffset, array.byteLength),
  );
  return Buffer.concat([head, ...rest]);
}

/** {header, arrays}; throws where a frame is not as the protocol says. */
export function decode(bytes) {
  const length = bytes.readUInt32LE(0);
  const header = JSON.parse(bytes.toString('utf8', 4, 4 + length));
  let offset = 4 + Math.ceil(length / 4) * 4;
  if (bytes.subarray(4 + length, offset).some((byte) => byte !== 0))
    throw new Error('the padding of a frame is not 0');
  const arrays = {};
  for (const { name, type, length: count } of header.arrays ?? []) {
    const own = bytes.buffer.slice(
      bytes.byteOffset + offset,
      bytes.byteOffset + offset + 4 * count,
    );
    if (own.byteLength !== 4 * count) throw new Error('a frame is too short');
    arrays[name] = type === 'f32' ? new Float32Array(own) : new Uint32Array(own);
    offset += 4 * count;
  }
  if (offset !== bytes.length) throw new Error('a frame is too long');
  return { header, arrays };
}

/** What the server refused. */
export class Refused extends Error {}

/** A socket, with a promise for each message and a list of what came unasked. */
export class Page {
  #socket;
  #nextId = 1;
  #waiting = new Map();
  #watchers = [];
  /** How many answers there were to each id. */
  answers = new Map();
  /** {header, arrays} of what has no id of ours. */
  events = [];
  /** Bytes of the last answer. */
  lastBytes = 0;

  constructor(program, { headers = {} } = {}) {
    this.#socket = new WebSocket(`ws://127.0.0.1:${program.port}/api/session`, {
      headers: { cookie: program.cookie, origin: program.origin, ...headers },
      perMessageDeflate: false,
      maxPayload: 0,
    });
    this.opened = new Promise((resolve, reject) => {
      this.#socket.on('open', resolve);
      this.#socket.on('error', reject);
    });
    this.opened.catch(() => {});
    /** {code, reason} */
    this.closed = new Promise((resolve) => {
      this.#socket.on('close', (code, reason) => {
        resolve({ code, reason: reason.toString() });
        for (const { reject } of this.#waiting.values())
          reject(new Error(`the socket was closed (${code})`));
        this.#waiting.clear();
      });
    });
    this.#socket.on('message', (bytes, isBinary) => this.#take(bytes, isBinary));
  }

  #take(bytes, isBinary) {
    if (!isBinary) throw new Error('the server sent text');
    const frame = decode(bytes);
    const { header } = frame;
    if (header.event !== undefined || header.id === null) {
      this.events.push(frame);
      for (const watcher of [...this.#watchers]) watcher(frame);
      return;
    }
    this.answers.set(header.id, (this.answers.get(header.id) ?? 0) + 1);
    this.lastBytes = bytes.length;
    const waiting = this.#waiting.get(header.id);
    if (!waiting) return;
    this.#waiting.delete(header.id);
    if (header.ok) waiting.resolve({ ...header, arrays: frame.arrays });
    else waiting.reject(new Refused(header.error));
  }

  /** The answer with its arrays; throws Refused. */
  say(header, arrays = {}) {
    const id = this.#nextId++;
    const answered = new Promise((resolve, reject) => {
      this.#waiting.set(id, { resolve, reject });
    });
    this.#socket.send(encode({ ...header, id }, arrays));
    const safe = within(
      answered,
      `the answer to ${JSON.stringify(header).slice(0, 200)}`,
    );
    safe.catch(() => {});
    return safe;
  }

  /** Bytes as they are. */
  sendRaw(bytes) {
    this.#socket.send(bytes);
  }

  do(word, fields = {}, arrays = {}) {
    return this.say({ do: word, ...fields }, arrays);
  }

  ask(word, fields = {}) {
    return this.say({ ask: word, ...fields });
  }

  /** The first event, past or to come, that is as asked for. */
  event(isIt, what = 'an event') {
    const found = this.events.find(isIt);
    if (found) return Promise.resolve(found);
    const coming = new Promise((resolve) => {
      const watcher = (frame) => {
        if (!isIt(frame)) return;
        this.#watchers.splice(this.#watchers.indexOf(watcher), 1);
        resolve(frame);
      };
      this.#watchers.push(watcher);
    });
    return within(coming, what);
  }

  close() {
    this.#socket.close();
    return within(this.closed, 'the end of a socket');
  }

  /** Without a good-bye, as when a browser crashes. */
  break() {
    this.#socket.terminate();
  }
}

/** A replica of a session: from a state, and then from deltas alone. */
export class Replica {
  constructor(state) {
    const { arrays, ...header } = state;
    this.labels = arrays.labels.slice();
    this.groups = arrays.groups.slice();
    this.#takeSummary(header);
  }

  #takeSummary({ revision, seeds, instances, undo, redo, unlabeled }) {
    this.summary = { revision, seeds, instances, undo, redo, unlabeled };
  }

  /** Of an answer to a change, or an event.
   *  @return what was not told truly: places that come twice or have not changed */
  apply({ arrays, ...header }) {
    const { places, labels, groups } = arrays;
    const faults = [];
    const seen = new Set();
    if (labels.length !== places.length || groups.length !== places.length)
      faults.push('the arrays of a delta are not equally long');
    places.forEach((place, i) => {
      if (place >= this.labels.length) faults.push(`there is no place ${place}`);
      if (seen.has(place)) faults.push(`place ${place} comes twice`);
      seen.add(place);
      if (this.labels[place] === labels[i] && this.groups[place] === groups[i])
        faults.push(`place ${place} has not changed`);
      this.labels[place] = labels[i];
      this.groups[place] = groups[i];
    });
    this.#takeSummary(header);
    return faults.slice(0, 5);
  }

  /** What is compared: plain data. */
  get content() {
    return { labels: this.labels, groups: this.groups, ...this.summary };
  }
}
