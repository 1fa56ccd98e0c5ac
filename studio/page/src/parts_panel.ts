/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The panel of parts: how many, which, how well they fit, and what is done to the selected one.
 */

import type { CutControls } from './cut_controls';
import { count, el, key, volume } from './dom';
import type { HullStore } from './hull_store';
import { keyName } from './keys';
import { nameOf, partRow } from './part_row';
import type { PartTable } from './part_table';
import type { PartsState } from './parts_state';
import type { PartsWork } from './parts_work';
import type { Part } from './protocol';
import { RowList } from './row_list';
import type { Session } from './session';

const ROW = 44;
type Order = 'points' | 'fit' | 'number';

export class PartsPanel {
  readonly element = el('aside', { class: 'instances parts', 'aria-label': 'Parts', hidden: true });
  private list = new RowList('Parts', ROW, (index) => this.row(this.rows[index], index), () => {});
  private total = el('span', { class: 'context' });
  private totals = el('p', { class: 'totals' });
  private acts = el('div', { class: 'acts' });
  private order: Order = 'points';
  private rows: Part[] = [];

  constructor(
    private state: PartsState,
    private store: HullStore,
    private table: PartTable,
    private work: PartsWork,
    private cut: CutControls,
    private session: Session,
  ) {
    this.element.append(
      el('header', {}, el('h2', { text: 'Parts' }), this.total, this.orderSelect()),
      cut.element,
      this.list.element,
      el('footer', {}, this.totals, this.acts),
    );
    this.list.element.addEventListener('keydown', (event) => this.pressed(event));
    this.element.addEventListener('click', (event) => this.act(event));
  }

  private orderSelect(): HTMLElement {
    const select = el('select', { 'aria-label': 'Order of the list', title: 'Order of the list' });
    for (const [value, text] of [['points', 'Largest'], ['fit', 'Worst fit'], ['number', 'Number']]) select.append(el('option', { value, text }));
    select.addEventListener('change', () => {
      this.order = select.value as Order;
      this.refresh();
    });
    return select;
  }

  focus(): void {
    this.list.element.focus();
  }

  /** Brings the row of the selected part into view. */
  reveal(): void {
    const index = this.rows.findIndex((part) => part.part === this.work.selected);
    if (index >= 0) this.list.moveTo(index);
  }

  refresh(): void {
    const off = (part: Part): number => this.store.tightnessOf(part)?.max_concavity ?? -1;
    const by: Record<Order, (a: Part, b: Part) => number> = {
      points: (a, b) => b.size - a.size,
      fit: (a, b) => off(b) - off(a),
      number: (a, b) => a.part - b.part,
    };
    const at = this.rows[this.list.cursor]?.part;
    this.rows = [...this.state.list].sort((a, b) => by[this.order](a, b) || a.part - b.part);
    const same = this.rows.findIndex((part) => part.part === at);
    if (same >= 0) this.list.cursor = same;
    this.total.textContent = this.state.groups > 0 ? `${count(this.rows.length)} of ${count(this.state.groups)} groups` : '';
    this.cut.refresh();
    this.list.setCount(this.rows.length);
    this.drawTotals();
    this.drawActs();
  }

  private row(part: Part, index: number): HTMLElement {
    const { work } = this;
    return partRow(
      {
        part,
        color: this.table.colorOf(part),
        facts: this.store.hullOf(part)?.facts ?? null,
        tightness: this.store.tightnessOf(part),
        selected: part.part === work.selected || part.part === work.second,
        cursor: index === this.list.cursor,
      },
      (event) => {
        this.list.cursor = index;
        void work.clicked(part, event.shiftKey || event.ctrlKey || event.metaKey);
      },
    );
  }

  private drawTotals(): void {
    const kept = this.state.list.filter((part) => !part.dropped);
    const hulls = kept.flatMap((part) => this.store.hullOf(part)?.facts ?? []);
    const sum = (of: (facts: (typeof hulls)[number]) => number): number => hulls.reduce((all, facts) => all + of(facts), 0);
    this.totals.hidden = this.state.list.length === 0;
    const more = hulls.length < kept.length ? ` in ${hulls.length} hulls so far` : '';
    this.totals.textContent = `${kept.length} kept · ${count(sum((one) => one.vertices))} vertices · ${volume(sum((one) => one.volume))}${more}`;
  }

  private drawActs(): void {
    const part = this.work.selectedPart;
    const other = this.work.secondPart;
    this.acts.hidden = this.state.list.length === 0;
    if (!part) {
      this.acts.replaceChildren(el('p', { class: 'empty' }, key('Click'), ' a part, in the picture or in the list'));
      return;
    }
    const join = other ? `Join with ${other.part}` : this.work.joining ? 'Click the other' : 'Join';
    this.acts.replaceChildren(
      el('p', { class: 'acts-title', text: other ? `${nameOf(part)} and ${nameOf(other)}` : nameOf(part) }),
      this.button('split', 'Split', '/', 'The two that it was joined of', !part.splits),
      this.button('join', join, 'M', 'Shift+Click a second part, or press this and click it', false, this.work.joining),
      this.button('drop', part.dropped ? 'Keep' : 'Drop', 'Del', part.dropped ? 'In again' : 'Leave it out of what is exported', false),
      this.button('exact', 'Exact', 'R', 'A hull with all vertices, that holds all its points', false, part.exact),
    );
  }

  private button(act: string, text: string, shortcut: string, title: string, off: boolean, pressed?: boolean): HTMLElement {
    const button = el('button', { 'data-act': act, title: `${title} (${shortcut})`, disabled: off || !this.session.writer }, el('span', { text }), key(shortcut));
    if (pressed !== undefined) button.setAttribute('aria-pressed', String(pressed));
    return button;
  }

  private act(event: MouseEvent): void {
    const act = (event.target as Element).closest<HTMLElement>('[data-act]')?.dataset.act;
    if (act === 'split') void this.work.split();
    if (act === 'join') void this.work.join();
    if (act === 'drop') void this.work.toggleDropped();
    if (act === 'exact') void this.work.toggleExact();
  }

  private pressed(event: KeyboardEvent): void {
    const part = this.rows[this.list.cursor];
    if (!part) return;
    const choose = (add: boolean) => (): void => {
      void this.work.clicked(part, add);
      if (!add) this.work.focus(part);
    };
    const acts: Record<string, () => void> = { ...this.list.moves, Enter: choose(false), 'Shift+Enter': choose(true), 'Ctrl+Enter': choose(true) };
    const act = acts[keyName(event)];
    if (!act) return;
    event.preventDefault();
    event.stopPropagation();
    act();
  }
}
