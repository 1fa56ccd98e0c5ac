/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The card that asks what something is: digits, a typed class, or an instance that is there.
 */

import { ICONS, el, icon, key } from './dom';
import { css } from './palette';
import type { Answer } from './protocol';

export interface NearInstance {
  label: number;
  name: string;
  className: string;
  color: [number, number, number];
}

export interface ClassInputOptions {
  title: string;
  context: string;
  classes: string[];
  classColor: (name: string) => [number, number, number];
  lastClass: string | null;
  near: NearInstance[];
  all: NearInstance[];
  hint: (string | [string, string])[];
  answer: (answer: Answer) => void;
  cancel: () => void;
  pick: () => void;
}

const MOST_SUGGESTIONS = 7;
const MOST_MORE = 8;

interface Suggestion {
  answer: Answer;
  text: string;
  note: string;
  color: [number, number, number];
}

export class ClassInput {
  readonly element = el('section', { class: 'card asking', role: 'group' });
  readonly field: HTMLInputElement;
  private list = el('ul', { class: 'suggestions', role: 'listbox', id: 'suggestions', 'aria-label': 'Classes and instances', hidden: true });
  private suggestions: Suggestion[] = [];
  private chosen = 0;
  private pickButton: HTMLButtonElement;

  constructor(private options: ClassInputOptions) {
    const { title, context } = options;
    this.element.setAttribute('aria-label', title);
    this.field = el('input', {
      type: 'text',
      class: 'class-field',
      role: 'combobox',
      'aria-label': `${title} Type a class, or a digit.`,
      'aria-controls': 'suggestions',
      'aria-expanded': 'false',
      'aria-autocomplete': 'list',
      autocomplete: 'off',
      spellcheck: 'false',
      'data-asking': true,
      placeholder: options.lastClass ? `Class, or Enter: ${options.lastClass}` : 'Type a class',
      input: () => this.complete(),
      keydown: (event: KeyboardEvent) => this.pressed(event),
    });
    this.pickButton = el('button', { class: 'small', 'aria-pressed': 'false', click: () => options.pick() }, icon(ICONS.pick), 'Pick', key('Ctrl+I'));
    this.element.append(
      el('header', {}, el('h2', { text: title }), el('span', { class: 'context', text: context })),
      this.chips(),
      this.moreChips() ?? '',
      el('div', { class: 'field-row' }, this.field, this.pickButton, this.list),
    );
    if (options.near.length > 0) this.element.append(this.nearRow());
    const hint = el('p', { class: 'hint' });
    for (const part of options.hint) {
      if (typeof part === 'string') hint.append(part);
      else hint.append(el('span', {}, key(part[0]), part[1]));
    }
    this.element.append(hint);
    // A press beside the field must not take the focus from it.
    this.element.addEventListener('mousedown', (event) => {
      if (event.target !== this.field) event.preventDefault();
    });
  }

  focus(): void {
    this.field.focus({ preventScroll: true });
  }

  /** A digit that was pressed outside the field, as after a turn of the view; true: it was an answer. */
  digit(event: KeyboardEvent): boolean {
    const isDigit = /^(Digit|Numpad)[0-9]$/.test(event.code) || /^[0-9]$/.test(event.key);
    return isDigit && !event.ctrlKey && !event.altKey && !event.metaKey && this.act(event, true);
  }

  /** A letter pressed outside the field: the field takes the focus, and with it the letter. */
  letter(event: KeyboardEvent): boolean {
    const isLetter = /^\p{L}$/u.test(event.key) && !event.ctrlKey && !event.altKey && !event.metaKey;
    if (isLetter) this.focus();
    return isLetter;
  }

  set picking(on: boolean) {
    this.pickButton.setAttribute('aria-pressed', String(on));
    this.element.classList.toggle('picking', on);
  }

  private chips(): HTMLElement {
    const { classes, answer, classColor } = this.options;
    const box = el('div', { class: 'chips' });
    classes.slice(0, 9).forEach((name, i) => {
      box.append(this.chip(String(i + 1), name, classColor(name), () => answer({ class: name })));
    });
    box.append(this.chip('0', 'none', null, () => answer({ label: 0 })));
    return box;
  }

  /** Classes for which there is no digit: without them nobody knows what may be typed. */
  private moreChips(): HTMLElement | null {
    const { classes, answer, classColor } = this.options;
    const more = classes.slice(9);
    if (more.length === 0) return null;
    const box = el('div', { class: 'other-classes' });
    for (const name of more.slice(0, MOST_MORE)) box.append(this.chip('', name, classColor(name), () => answer({ class: name })));
    if (more.length > MOST_MORE) box.append(el('span', { class: 'near-title', text: `and ${more.length - MOST_MORE} more: type` }));
    return box;
  }

