/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Save as: what is to be written, under which name, and what was.
 */

import { Cancelled } from './connection';
import type { Connection } from './connection';
import { ICONS, el, icon } from './dom';
import type { Header } from './protocol';

/** What a dialog saves, and how the server is asked for it. */
export interface Export {
  title: string;
  note: string;
  /** The name that is proposed. */
  stem: string;
  fields: () => HTMLElement[];
  request: (data: FormData) => Header;
}

export class ExportDialog {
  private dialog = el('dialog', { class: 'export' });
  private file: HTMLInputElement;
  private write: HTMLButtonElement;
  private outcome = el('div', { class: 'outcome', role: 'status', 'aria-live': 'polite' });

  constructor(
    parent: HTMLElement,
    private connection: Connection,
    private what: Export,
  ) {
    parent.append(this.dialog);
    this.dialog.setAttribute('aria-label', what.title);
    this.file = el('input', { type: 'text', name: 'file', 'aria-label': 'File name without ending', spellcheck: 'false', autocomplete: 'off' });
    this.file.value = what.stem;
    this.write = el('button', { class: 'primary', type: 'submit', text: 'Write' });
    this.dialog.append(this.form());
    this.dialog.addEventListener('click', (event) => {
      if (event.target === this.dialog) this.dialog.close();
    });
  }

  open(): void {
    this.outcome.replaceChildren(el('p', { class: 'muted', text: this.what.note }));
    this.dialog.showModal();
    this.dialog.querySelector<HTMLElement>('select, input[type=radio]:checked')?.focus();
  }

  private form(): HTMLElement {
    return el(
      'form',
      {
        submit: (event: SubmitEvent) => {
          event.preventDefault();
          void this.send(new FormData(event.target as HTMLFormElement));
        },
      },
      el(
        'header',
        {},
        el('h2', { text: this.what.title }),
        el('button', { class: 'quiet', 'aria-label': 'Close', click: () => this.dialog.close() }, icon(ICONS.close)),
      ),
      ...this.what.fields(),
      el('label', { class: 'file' }, el('span', { text: 'Name' }), this.file, this.write),
      this.outcome,
    );
  }

  private async send(data: FormData): Promise<void> {
    const file = String(data.get('file')).trim();
    if (file === '') {
      this.outcome.replaceChildren(el('p', { class: 'wrong', text: 'A file needs a name.' }));
      this.file.focus();
      return;
    }
    this.write.disabled = true;
    this.outcome.replaceChildren(el('p', { class: 'muted', text: 'Writing …' }));
    try {
      const { header } = await this.connection.request({ ...this.what.request(data), file });
      const list = el('ul', {});
      for (const name of header.files as string[]) list.append(el('li', { text: name }));
      const remarks = (header.remarks as string[]).map((text) => el('p', { class: 'muted', text }));
      this.outcome.replaceChildren(el('p', { class: 'right', text: 'Written:' }), list, ...remarks);
    } catch (error) {
      const text = error instanceof Cancelled ? 'Something changed while it was written; write it again.' : (error as Error).message;
      this.outcome.replaceChildren(el('p', { class: 'wrong', role: 'alert', text }));
    }
    this.write.disabled = false;
  }
}

/** One of several, one line each. */
export function choice(name: string, label: string, options: readonly (readonly [value: string, name: string, text: string])[]): HTMLElement {
  const list = el('div', { class: 'formats', role: 'radiogroup', 'aria-label': label });
  options.forEach(([value, title, text], i) => {
    list.append(
      el(
        'label',
        { class: 'format' },
        el('input', { type: 'radio', name, value, checked: i === 0 }),
        el('span', { class: 'format-name', text: title }),
        el('span', { class: 'format-text', text }),
      ),
    );
  });
  return list;
}

/** The name of a scan without its ending. */
export function stemOf(scanName: string): string {
  return scanName.replace(/\.[^.]*$/, '');
}
