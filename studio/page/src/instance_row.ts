/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * One row of the list of instances, to be looked at or to be edited.
 */

import { ICONS, count, el, icon, shortCount } from './dom';
import { css } from './palette';

export interface RowData {
  label: number;
  name: string;
  className: string;
  size: number;
  color: [number, number, number];
  shown: boolean;
  active: boolean;
  selected: boolean;
  cursor: boolean;
}

export interface RowActions {
  choose: (label: number, event: MouseEvent) => void;
  show: (label: number, event: MouseEvent) => void;
  edit: (label: number) => void;
  remove: (label: number) => void;
}

export function instanceRow(row: RowData, actions: RowActions, readOnly: boolean): HTMLElement {
  const swatch = el('span', { class: 'swatch' });
  swatch.style.background = css(row.color);
  const tool = (name: string, path: string, title: string, click: (event: MouseEvent) => void, disabled = false) =>
    el(
      'button',
      {
        class: `quiet tool ${name}`,
        'aria-label': `${title} ${row.name}`,
        title,
        tabindex: '-1',
        disabled,
        click: (event: MouseEvent) => {
          event.stopPropagation();
          click(event);
        },
      },
      icon(path),
    );
  const element = el(
    'div',
    {
      class: 'instance',
      role: 'option',
      id: `instance-${row.label}`,
      'data-label': String(row.label),
      'aria-selected': String(row.selected),
      title: row.label === 0 ? 'Points that have no label yet' : `${row.name}: ${count(row.size)} points. Click: go there and make it active`,
      click: (event: MouseEvent) => actions.choose(row.label, event),
      dblclick: () => row.label !== 0 && actions.edit(row.label),
    },
    tool('eye', row.shown ? ICONS.eye : ICONS.hidden, row.shown ? 'Hide (Alt+click: hide all others)' : 'Show', (event) =>
      actions.show(row.label, event),
    ),
    swatch,
    el('span', { class: 'instance-name', text: row.name }),
  );
  if (row.active) element.append(el('span', { class: 'badge', text: 'active' }));
  element.append(el('span', { class: 'instance-size', text: shortCount(row.size) }));
  if (row.label !== 0) {
    element.append(
      el(
        'span',
        { class: 'tools' },
        tool('edit', ICONS.edit, 'Change class and name of', () => actions.edit(row.label), readOnly),
        tool('trash', ICONS.trash, 'Delete', () => actions.remove(row.label), readOnly),
      ),
    );
  }
  element.classList.toggle('off', !row.shown);
  element.classList.toggle('active', row.active);
  element.classList.toggle('cursor', row.cursor);
  return element;
}

export function editRow(
  className: string,
  name: string,
  label: number,
  classes: string[],
  save: (className: string, name: string) => void,
  cancel: () => void,
): HTMLElement {
  const list = el('datalist', { id: 'class-list' });
  for (const one of classes) list.append(el('option', { value: one }));
  const field = (text: string, value: string, more: Record<string, string> = {}): HTMLInputElement => {
    const input = el('input', { type: 'text', 'aria-label': text, placeholder: text, spellcheck: 'false', ...more });
    input.value = value;
    return input;
  };
  const classField = field('Class', className, { list: 'class-list' });
  const nameField = field('Name', name);
  nameField.placeholder = `Name (${className || 'instance'} ${label})`;
  const done = (): void => save(classField.value.trim(), nameField.value.trim());
  return el(
    'form',
    {
      class: 'instance editing',
      submit: (event: Event) => {
        event.preventDefault();
        done();
      },
      keydown: (event: KeyboardEvent) => {
        if (event.key === 'Enter') {
          event.preventDefault();
          done();
        }
        if (event.key === 'Escape') cancel();
        event.stopPropagation();
      },
    },
    classField,
    nameField,
    el('button', { class: 'quiet', 'aria-label': 'Save', title: 'Save (Enter)', click: done }, icon(ICONS.check)),
    el('button', { class: 'quiet', 'aria-label': 'Leave it as it was', title: 'Esc', click: cancel }, icon(ICONS.close)),
    list,
  );
}
