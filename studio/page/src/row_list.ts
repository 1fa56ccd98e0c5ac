/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A list of many rows, of which those in view are elements; the focus stays on the list.
 */

import { el } from './dom';

export class RowList {
  readonly element: HTMLElement;
  cursor = 0;
  private space = el('div', { class: 'space' });
  private count = 0;

  constructor(
    label: string,
    private rowHeight: number,
    private row: (index: number) => HTMLElement,
    private drawn: () => void,
  ) {
    this.element = el('div', { class: 'list', role: 'listbox', tabindex: '0', 'aria-label': label, 'aria-multiselectable': 'true' }, this.space);
    this.element.addEventListener('scroll', () => this.draw());
    new ResizeObserver(() => this.draw()).observe(this.element);
  }

  setCount(count: number): void {
    this.count = count;
    this.cursor = Math.max(0, Math.min(this.cursor, count - 1));
    this.draw();
  }

  /** An element that is there already stays where it is: a field in it keeps the focus. */
  draw(): void {
    const { scrollTop, clientHeight } = this.element;
    this.space.style.height = `${this.count * this.rowHeight}px`;
    const first = Math.max(0, Math.floor(scrollTop / this.rowHeight) - 3);
    const last = Math.min(this.count, Math.ceil((scrollTop + clientHeight) / this.rowHeight) + 3);
    const rows = new Set<Element>();
    let active = '';
    for (let i = first; i < last; i++) {
      const row = this.row(i);
      row.style.transform = `translateY(${i * this.rowHeight}px)`;
      rows.add(row);
      if (i === this.cursor) active = row.id;
    }
    for (const old of [...this.space.children]) if (!rows.has(old)) old.remove();
    for (const row of rows) if (!row.parentElement) this.space.append(row);
    this.element.setAttribute('aria-activedescendant', active);
    this.drawn();
  }

  moveTo(index: number): void {
    this.cursor = Math.max(0, Math.min(this.count - 1, index));
    this.reveal(this.cursor);
    this.draw();
  }

  reveal(index: number): void {
    const top = index * this.rowHeight;
    const { element } = this;
    if (top < element.scrollTop) element.scrollTop = top;
    if (top + this.rowHeight > element.scrollTop + element.clientHeight) element.scrollTop = top + this.rowHeight - element.clientHeight;
  }

  /** What the keys that move in any list do here. */
  get moves(): Record<string, () => void> {
    const { cursor, count } = this;
    return {
      ArrowDown: () => this.moveTo(cursor + 1),
      ArrowUp: () => this.moveTo(cursor - 1),
      Home: () => this.moveTo(0),
      End: () => this.moveTo(count - 1),
    };
  }
}
