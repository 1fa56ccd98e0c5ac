/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Sentences for the person: errors that stay until read, short notes, and banners.
 */

import { ICONS, el, icon } from './dom';

const NOTE_TIME = 4500;

export class Messages {
  private list = el('div', { class: 'messages' });
  private live = el('div', { class: 'unseen', role: 'status', 'aria-live': 'polite' });
  private banners = new Map<string, HTMLElement>();
  private bannerBox = el('div', { class: 'banners' });

  constructor(parent: HTMLElement) {
    parent.append(this.bannerBox, this.list, this.live);
  }

  /** What went wrong; stays until it is dismissed. */
  error(sentence: string): void {
    for (const other of this.list.children) if (other.firstChild?.textContent === sentence) other.remove();
    const box = el('div', { class: 'message error', role: 'alert' }, el('span', { text: sentence }));
    box.append(el('button', { class: 'quiet', 'aria-label': 'Dismiss', click: () => box.remove() }, icon(ICONS.close)));
    this.list.append(box);
    while (this.list.children.length > 4) this.list.firstChild!.remove();
  }

  /** A short note that goes by itself. */
  note(sentence: string): void {
    for (const other of this.list.querySelectorAll('.note')) other.remove();
    const box = el('div', { class: 'message note' }, el('span', { text: sentence }));
    this.list.append(box);
    this.say(sentence);
    window.setTimeout(() => box.remove(), NOTE_TIME);
  }

  /** For screen readers only. */
  say(sentence: string): void {
    this.live.textContent = sentence;
  }

  banner(name: string, sentence: string | null): void {
    this.banners.get(name)?.remove();
    this.banners.delete(name);
    if (sentence === null) return;
    const box = el('div', { class: `banner ${name}`, role: 'status', text: sentence });
    this.banners.set(name, box);
    this.bannerBox.append(box);
  }
}
