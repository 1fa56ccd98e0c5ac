/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What the page is for at the moment: labels, or parts for collisions.
 */

import { Emitter } from './emitter';

export type WorkMode = 'labels' | 'parts';

const HASH = '#parts';

/** The address keeps the mode, so that a page that is loaded again opens in it. */
export class Modes extends Emitter<{ changed: WorkMode }> {
  current: WorkMode = 'labels';

  get isParts(): boolean {
    return this.current === 'parts';
  }

  /** The mode that the address asks for. */
  get wanted(): WorkMode {
    return location.hash === HASH ? 'parts' : 'labels';
  }

  set(mode: WorkMode): void {
    if (mode === this.current) return;
    this.current = mode;
    history.replaceState(null, '', mode === 'parts' ? HASH : location.pathname);
    this.emit('changed', mode);
  }

  toggle(): void {
    this.set(this.isParts ? 'labels' : 'parts');
  }
}
