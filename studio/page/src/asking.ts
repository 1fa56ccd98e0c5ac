/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The one open card that asks for a class, where it stands, and picking an instance for it.
 */

import { ClassInput } from './class_input';
import type { NearInstance } from './class_input';
import { el, metres } from './dom';
import { Emitter } from './emitter';
import type { InstanceTable } from './instance_table';
import type { Messages } from './messages';
import { colorOf } from './palette';
import type { Picking } from './picking';
import type { PointCloudView } from './point_cloud_view';
import type { Answer } from './protocol';
import type { Session } from './session';

export interface Asked {
  kind: 'question' | 'point' | 'lasso';
  title: string;
  context: string;
  /** What it is about, for the ring around it and the list of near instances. */
  place: number;
  /** Beside the place instead of at the lower edge. */
  beside: boolean;
  hint: (string | [string, string])[];
  answer: (answer: Answer) => void;
  cancel: () => void;
}

const MOST_NEAR = 6;

export class Asking extends Emitter<{ closed: Asked; opened: Asked }> {
  current: Asked | null = null;
  picking = false;
  private card: ClassInput | null = null;
  private ring = el('div', { class: 'ring', hidden: true });
  private lastClass: string | null = null;

  constructor(
    private area: HTMLElement,
    private view: PointCloudView,
    private session: Session,
    private table: InstanceTable,
    private pickingOf: Picking,
    private messages: Messages,
    private listed: string[],
    private heightAt: (place: number) => number,
  ) {
    super();
    area.append(this.ring);
    view.on('frame', () => this.follow());
    // After a turn of the view the keys belong to it, but digits and letters are meant for the card.
    view.canvas.addEventListener('keydown', (event) => {
      if (this.card?.digit(event)) event.preventDefault();
      else if (this.card?.letter(event)) event.stopPropagation();
    });
  }

  /** The classes of the list, in the order of their digits, then those that came by typing. */
  get classes(): string[] {
    const all = new Set(this.listed);
    for (const instance of this.session.instances.values()) if (instance.class) all.add(instance.class);
    return [...all];
  }

  open(asked: Asked): void {
    this.close();
    this.current = asked;
    this.picking = false;
    const all = this.nearInstances(asked.place);
    this.card = new ClassInput({
      title: asked.title,
      // From above, a seat and the floor beneath it look alike.
      context: asked.kind === 'lasso' ? asked.context : `${asked.context} · ${metres(this.heightAt(asked.place))} up`,
      classes: this.classes,
      classColor: (name) => colorOf(this.table.classNumber(name)),
      lastClass: this.lastClass,
      near: all.slice(0, asked.beside ? MOST_NEAR : 4),
      all,
      hint: asked.hint,
      answer: (answer) => this.answer(answer),
      cancel: () => this.cancel(),
      pick: () => this.togglePicking(),
    });
    this.card.element.classList.add(asked.beside ? 'beside' : 'docked', asked.kind);
    this.area.append(this.card.element);
    this.card.focus();
    this.messages.say(`${asked.title} ${asked.context}`);
    this.follow();
    this.emit('opened', asked);
  }

  answer(answer: Answer): void {
    const asked = this.current;
    if (!asked) return;
    if ('class' in answer) this.lastClass = answer.class;
    this.close();
    asked.answer(answer);
  }

  cancel(): void {
    const asked = this.current;
    if (this.picking) this.togglePicking();
    else {
      this.close();
      asked?.cancel();
    }
  }

  close(): void {
    const asked = this.current;
    this.card?.element.remove();
    this.card = null;
    this.current = null;
    this.ring.hidden = true;
    this.setPicking(false);
    if (asked) {
      // The focus goes where the keys of the view work.
      this.view.canvas.focus({ preventScroll: true });
      this.emit('closed', asked);
    }
  }

  focus(): void {
    this.card?.focus();
  }

  togglePicking(): void {
    if (this.card) this.setPicking(!this.picking);
  }

  private setPicking(on: boolean): void {
    this.picking = on;
    if (this.card) this.card.picking = on;
    this.area.classList.toggle('pick-instance', on);
  }

  /** A click on a place while the card is open; true: the click was for the card. */
  clicked(place: number, eyedropper: boolean): boolean {
    const asked = this.current;
    if (!asked) return false;
    if (asked.kind === 'point' && !this.picking && !eyedropper) return false;
    const label = this.session.labels[place];
    if (label === 0) this.messages.note('That point has no label yet: pick one of an instance, or give a class.');
    else this.answer({ label });
    return true;
  }

  private nearInstances(place: number): NearInstance[] {
    const { positions } = this.view.cloud;
    const best = new Map<number, number>();
    for (const label of this.session.instances.keys()) best.set(label, Infinity);
    for (const seed of this.session.seeds.values()) {
      if (!seed.label) continue;
      let d = 0;
      for (let k = 0; k < 3; k++) d += (positions[3 * seed.place + k] - positions[3 * place + k]) ** 2;
      if (d < (best.get(seed.label) ?? Infinity)) best.set(seed.label, d);
    }
    return [...best]
      .sort((a, b) => a[1] - b[1] || a[0] - b[0])
      .map(([label]) => ({
        label,
        name: this.session.nameOf(label),
        className: this.session.instances.get(label)?.class ?? '',
        color: colorOf(label),
      }));
  }

  /** Keeps the ring and a card beside a place where the place is. */
  private follow(): void {
    const asked = this.current;
    if (!asked || !this.card) return;
    const at = this.pickingOf.project(asked.place);
    const { x: width, y: height } = this.view.size;
    const inside = at !== null && at.x >= 0 && at.y >= 0 && at.x <= width && at.y <= height;
    this.ring.hidden = !inside || asked.kind === 'lasso';
    if (at && inside) {
      this.ring.style.transform = `translate(${at.x.toFixed(1)}px, ${at.y.toFixed(1)}px)`;
    }
    if (!asked.beside) return;
    const card = this.card.element;
    const [w, h] = [card.offsetWidth, card.offsetHeight];
    const [px, py] = at ? [at.x, at.y] : [width / 2, height / 2];
    const left = px + 28 + w < width ? px + 28 : px - 28 - w;
    card.style.left = `${Math.round(Math.min(Math.max(8, left), width - w - 8))}px`;
    card.style.top = `${Math.round(Math.min(Math.max(8, py - 40), height - h - 8))}px`;
  }
}
