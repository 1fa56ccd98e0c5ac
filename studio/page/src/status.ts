/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The line at the lower edge: how far the work is and whether it is safe.
 */

import type { Connection } from './connection';
import { count, el } from './dom';
import type { Modes } from './modes';
import type { PartsState } from './parts_state';
import type { ScanInfo } from './protocol';
import type { Session } from './session';

export class StatusBar {
  readonly element = el('footer', { class: 'status', 'aria-label': 'Status' });
  private items = new Map<string, HTMLElement>();
  private bar = el('span', { class: 'progress-fill' });
  private progress = el('span', { class: 'progress', hidden: true }, this.bar);

  constructor(
    private info: ScanInfo,
    private session: Session,
    private connection: Connection,
    private parts: PartsState,
    private modes: Modes,
  ) {
    for (const name of ['connection', 'saved', 'questions', 'unlabeled', 'steps']) this.item(name);
    this.element.append(this.progress, el('span', { class: 'fill' }));
    for (const name of ['here', 'points']) this.item(name);
    session.on('changed', () => this.refresh());
    parts.on('changed', () => this.refresh());
    modes.on('changed', () => this.refresh());
    connection.on('connected', () => this.refresh());
    connection.on('disconnected', () => this.refresh());
    connection.on('progress', (share) => this.showProgress(share));
    this.set('points', `${count(info.places)} points`);
    this.refresh();
  }

  private item(name: string): void {
    const item = el('span', { class: `item ${name}` });
    this.items.set(name, item);
    this.element.append(item);
  }

  private set(name: string, text: string): void {
    this.items.get(name)!.textContent = text;
  }

  /** What is under the cursor. */
  here(text: string): void {
    this.set('here', text);
  }

  loading(share: number | null): void {
    this.set('points', share === null ? `${count(this.info.places)} points` : `Loading points: ${Math.floor(100 * share)} %`);
    this.showProgress(share);
  }

  private showProgress(share: number | null): void {
    this.progress.hidden = share === null;
    this.bar.style.width = `${100 * (share ?? 0)}%`;
  }

  private refresh(): void {
    const { session, info, connection } = this;
    const state = !connection.isOpen ? 'off' : !session.ready ? 'wait' : session.writer ? 'on' : 'looks';
    this.items.get('connection')!.dataset.state = state;
    this.set('connection', { off: 'Not connected', wait: 'Connecting', on: 'Connected', looks: 'Looking on' }[state]);
    this.set('saved', session.ready ? `Change ${count(session.revision)} is on disk` : '');
    this.items.get('saved')!.title = `Session: ${info.session}`;
    if (this.modes.isParts) this.tellParts();
    else this.tellLabels();
  }

  private tellParts(): void {
    const { groups, list, undo, redo } = this.parts;
    const dropped = list.filter((part) => part.dropped).length;
    this.set('questions', groups === 0 ? 'No parts yet' : `${count(list.length)} parts of ${count(groups)} groups`);
    this.set('unlabeled', dropped === 0 ? '' : `${count(dropped)} dropped`);
    this.setSteps(undo, redo);
  }

  private tellLabels(): void {
    const { session, info } = this;
    const left = session.questions;
    this.set('questions', left === 0 ? 'No question left' : `${count(left)} question${left === 1 ? '' : 's'} left`);
    const share = info.places ? (100 * session.unlabeled) / info.places : 0;
    const rounded = share > 0 && share < 0.1 ? '< 0.1' : share.toFixed(1);
    this.set('unlabeled', `${rounded} % without label`);
    this.setSteps(session.undo, session.redo);
  }

  private setSteps(undo: number, redo: number): void {
    this.set('steps', `${count(undo)} to undo · ${count(redo)} to redo`);
  }
}
