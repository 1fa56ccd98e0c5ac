/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The list of instances: go there, hide, rename, merge, delete. Only rows in sight are elements.
 */

import type { Actions } from './actions';
import type { Asking } from './asking';
import type { Corrections } from './corrections';
import { count, el, key } from './dom';
import { editRow, instanceRow } from './instance_row';
import type { InstanceTable } from './instance_table';
import { keyName } from './keys';
import type { Messages } from './messages';
import { UNLABELED, colorOf } from './palette';
import { RowList } from './row_list';
import type { Session } from './session';

const ROW = 30;
type Order = 'number' | 'class' | 'points';

export class InstancesPanel {
  readonly element = el('aside', { class: 'instances', 'aria-label': 'Instances' });
  private list = new RowList('Instances', ROW, (index) => this.row(this.rows[index], index), () => this.drawFoot());
  private total = el('span', { class: 'context' });
  private foot = el('footer', {});
  private order: Order = 'number';
  private rows: number[] = [];
  private selected: number[] = [];
  private editing: number | null = null;
  /** The open editor: rows may change under it, and what was typed must not be lost. */
  private editor: HTMLElement | null = null;
  /** Told when the person wants to see an instance. */
  goTo: (label: number) => void = () => {};

  constructor(
    private session: Session,
    private table: InstanceTable,
    private corrections: Corrections,
    private actions: Actions,
    private asking: Asking,
    private messages: Messages,
  ) {
    const order = el('select', { 'aria-label': 'Order of the list', title: 'Order of the list' });
    for (const [value, text] of [['number', 'Newest'], ['class', 'Class'], ['points', 'Points']]) {
      order.append(el('option', { value, text }));
    }
    order.addEventListener('change', () => {
      this.order = order.value as Order;
      this.refresh();
    });
    const showAll = el('button', { class: 'small', text: 'Show all', title: 'Show all (Shift+H)', click: () => this.table.showAll() });
    this.element.append(el('header', {}, el('h2', { text: 'Instances' }), this.total, showAll, order), this.list.element, this.foot);
    this.list.element.addEventListener('keydown', (event) => this.pressed(event));
    session.on('changed', () => this.table.refresh());
    table.on('changed', () => {
      showAll.disabled = !table.anyHidden;
      this.refresh();
    });
    corrections.on('active', () => this.list.draw());
    showAll.disabled = true;
  }

  focus(): void {
    this.list.element.focus();
  }

  private refresh(): void {
    const all = [...this.session.instances.values()];
    if (this.order === 'number') all.sort((a, b) => b.label - a.label);
    if (this.order === 'class') all.sort((a, b) => a.class.localeCompare(b.class) || a.label - b.label);
    if (this.order === 'points') all.sort((a, b) => b.size - a.size);
    this.rows = [0, ...all.map((one) => one.label)];
    this.selected = this.selected.filter((label) => this.session.instances.has(label));
    this.total.textContent = String(all.length);
    if (this.editing !== null && !this.session.instances.has(this.editing)) this.stopEditor();
    this.list.setCount(this.rows.length);
  }

  private row(label: number, index: number): HTMLElement {
    const instance = this.session.instances.get(label);
    if (instance && this.editing === label) {
      this.editor ??= editRow(instance.class, instance.name, label, this.asking.classes, (c, n) => void this.save(label, c, n), () => this.stopEditing());
      return this.editor;
    }
    return instanceRow(
      {
        label,
        name: label === 0 ? 'No label' : this.session.nameOf(label),
        className: instance?.class ?? '',
        size: label === 0 ? this.session.unlabeled : (instance?.size ?? 0),
        color: label === 0 ? UNLABELED : colorOf(label),
        shown: this.table.isShown(label),
        active: this.corrections.active === label && label !== 0,
        selected: this.selected.includes(label),
        cursor: index === this.list.cursor,
      },
      {
        choose: (one, event) => this.choose(one, event.ctrlKey || event.metaKey || event.shiftKey),
        show: (one, event) => this.toggleShown(one, event.altKey || event.shiftKey),
        edit: (one) => this.edit(one),
        remove: (one) => void this.remove(one),
      },
      !this.session.writer,
    );
  }

