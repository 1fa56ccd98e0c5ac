/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The proposed seeds one after the other: fly there, light up the group, ask, go on.
 */

import { Actions } from './actions';
import type { Asking } from './asking';
import { count, el, key } from './dom';
import type { GroupView } from './group_view';
import type { Messages } from './messages';
import type { Answer, Question } from './protocol';
import type { Session } from './session';

const HINT: (string | [string, string])[] = [
  'The point in the ring counts.',
  ['Enter', 'same class'],
  ['Click', 'an instance that is there'],
  ['⇧Space', 'skip'],
  ['Esc', 'leave'],
];

export class Questions {
  current: Question | null = null;
  /** Shown when there is nothing left to ask. */
  readonly done = el('section', { class: 'card docked done', 'aria-label': 'No question left', hidden: true });
  /** The last one skipped: the next comes after it. */
  private skipped: number | null = null;
  private running = 0;
  private loading = false;

  constructor(
    private actions: Actions,
    private asking: Asking,
    private session: Session,
    private groups: GroupView,
    private messages: Messages,
    private lookForDoubt: () => void,
  ) {}

  get busy(): boolean {
    return this.loading;
  }

  /** The next question, from the largest group on. */
  async start(): Promise<void> {
    if (!this.actions.may()) return;
    if (!this.current) this.skipped = null;
    await this.ask();
  }

  /** Leaves this one for later. */
  async skip(): Promise<void> {
    if (!this.actions.may()) return;
    if (this.current) this.skipped = this.current.seed;
    await this.ask();
  }

  leave(): void {
    this.running++;
    this.loading = false;
    this.current = null;
    this.done.hidden = true;
    this.groups.clear();
  }

  private async ask(): Promise<void> {
    const run = ++this.running;
    this.loading = true;
    this.done.hidden = true;
    // What was skipped and is answered since does not tell where to go on.
    if (this.skipped !== null && this.session.seeds.get(this.skipped)?.label !== null) this.skipped = null;
    let message = await this.actions.ask({ ask: 'question', after: this.skipped });
    if (run !== this.running) return;
    if (message && message.header.question === null && this.skipped !== null) {
      this.skipped = null;
      message = await this.actions.ask({ ask: 'question', after: null });
      if (run !== this.running) return;
      if (message?.header.question) this.messages.note('Back to the first of the skipped questions.');
    }
    this.loading = false;
    if (!message) return;
    const question = message.header.question as Question | null;
    if (question) this.show(question, message.header.left as number, message.arrays.places as Uint32Array);
    else this.showDone();
  }

  private show(question: Question, left: number, places: Uint32Array): void {
    this.current = question;
    const group = places.length > 0 ? places : Uint32Array.of(question.place);
    const cut = this.groups.show(group, { card: true }, question.place);
    const more = left === 1 ? 'the last question' : `${count(left)} questions left`;
    this.asking.open({
      kind: 'question',
      title: 'What is this?',
      context: `${count(question.size)} points · ${more}${cut ? ' · the cut is off for this one' : ''}`,
      place: question.place,
      beside: false,
      hint: HINT,
      answer: (answer) => void this.answer(question, answer),
      cancel: () => this.leave(),
    });
  }

  private async answer(question: Question, answer: Answer): Promise<void> {
    const run = ++this.running;
    this.loading = true;
    const message = await this.actions.change({ do: 'answer', seed: question.seed, ...Actions.labelFields(answer) });
    if (run !== this.running) return;
    this.current = null;
    this.loading = false;
    if (message) await this.ask();
    else this.leave();
  }

  private showDone(): void {
    this.leave();
    const none = this.session.seeds.size === 0;
    const propose = el('button', {
      class: 'primary',
      text: 'Propose 20 more',
      title: 'New seeds where points are farthest from theirs. Their points have no label until you answer, also where they had one.',
      click: () => void this.propose(20),
    });
    const settled = this.session.questions === 0;
    this.done.replaceChildren(
      el(
        'header',
        {},
        el('h2', { text: none ? 'No questions yet' : settled ? 'All questions are answered' : 'No other question' }),
        el('span', { class: 'context', text: `${count(this.session.unlabeled)} points without a label` }),
      ),
      el('p', {
        text: 'Click wherever a label is wrong, or go to where the result is unsure.',
      }),
      el(
        'div',
        { class: 'row' },
        propose,
        el('button', { click: () => this.lookForDoubt() }, 'Next doubtful area', key('⇧U')),
        el('button', { text: 'Close', click: () => this.leave() }),
      ),
    );
    this.done.hidden = false;
    propose.focus();
    this.messages.say('No question left');
  }

  async propose(n: number): Promise<void> {
    if (await this.actions.change({ do: 'propose', seeds: n })) await this.start();
  }

  async settle(): Promise<void> {
    const n = this.session.questions;
    if (n === 0) {
      this.messages.note('There is no open question.');
      return;
    }
    this.asking.close();
    this.leave();
    if (await this.actions.change({ do: 'settle' })) {
      this.messages.note(`${count(n)} open questions taken away; their points follow the answers. Ctrl+Z brings them back.`);
    }
  }
}
