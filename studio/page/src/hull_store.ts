/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The hulls of the parts and how well they fit, asked for once for each set of groups.
 */

import { Cancelled, Disconnected } from './connection';
import type { Connection } from './connection';
import { Emitter } from './emitter';
import { unpackHulls } from './hull';
import type { Hull } from './hull';
import type { Messages } from './messages';
import type { PartsState } from './parts_state';
import type { HullFacts, Message, Part, Tightness } from './protocol';

interface Entry {
  hull: Hull;
  tightness: Tightness | null;
}

const HULLS_AT_ONCE = 48;
/** Few, because they take long and a change throws away what is not answered yet. */
const TIGHTNESS_AT_ONCE = 4;

/** What a hull depends on. */
const keyOf = (part: Part): string => `${part.groups.join(' ')}${part.exact ? ' exact' : ''}`;

export class HullStore extends Emitter<{ changed: 'hulls' | 'tightness' }> {
  private entries = new Map<string, Entry>();
  private decomposition: number | null = null;
  private running = false;
  /** Hulls are only for who looks at them. */
  private wanted = false;

  constructor(
    private state: PartsState,
    private connection: Connection,
    private messages: Messages,
  ) {
    super();
    state.on('changed', () => {
      if (state.decomposition !== this.decomposition) this.entries.clear();
      this.decomposition = state.decomposition;
      void this.fetch();
    });
  }

  get busy(): boolean {
    return this.running;
  }

  want(wanted: boolean): void {
    this.wanted = wanted;
    void this.fetch();
  }

  hullOf(part: Part): Hull | null {
    return this.entries.get(keyOf(part))?.hull ?? null;
  }

  tightnessOf(part: Part): Tightness | null {
    return this.entries.get(keyOf(part))?.tightness ?? null;
  }

  /** One request at a time, hulls first; the parts of now are looked at before each. */
  private async fetch(): Promise<void> {
    if (this.running) return;
    this.running = true;
    while (this.wanted && (await this.fetchSome())) continue;
    this.running = false;
  }

  /** Whether to go on. */
  private async fetchSome(): Promise<boolean> {
    const hulls = this.state.list.filter((part) => !this.hullOf(part)).slice(0, HULLS_AT_ONCE);
    if (hulls.length > 0) return this.ask('hulls', hulls, (message) => this.takeHulls(hulls, message));
    const unmeasured = this.withoutTightness();
    if (unmeasured.length > 0) return this.ask('tightness', unmeasured, (message) => this.takeTightness(unmeasured, message));
    return false;
  }

  /** Newest first: those are what the person just made. */
  private withoutTightness(): Part[] {
    const byKey = new Map(this.state.list.map((part) => [keyOf(part), part]));
    const newestFirst = [...this.entries].reverse();
    const parts = newestFirst.flatMap(([key, { tightness }]) => (tightness ? [] : (byKey.get(key) ?? [])));
    return parts.slice(0, TIGHTNESS_AT_ONCE);
  }

  private async ask(what: 'hulls' | 'tightness', parts: Part[], take: (message: Message) => number): Promise<boolean> {
    const { told } = this.state;
    try {
      const message = await this.connection.request({ ask: what, parts: parts.map((part) => part.part) });
      // After a change the same numbers may be other parts.
      return told !== this.state.told || take(message) > 0;
    } catch (error) {
      if (error instanceof Cancelled || told !== this.state.told) return this.connection.isOpen;
      if (!(error instanceof Disconnected)) this.messages.error((error as Error).message);
      return false;
    }
  }

  /** How many came. */
  private takeHulls(parts: Part[], { header, arrays }: Message): number {
    const hulls = unpackHulls(header.hulls as HullFacts[], arrays.vertices as Float32Array, arrays.triangles as Uint32Array);
    hulls.forEach((hull, i) => this.entries.set(keyOf(parts[i]), { hull, tightness: null }));
    this.emit('changed', 'hulls');
    return hulls.length;
  }

  private takeTightness(parts: Part[], { header }: Message): number {
    const measured = header.tightness as Tightness[];
    measured.forEach((one, i) => (this.entries.get(keyOf(parts[i]))!.tightness = one));
    this.emit('changed', 'tightness');
    return measured.length;
  }
}