  private drawFoot(): void {
    const [into, from] = this.selected;
    this.foot.replaceChildren();
    if (from !== undefined) {
      const text = `Merge ${this.session.nameOf(from)} into ${this.session.nameOf(into)}`;
      this.foot.append(el('button', { class: 'wide', title: text, disabled: !this.session.writer, click: () => void this.merge() }, el('span', { text }), key('M')));
    } else if (this.rows.length <= 1) {
      this.foot.append(el('p', { class: 'empty' }, 'Nothing is labelled yet. ', key('Space'), ' asks the first question.'));
    } else if (this.corrections.active !== null) {
      this.foot.append(el('p', { class: 'empty' }, key('⇧Click'), ` gives points to ${this.session.nameOf(this.corrections.active)}`));
    } else {
      this.foot.append(el('p', { class: 'empty' }, key('Ctrl+Click'), ' a second one to merge two'));
    }
  }

  private choose(label: number, add: boolean): void {
    this.list.cursor = this.rows.indexOf(label);
    if (label === 0) {
      this.selected = [];
    } else if (add) {
      if (this.selected.includes(label)) this.selected = this.selected.filter((one) => one !== label);
      else this.selected = [...this.selected.slice(0, 1), label];
    } else {
      this.selected = [label];
      this.corrections.activate(label);
      this.goTo(label);
    }
    this.list.draw();
  }

  private toggleShown(label: number, alone: boolean): void {
    if (alone) this.table.isolate(new Set([label]));
    else this.table.show(label, !this.table.isShown(label));
  }

  /** Hides all but the active instance, or the one under the cursor of the list. */
  isolateActive(): void {
    const label = this.corrections.active ?? this.selected[0];
    if (label === undefined) this.messages.note('Choose an instance first: click it in the list, or Alt+click its points.');
    else this.table.isolate(new Set([label]));
  }

  private edit(label: number): void {
    if (!this.actions.may()) return;
    this.stopEditor();
    this.editing = label;
    this.list.draw();
    this.list.element.querySelector<HTMLInputElement>('.editing input')?.select();
  }

  private stopEditor(): void {
    this.editing = this.editor = null;
  }

  private stopEditing(): void {
    this.stopEditor();
    this.list.draw();
    this.focus();
  }

  private async save(label: number, className: string, name: string): Promise<void> {
    const before = this.session.instances.get(label);
    this.stopEditing();
    if (!before || (before.class === className && before.name === name)) return;
    await this.actions.change({ do: 'edit', label, class: className, name });
  }

  async merge(): Promise<void> {
    const [into, from] = this.selected;
    if (from === undefined) {
      this.messages.note('Choose two instances in the list to merge: click one, Ctrl+click the other.');
      return;
    }
    const names = [this.session.nameOf(from), this.session.nameOf(into)];
    if (await this.actions.change({ do: 'merge', from, into })) {
      this.messages.note(`${names[0]} is now part of ${names[1]}. Ctrl+Z parts them again.`);
    }
  }

  private async remove(label: number): Promise<void> {
    const instance = this.session.instances.get(label);
    if (!instance) return;
    let seeds = 0;
    for (const seed of this.session.seeds.values()) if (seed.label === label) seeds++;
    const what = `${this.session.nameOf(label)} is deleted: ${count(instance.size)} points and ${seeds} seed${seeds === 1 ? '' : 's'}.`;
    if (await this.actions.change({ do: 'delete', label })) this.messages.note(`${what} Ctrl+Z brings it back.`);
  }

  private pressed(event: KeyboardEvent): void {
    if (event.target !== this.list.element) return;
    const label = this.rows[this.list.cursor];
    const acts: Record<string, () => void> = {
      ...this.list.moves,
      Enter: () => this.choose(label, false),
      'Ctrl+Enter': () => this.choose(label, true),
      'Shift+Enter': () => this.choose(label, true),
      H: () => this.toggleShown(label, false),
      'Alt+H': () => this.toggleShown(label, true),
      F2: () => label !== 0 && this.edit(label),
      Delete: () => void this.remove(label),
    };
    const act = acts[keyName(event)];
    if (!act) return;
    event.preventDefault();
    event.stopPropagation();
    act();
  }
}
