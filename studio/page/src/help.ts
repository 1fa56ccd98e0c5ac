/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * All keys, made from the table that binds them.
 */

import { ICONS, el, icon, key } from './dom';
import type { Keys } from './keys';

const SIGNS: Record<string, string> = { ArrowLeft: '←', ArrowRight: '→', ArrowUp: '↑', ArrowDown: '↓' };

export class Help {
  private dialog = el('dialog', { class: 'help', 'aria-label': 'Keys' });

  constructor(
    parent: HTMLElement,
    private keys: Keys,
  ) {
    parent.append(this.dialog);
    this.dialog.addEventListener('click', (event) => {
      if (event.target === this.dialog) this.dialog.close();
    });
    this.dialog.addEventListener('keydown', (event) => {
      if (event.key === '?' || event.key === 'F1') {
        event.preventDefault();
        this.dialog.close();
      }
    });
  }

  toggle(): void {
    if (this.dialog.open) {
      this.dialog.close();
      return;
    }
    this.fill();
    this.dialog.showModal();
  }

  private fill(): void {
    const groups = new Map<string, HTMLElement>();
    for (const binding of this.keys.bindings) {
      let group = groups.get(binding.group);
      if (!group) {
        group = el('dl', {});
        groups.set(binding.group, group);
      }
      const caps = el('dt', {});
      const names = binding.shown ? [binding.shown] : binding.keys;
      names.forEach((name, i) => {
        if (i > 0) caps.append(' ');
        caps.append(key(name.replace(/Arrow\w+/g, (arrow) => SIGNS[arrow] ?? arrow)));
      });
      group.append(el('div', {}, caps, el('dd', { text: binding.text })));
    }
    const columns = el('div', { class: 'columns' });
    for (const [name, list] of groups) columns.append(el('section', {}, el('h3', { text: name }), list));
    this.dialog.replaceChildren(
      el(
        'header',
        {},
        el('h2', { text: 'Keys and mouse' }),
        el('button', { class: 'quiet', 'aria-label': 'Close', click: () => this.dialog.close() }, icon(ICONS.close)),
      ),
      columns,
    );
  }
}