  private chip(digit: string, text: string, color: [number, number, number] | null, click: () => void): HTMLElement {
    const swatch = el('span', { class: 'swatch' });
    if (color) swatch.style.background = css(color);
    else swatch.classList.add('empty');
    return el('button', { class: 'chip', title: text, click }, digit ? key(digit) : '', swatch, el('span', { class: 'chip-text', text }));
  }

  private nearRow(): HTMLElement {
    const row = el('div', { class: 'near' }, el('span', { class: 'near-title', text: 'Nearest' }));
    this.options.near.forEach((one, i) => {
      row.append(this.chip(`⇧${i + 1}`, one.name, one.color, () => this.options.answer({ label: one.label })));
    });
    return row;
  }

  private complete(): void {
    const typed = this.field.value.trim().toLowerCase();
    const { classes, all, classColor } = this.options;
    this.suggestions = [];
    if (typed !== '') {
      const named = all.filter((near) => near.name.toLowerCase().includes(typed));
      // Who types the whole name of an instance means it, not a new class of that name.
      const exactly = named.find((near) => near.name.toLowerCase() === typed && !classes.includes(near.name));
      if (exactly) this.suggestions.push(this.thatIsThere(exactly));
      const matches = classes.filter((name) => name.toLowerCase().includes(typed));
      const starts = (name: string): number => (name.toLowerCase().startsWith(typed) ? 0 : 1);
      matches.sort((a, b) => starts(a) - starts(b));
      for (const name of matches.slice(0, 4)) {
        this.suggestions.push({ answer: { class: name }, text: name, note: 'new instance', color: classColor(name) });
      }
      const exact = matches.some((name) => name.toLowerCase() === typed);
      if (!exact && !exactly) {
        const name = this.field.value.trim();
        this.suggestions.push({ answer: { class: name }, text: name, note: 'new class', color: [150, 150, 150] });
      }
      const left = MOST_SUGGESTIONS - this.suggestions.length;
      for (const one of named.filter((near) => near !== exactly).slice(0, left)) this.suggestions.push(this.thatIsThere(one));
    }
    this.chosen = 0;
    this.showSuggestions();
  }

  private thatIsThere(one: NearInstance): Suggestion {
    return { answer: { label: one.label }, text: one.name, note: 'is there', color: one.color };
  }

  private showSuggestions(): void {
    const open = this.suggestions.length > 0;
    this.list.hidden = !open;
    this.field.setAttribute('aria-expanded', String(open));
    this.list.replaceChildren(
      ...this.suggestions.map((one, i) => {
        const swatch = el('span', { class: 'swatch' });
        swatch.style.background = css(one.color);
        return el(
          'li',
          {
            role: 'option',
            id: `suggestion-${i}`,
            'aria-selected': String(i === this.chosen),
            click: () => this.options.answer(one.answer),
          },
          swatch,
          el('span', { class: 'suggestion-text', text: one.text }),
          el('span', { class: 'suggestion-note', text: one.note }),
        );
      }),
    );
    if (open) this.field.setAttribute('aria-activedescendant', `suggestion-${this.chosen}`);
    else this.field.removeAttribute('aria-activedescendant');
  }

  private pressed(event: KeyboardEvent): void {
    if (event.isComposing || event.ctrlKey || event.altKey || event.metaKey) return;
    const empty = this.field.value === '';
    const taken = this.act(event, empty);
    if (taken) {
      event.preventDefault();
      event.stopPropagation();
    }
  }

  private act(event: KeyboardEvent, empty: boolean): boolean {
    const { options } = this;
    const digit = /^(Digit|Numpad)[0-9]$/.test(event.code) ? Number(event.code.slice(-1)) : null;
    if (event.key === 'Escape') {
      if (empty) options.cancel();
      else {
        this.field.value = '';
        this.complete();
      }
      return true;
    }
    if (empty && event.shiftKey && digit !== null) {
      const one = options.near[digit - 1];
      if (one) options.answer({ label: one.label });
      return true;
    }
    if (empty && /^[0-9]$/.test(event.key)) {
      const n = Number(event.key);
      if (n === 0) options.answer({ label: 0 });
      else if (options.classes[n - 1] !== undefined) options.answer({ class: options.classes[n - 1] });
      return true;
    }
    if (event.key === 'Enter' && !event.shiftKey) {
      if (!empty && this.suggestions[this.chosen]) options.answer(this.suggestions[this.chosen].answer);
      else if (empty && options.lastClass) options.answer({ class: options.lastClass });
      return true;
    }
    if (!empty && (event.key === 'ArrowDown' || event.key === 'ArrowUp')) {
      const n = this.suggestions.length;
      if (n > 0) this.chosen = (this.chosen + (event.key === 'ArrowDown' ? 1 : n - 1)) % n;
      this.showSuggestions();
      return true;
    }
    return false;
  }
}
