/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What the person does to the parts, and which of them is selected.
 */

import type { Actions } from './actions';
import type { Camera } from './camera';
import { count, metres } from './dom';
import { Emitter } from './emitter';
import type { Messages } from './messages';
import type { PartsState } from './parts_state';
import type { Part } from './protocol';
import type { PointCloudView } from './point_cloud_view';
import { chooseViewPoint } from './view_points';

export class PartsWork extends Emitter<{ changed: void }> {
  /** Numbers of parts: the one that is selected, and the one to join with it. */
  selected: number | null = null;
  second: number | null = null;
  /** The next click chooses the other one. */
  joining = false;
  decomposing = false;
  /** How many parts the person wants, until they are there. */
  private wanted: number | null = null;

  constructor(
    private state: PartsState,
    private actions: Actions,
    private view: PointCloudView,
    private camera: Camera,
    private diagonal: number,
    private messages: Messages,
    private isDrawn: (place: number) => boolean,
  ) {
    super();
    state.on('changed', () => this.forgetWhatIsGone());
  }

  get selectedPart(): Part | null {
    return this.state.part(this.selected);
  }

  get secondPart(): Part | null {
    return this.state.part(this.second);
  }

  /** Whether the number of parts is about to be another. */
  get isCutting(): boolean {
    return this.wanted !== null;
  }

  private forgetWhatIsGone(): void {
    if (!this.selectedPart) this.selected = this.second = null;
    if (!this.secondPart) this.second = null;
    if (!this.selectedPart) this.joining = false;
    this.emit('changed', undefined);
  }

  select(part: Part | null): void {
    this.selected = part?.part ?? null;
    this.second = null;
    this.joining = false;
    this.emit('changed', undefined);
  }

  /** The other one to join, or none when it is taken again. */
  selectSecond(part: Part): void {
    if (!this.selectedPart) this.select(part);
    else if (part.part !== this.selected) this.second = this.second === part.part ? null : part.part;
    this.emit('changed', undefined);
  }

  /** A click on a part, in the picture or in the list. */
  async clicked(part: Part | null, add: boolean): Promise<void> {
    if (this.joining && part && part.part !== this.selected) {
      this.selectSecond(part);
      await this.join();
    } else if (add && part) this.selectSecond(part);
    else this.select(part);
  }

  async decompose(groups: number): Promise<void> {
    if (this.decomposing || !this.actions.may()) return;
    this.setDecomposing(true);
    const done = await this.actions.change({ do: 'decompose', groups });
    this.setDecomposing(false);
    if (done) this.messages.note(`${count(groups)} groups. Split what fits badly, join what belongs together; Ctrl+Z takes it back.`);
  }

  private setDecomposing(on: boolean): void {
    this.decomposing = on;
    this.emit('changed', undefined);
  }

  /** The newest wish goes out when the last answer is there; those between are dropped. */
  async cut(parts: number): Promise<void> {
    if (this.state.groups === 0) return;
    const isUnderWay = this.wanted !== null;
    this.wanted = Math.min(this.state.groups, Math.max(1, Math.round(parts)));
    if (isUnderWay) return;
    let sent: number | null = null;
    while (sent !== this.wanted) {
      sent = this.wanted;
      await this.actions.change({ do: 'cut', parts: sent });
    }
    this.wanted = null;
    this.emit('changed', undefined);
  }

  /** One part more or less than there are, or than are on their way. */
  async cutBy(step: 1 | -1): Promise<void> {
    await this.cut((this.wanted ?? this.state.list.length) + step);
  }

  async split(): Promise<void> {
    const part = this.needsSelected('to split it');
    if (!part) return;
    if (!part.splits) {
      this.messages.note('That part is one group: decompose into more groups to divide it.');
      return;
    }
    await this.actions.change({ do: 'split', part: part.part });
  }

  async join(): Promise<void> {
    const part = this.needsSelected('to join it with another');
    if (!part) return;
    if (this.second === null) {
      this.joining = !this.joining;
      this.emit('changed', undefined);
      return;
    }
    const other = this.second;
    this.joining = false;
    if (await this.actions.change({ do: 'join', part: part.part, with: other })) this.select(this.state.part(Math.min(part.part, other)));
  }

  async toggleDropped(): Promise<void> {
    const part = this.needsSelected('to drop it');
    if (part) await this.actions.change({ do: part.dropped ? 'keep' : 'drop', part: part.part });
  }

  async toggleExact(): Promise<void> {
    const part = this.needsSelected('to make its hull exact');
    if (part) await this.actions.change({ do: 'exact', part: part.part, exact: !part.exact });
  }

  async step(what: 'undo' | 'redo'): Promise<void> {
    if (this.state[what] === 0) this.messages.note(`There is nothing to ${what} in the parts.`);
    else await this.actions.change({ do: `${what} parts` });
  }

  private needsSelected(why: string): Part | null {
    const part = this.selectedPart;
    if (!part) this.messages.note(`Select a part ${why}: click it in the picture or in the list.`);
    return part;
  }

  /** Flies to a part. */
  focus(part: Part): void {
    const places = this.state.placesOf(part);
    if (places.length === 0) return;
    const { target, direction, distance } = chooseViewPoint(this.view, this.camera, places, this.diagonal, this.isDrawn);
    void this.camera.lookFrom(target, direction, distance);
  }

  /** The next merge of the tree, in words. */
  costText(parts: number): string {
    const cost = this.state.costOfMerge(parts);
    return cost === null ? 'All groups are one part' : `The next merge costs ${metres(cost)}`;
  }
}
