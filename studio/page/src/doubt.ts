/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Where the result is unsure, largest area first.
 */

import type { Actions } from './actions';
import type { ColorModes } from './color_modes';
import { count, metres } from './dom';
import type { GroupView } from './group_view';
import type { Messages } from './messages';
import type { Session } from './session';

export class Doubt {
  private skip = 0;
  private revision = -1;

  constructor(
    private session: Session,
    private actions: Actions,
    private colors: ColorModes,
    private groups: GroupView,
    private messages: Messages,
  ) {}

  /** How many areas were shown since the last change: the next one is smaller. */
  private seen(): number {
    this.skip = this.revision === this.session.revision ? this.skip + 1 : 0;
    this.revision = this.session.revision;
    return this.skip;
  }

  async next(): Promise<void> {
    if (this.colors.mode !== 'doubt') this.colors.set('doubt');
    // The limit follows the values of this scan.
    await this.colors.loadDoubt();
    const below = this.colors.doubtBelow;
    const message = await this.actions.ask({ ask: 'doubtful', below, skip: this.seen() });
    if (!message) return;
    const place = message.header.place as number | null;
    if (place === null) {
      this.messages.note(this.skip > 0 ? 'That was the last doubtful area; the next is the largest again.' : 'There is no doubtful area.');
      this.skip = -1;
      return;
    }
    const found = message.arrays.places as Uint32Array | undefined;
    const places = found && found.length > 0 ? found : Uint32Array.of(place);
    this.groups.show(places, { pull: 2.2 });
    this.messages.note(`${count(places.length)} points with less than ${metres(below)} between the two nearest labels. Click the one that is wrong.`);
  }
}
