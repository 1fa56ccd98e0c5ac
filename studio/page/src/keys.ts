/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The one table of keys: it binds them and help lists it, so that the two agree.
 */

import type { WorkMode } from './modes';

export interface Binding {
  /** Such as "Space", "Shift+N", "Ctrl+Z", "?"; none for what only the mouse does. */
  keys: string[];
  /** What help shows instead of the keys, for the mouse or for many keys. */
  shown?: string;
  group: string;
  text: string;
  /** In this mode only. */
  mode?: WorkMode;
  run?: () => void;
  /** Also while the person types a class, as long as nothing is typed. */
  whileAsking?: boolean;
  /** Also in any field. */
  always?: boolean;
}

/** The name of a pressed key as the table writes it. */
export function keyName(event: KeyboardEvent): string {
  let name = event.key;
  if (name === ' ') name = 'Space';
  else if (name.length === 1) {
    // Where letters are not Latin ones, the place of the key counts.
    if (name.charCodeAt(0) > 127 && event.code.startsWith('Key')) name = event.code.slice(3);
    name = name.toUpperCase();
  }
  const isSymbol = name.length === 1 && !/[A-Z0-9]/.test(name);
  const parts = [];
  if (event.ctrlKey || event.metaKey) parts.push('Ctrl');
  if (event.altKey) parts.push('Alt');
  if (event.shiftKey && !isSymbol) parts.push('Shift');
  return [...parts, name].join('+');
}

const REPEATS = /^(Arrow|Page|Ctrl\+[ZY]|[[\]+=,.-]$)/;

/** What moves a slider that has the focus; all other keys are for the page. */
const SLIDES = /^(Arrow|Page|Home|End)/;

function isField(target: EventTarget | null): target is HTMLInputElement {
  return (
    target instanceof HTMLSelectElement ||
    target instanceof HTMLTextAreaElement ||
    (target instanceof HTMLInputElement && target.type !== 'checkbox' && target.type !== 'button')
  );
}

export class Keys {
  mode: WorkMode = 'labels';
  /** Keys that are down now, for flying. */
  readonly down = new Set<string>();
  private all: Binding[] = [];

  constructor() {
    window.addEventListener('keydown', (event) => this.pressed(event));
    window.addEventListener('keyup', (event) => this.down.delete(event.code));
    window.addEventListener('blur', () => this.down.clear());
  }

  /** Those of the present mode. */
  get bindings(): Binding[] {
    return this.all.filter((one) => !one.mode || one.mode === this.mode);
  }

  add(...bindings: Binding[]): void {
    for (const binding of bindings) {
      for (const key of binding.run ? binding.keys : []) {
        const other = this.all.find((one) => one.run && one.keys.includes(key));
        if (other && (!other.mode || !binding.mode || other.mode === binding.mode)) throw new Error(`The key ${key} has two meanings.`);
      }
      this.all.push(binding);
    }
  }

  private pressed(event: KeyboardEvent): void {
    if (event.defaultPrevented || event.isComposing) return;
    if (document.querySelector('dialog[open]')) return;
    const name = keyName(event);
    const binding = this.bindings.find((one) => one.run && one.keys.includes(name));
    const target = event.target;
    if (isField(target) && (target.type !== 'range' || SLIDES.test(name))) {
      const asking = binding?.whileAsking && target.dataset.asking !== undefined && target.value === '';
      if (!binding?.always && !asking) return;
    } else if (target instanceof HTMLButtonElement || target instanceof HTMLAnchorElement) {
      // These two press the button that has the focus.
      if (name === 'Enter' || name === 'Space') return;
    }
    if (!binding?.run) {
      if (!isField(target) && !event.ctrlKey && !event.altKey && !event.metaKey) this.down.add(event.code);
      return;
    }
    event.preventDefault();
    // A key that is held down goes on moving things, but asks and switches only once.
    if (!event.repeat || REPEATS.test(name)) binding.run();
  }
}
