/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Save as: the formats, one line each, and what was written.
 */

import { Cancelled } from './connection';
import type { Connection } from './connection';
import { ICONS, el, icon } from './dom';

const FORMATS = [
  ['pcd', 'PCD', 'The scan with all its fields, and label and class for each point'],
  ['ply', 'PLY', 'The same as PLY, for CloudCompare and MeshLab'],
  ['seeds', 'Seeds', 'The seeds as CSV: index of the point, label, class'],
  ['scannet', 'ScanNet', 'Submission files of the benchmark and segs.json'],
  ['s3dis', 'S3DIS', 'A room folder with one text file for each instance'],
  ['kitti', 'KITTI', 'A .label file: class and instance in 32 bits for each point'],
] as const;

export class ExportDialog {
  private dialog = el('dialog', { class: 'export', 'aria-label': 'Save as' });
  private file: HTMLInputElement;
  private write: HTMLButtonElement;
  private outcome = el('div', { class: 'outcome', role: 'status', 'aria-live': 'polite' });
  private stem: string;

  constructor(
    parent: HTMLElement,
    private connection: Connection,
    scanName: string,
  ) {
    parent.append(this.dialog);
    this.stem = scanName.replace(/\.[^.]*$/, '') + '_labels';
    this.file = el('input', { type: 'text', name: 'file', 'aria-label': 'File name without ending', spellcheck: 'false', autocomplete: 'off' });
    this.file.value = this.stem;
    this.write = el('button', { class: 'primary', type: 'submit', text: 'Write' });
    this.dialog.append(this.form());
    this.dialog.addEventListener('click', (event) => {
      if (event.target === this.dialog) this.dialog.close();
    });
  }

  open(): void {
    this.outcome.replaceChildren(el('p', { class: 'muted', text: 'The session itself is always on the disk; this writes files for others, into its folder.' }));
    this.dialog.showModal();
    this.dialog.querySelector<HTMLInputElement>('input[type=radio]:checked')?.focus();
  }

  private form(): HTMLElement {
    const formats = el('div', { class: 'formats', role: 'radiogroup', 'aria-label': 'Format' });
    for (const [value, name, text] of FORMATS) {
      formats.append(
        el(
          'label',
          { class: 'format' },
          el('input', { type: 'radio', name: 'format', value, checked: value === 'pcd' }),
          el('span', { class: 'format-name', text: name }),
          el('span', { class: 'format-text', text }),
        ),
      );
    }
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
        el('h2', { text: 'Save as' }),
        el('button', { class: 'quiet', 'aria-label': 'Close', click: () => this.dialog.close() }, icon(ICONS.close)),
      ),
      formats,
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
      const { header } = await this.connection.request({ ask: 'export', format: data.get('format'), file });
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
