/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The labels, groups or parts by size; a click hides one and what is in it.
 */

import { ICONS, count, el, icon, shortCount } from '../dom';
import type { InstanceTable } from '../instance_table';
import { UNLABELED, colorOf, css } from '../palette';
import { fit } from '../part_row';
import type { HullFacts, Tightness } from '../protocol';
import { RowList } from '../row_list';
import type { Facts, Mark } from './data';

const TITLES = { labels: 'Labels', groups: 'Groups', parts: 'Parts', values: '' };

export class MarksList {
  readonly element: HTMLElement;
  private list: RowList;

  constructor(
    private facts: Facts,
    private table: InstanceTable,
  ) {
    const { kind, marks, indices } = facts;
    this.list = new RowList(TITLES[kind], kind === 'parts' ? 44 : 30, (i) => this.row(marks[i], i), () => {});
    const few = marks.length < indices ? `the ${count(marks.length)} with the most points of ${count(indices)}` : count(indices);
    const showAll = el('button', { class: 'small quiet', text: 'Show all', click: () => table.showAll() });
    this.element = el('div', { class: 'marks' }, el('header', {}, el('h2', { text: TITLES[kind] }), el('span', { class: 'context', text: few }), showAll), this.list.element);
    this.list.element.addEventListener('keydown', (event) => this.pressed(event));
    table.on('changed', () => this.refresh());
    this.refresh();
  }

  private refresh(): void {
    this.element.querySelector<HTMLButtonElement>('header button')!.hidden = !this.table.anyHidden;
    this.list.setCount(this.facts.marks.length);
  }

  private toggle({ index }: Mark, alone: boolean): void {
    if (alone) this.table.isolate(new Set([index]));
    else this.table.show(index, !this.table.isShown(index));
  }

  private pressed(event: KeyboardEvent): void {
    const move = this.list.moves[event.key];
    const mark = this.facts.marks[this.list.cursor];
    if (move) move();
    else if ((event.key === 'Enter' || event.key === ' ') && mark) this.toggle(mark, event.altKey);
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  private row(mark: Mark, place: number): HTMLElement {
    const shown = this.table.isShown(mark.index);
    const swatch = el('span', { class: 'swatch' });
    swatch.style.background = css(mark.index === 0 ? UNLABELED : colorOf(mark.index));
    const eye = el('span', { class: 'eye', 'aria-hidden': 'true' }, icon(shown ? ICONS.eye : ICONS.hidden));
    const line = [swatch, el('span', { class: 'instance-name', text: mark.name }), el('span', { class: 'instance-size', text: shortCount(mark.points) }), eye];
    const isPart = this.facts.kind === 'parts' && mark.index > 0;
    const row = el(
      'div',
      {
        class: this.facts.kind === 'parts' ? 'part' : 'instance',
        role: 'option',
        id: `mark-${mark.index}`,
        'data-mark': String(mark.index),
        'aria-selected': String(shown),
        title: `${mark.name}: ${count(mark.points)} points. Click: ${shown ? 'hide' : 'show'} it; Alt+click: hide all others`,
        click: (event: MouseEvent) => this.toggle(mark, event.altKey),
      },
      ...(this.facts.kind === 'parts' ? [el('span', { class: 'part-head' }, ...line)] : line),
      isPart ? fit(mark as HullFacts, mark as Tightness) : null,
    );
    row.classList.toggle('off', !shown);
    row.classList.toggle('cursor', place === this.list.cursor);
    return row;
  }
}
