/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Colors and visibility by instance and class, as small textures that the shaders look up.
 */

import { Emitter } from './emitter';
import { LOOKUP_WIDTH, lookupTexture } from './lookup_texture';
import { UNLABELED, colorOf } from './palette';
import type { Session } from './session';

export class InstanceTable extends Emitter<{ changed: void }> {
  /** By label: color, and whether it is shown. */
  instances = lookupTexture(1);
  /** By label: color of its class. */
  classes = lookupTexture(1);
  private hidden = new Set<number>();
  private classNumbers = new Map<string, number>();

  constructor(
    private session: Pick<Session, 'instances'>,
    classNames: string[],
  ) {
    super();
    for (const name of classNames) this.classNumber(name);
  }

  /** 1 and up, in the order of the list and then of first use; 0 for no class. */
  classNumber(name: string): number {
    if (name === '') return 0;
    const known = this.classNumbers.get(name);
    if (known) return known;
    this.classNumbers.set(name, this.classNumbers.size + 1);
    return this.classNumbers.size;
  }

  isShown(label: number): boolean {
    return !this.hidden.has(label);
  }

  get anyHidden(): boolean {
    return this.hidden.size > 0;
  }

  show(label: number, shown: boolean): void {
    if (shown) this.hidden.delete(label);
    else this.hidden.add(label);
    this.refresh();
  }

  showAll(): void {
    this.hidden.clear();
    this.refresh();
  }

  /** Hides all but these; where only these are shown already, shows all. */
  isolate(labels: Set<number>): void {
    const others = [0, ...this.session.instances.keys()].filter((label) => !labels.has(label));
    const already = others.every((label) => this.hidden.has(label)) && [...labels].every((l) => this.isShown(l));
    this.hidden = new Set(already ? [] : others);
    this.refresh();
  }

  refresh(): void {
    // A deleted instance must not stay hidden: an undo brings it back to be seen.
    for (const label of this.hidden) if (label && !this.session.instances.has(label)) this.hidden.delete(label);
    let most = 0;
    for (const label of this.session.instances.keys()) most = Math.max(most, label);
    const rows = Math.ceil((most + 1) / LOOKUP_WIDTH);
    if (rows > this.instances.image.height) {
      this.instances.dispose();
      this.classes.dispose();
      this.instances = lookupTexture(2 * rows);
      this.classes = lookupTexture(2 * rows);
    }
    const [colors, classes] = [this.instances.image.data, this.classes.image.data] as Uint8Array[];
    colors.fill(255);
    colors.set([...UNLABELED, this.isShown(0) ? 255 : 0], 0);
    classes.set([...UNLABELED, 255], 0);
    for (const instance of this.session.instances.values()) {
      const at = 4 * instance.label;
      colors.set([...colorOf(instance.label), this.isShown(instance.label) ? 255 : 0], at);
      const number = this.classNumber(instance.class);
      classes.set([...(number ? colorOf(number) : ([150, 150, 150] as const)), 255], at);
    }
    this.instances.needsUpdate = this.classes.needsUpdate = true;
    this.emit('changed', undefined);
  }
}
