/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The line of buttons at the upper edge.
 */

import { ICONS, el, icon, key } from './dom';
import type { WorkMode } from './modes';

export interface Tool {
  name: string;
  text: string;
  title: string;
  icon: keyof typeof ICONS;
  shortcut?: string;
  /** Only its drawing is shown. */
  small?: boolean;
  /** Whether it changes the session: not for a page that looks on. */
  changes?: boolean;
  /** For one mode; style.css keeps it out of the way in the other. */
  only?: WorkMode;
  run: () => void;
}

export class Toolbar {
  readonly element = el('header', { class: 'toolbar', role: 'toolbar', 'aria-label': 'Tools' });
  private buttons = new Map<string, { button: HTMLButtonElement; tool: Tool }>();

  /** `about`: a second line, and what the mouse says there. */
  constructor(scanName: string, about: string, title: string) {
    this.element.append(
      el('div', { class: 'scan-name' }, el('h1', { text: scanName, title: scanName }), el('span', { text: about, title })),
    );
  }

  group(label: string, ...parts: (Tool | HTMLElement)[]): HTMLElement {
    const group = el('div', { class: 'tools-group', role: 'group', 'aria-label': label });
    for (const part of parts) {
      if (part instanceof HTMLElement) {
        group.append(part);
        continue;
      }
      const hint = part.shortcut ? `${part.title} (${part.shortcut})` : part.title;
      const button = el('button', { 'data-tool': part.name, title: hint, 'aria-label': part.title, 'data-only': part.only, click: () => part.run() }, icon(ICONS[part.icon]));
      if (!part.small) button.append(el('span', { class: 'tool-text', text: part.text }));
      if (!part.small && part.shortcut) button.append(key(part.shortcut));
      this.buttons.set(part.name, { button, tool: part });
      group.append(button);
    }
    this.element.append(group);
    return group;
  }

  fill(): void {
    this.element.append(el('span', { class: 'fill' }));
  }

  press(name: string, on: boolean): void {
    this.buttons.get(name)?.button.setAttribute('aria-pressed', String(on));
  }

  disable(name: string, off: boolean): void {
    const entry = this.buttons.get(name);
    if (entry) entry.button.disabled = off;
  }

  /** Tools that change something, when nothing may be changed. */
  mayChange(may: boolean): void {
    for (const { button, tool } of this.buttons.values()) if (tool.changes) button.disabled = !may;
  }
}
