/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Into how many groups, and how many parts of them: the upper end of the panel of parts.
 */

import { el, key } from './dom';
import type { PartsState } from './parts_state';
import type { PartsWork } from './parts_work';
import type { Session } from './session';

const GROUPS = 100;
const MOST_GROUPS = 100_000;

export class CutControls {
  readonly element = el('section', { class: 'cut', 'aria-label': 'How many parts' });
  private why = el('p', {}, 'The scan is cut into groups that are nearly convex, and groups are joined to parts as long as that costs little. Each part gets a convex hull: collision geometry that you can look at, split, join and export.');
  private wait = el('p', { class: 'muted', text: 'The first cut of a large scan takes a while.' });
  private groups = el('input', { type: 'number', min: '1', max: String(MOST_GROUPS), 'aria-label': 'Number of groups' });
  private decompose = el('button', { class: 'primary', type: 'submit' });
  private slider = el('input', { type: 'range', min: '1', 'aria-label': 'Number of parts' });
  private number = el('input', { type: 'number', min: '1', 'aria-label': 'Number of parts, as a number' });
  private cost = el('p', { class: 'cost', role: 'status' });
  private cutRow = el('div', { class: 'cut-row' }, el('span', { text: 'Parts' }), this.slider, this.number);

  constructor(
    private state: PartsState,
    private work: PartsWork,
    private session: Session,
  ) {
    this.groups.value = String(GROUPS);
    const form = el(
      'form',
      { class: 'groups-row', submit: (event: Event) => (event.preventDefault(), this.sendGroups()) },
      el('label', {}, el('span', { text: 'Groups' }), this.groups),
      this.decompose,
    );
    this.element.append(this.why, form, this.wait, this.cutRow, this.cost);
    this.slider.addEventListener('input', () => this.want(Number(this.slider.value)));
    this.number.addEventListener('change', () => this.want(Number(this.number.value)));
    this.number.addEventListener('keydown', (event) => event.key === 'Enter' && this.number.blur());
    state.on('changed', ({ groups }) => {
      if (groups && state.groups > 0) this.groups.value = String(state.groups);
    });
  }

  private sendGroups(): void {
    // After Enter the keys are for the view again, here as in the field below.
    this.groups.blur();
    if (this.groups.reportValidity()) void this.work.decompose(Number(this.groups.value));
  }

  /** The controls show what the person wants at once; the parts follow. */
  private want(parts: number): void {
    if (!Number.isFinite(parts) || parts < 1) {
      this.refresh();
      return;
    }
    this.showNumber(Math.min(parts, this.state.groups));
    void this.work.cut(parts);
  }

  private showNumber(parts: number): void {
    this.slider.value = this.number.value = String(parts);
    this.cost.replaceChildren(this.work.costText(parts), key(','), key('.'));
  }

  refresh(): void {
    const { state, work, session } = this;
    const none = state.groups === 0;
    this.why.hidden = this.wait.hidden = !none;
    this.cutRow.hidden = this.cost.hidden = none;
    this.decompose.textContent = work.decomposing ? 'Working …' : 'Decompose';
    this.decompose.disabled = work.decomposing || !session.writer || !state.ready;
    this.decompose.classList.toggle('primary', none);
    this.slider.disabled = this.number.disabled = work.decomposing || !session.writer;
    this.slider.max = this.number.max = String(state.groups);
    // What the person drags must not jump back to an answer that is older.
    if (!none && !work.isCutting) this.showNumber(state.list.length);
  }
}
