/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The socket to the server: requests and their answers, and coming back by itself after a break.
 */

import { Emitter } from './emitter';
import { decodeFrame, encodeFrame } from './frame';
import type { Arrays, Header, Message } from './protocol';

/** The server said no, in a sentence for the person. */
export class Refused extends Error {}
/** The server gave a question up because something newer came. */
export class Cancelled extends Error {}
/** There is no connection, or it broke before the answer came. */
export class Disconnected extends Error {}

interface Pending {
  resolve: (message: Message) => void;
  reject: (error: Error) => void;
  changes: boolean;
}

interface Events {
  connected: void;
  disconnected: { lostChange: boolean };
  /** The program was started again, with another address: this page cannot come back. */
  replaced: void;
  session: Message;
  parts: Message;
  progress: number | null;
}

const FIRST_WAIT = 300;
const LONGEST_WAIT = 5000;

export class Connection extends Emitter<Events> {
  private socket: WebSocket | null = null;
  private pending = new Map<number, Pending>();
  private nextId = 1;
  private wait = FIRST_WAIT;
  isOpen = false;

  constructor(private url: string) {
    super();
  }

  get waiting(): number {
    return this.pending.size;
  }

  open(): void {
    const socket = new WebSocket(this.url);
    socket.binaryType = 'arraybuffer';
    this.socket = socket;
    socket.addEventListener('message', (event) => this.receive(decodeFrame(event.data)));
    socket.addEventListener('close', () => this.closed());
    socket.addEventListener('open', () => {
      // Only after the whole state is here do other requests make sense again.
      this.isOpen = true;
      this.request({ ask: 'state' }).then(
        () => {
          this.wait = FIRST_WAIT;
          this.emit('connected', undefined);
        },
        () => socket.close(),
      );
    });
  }

  request(header: Header, arrays: Arrays = {}): Promise<Message> {
    const socket = this.socket;
    if (!this.isOpen || !socket) {
      return Promise.reject(new Disconnected('The server is not there: this was not done.'));
    }
    const id = this.nextId++;
    return new Promise((resolve, reject) => {
      this.pending.set(id, { resolve, reject, changes: 'do' in header });
      socket.send(encodeFrame({ ...header, id }, arrays));
    });
  }

  private receive(message: Message): void {
    const { header } = message;
    if (header.event === 'progress') {
      this.emit('progress', header.share as number);
      return;
    }
    if (header.event === 'changed' || header.event === 'parts') {
      this.tell(message);
      return;
    }
    const pending = this.pending.get(header.id as number);
    if (!pending) return;
    this.pending.delete(header.id as number);
    this.emit('progress', null);
    if (header.ok === true) {
      this.tell(message);
      pending.resolve(message);
    } else if (header.error === 'cancelled') {
      pending.reject(new Cancelled('cancelled'));
    } else {
      pending.reject(new Refused(String(header.error)));
    }
  }

  /** Labels and parts have states of their own. */
  private tell(message: Message): void {
    if ('parts' in message.header) this.emit('parts', message);
    else if ('revision' in message.header) this.emit('session', message);
  }

  private closed(): void {
    this.isOpen = false;
    const pending = [...this.pending.values()];
    this.pending.clear();
    const lostChange = pending.some((one) => one.changes);
    this.emit('progress', null);
    this.emit('disconnected', { lostChange });
    for (const one of pending) {
      one.reject(new Disconnected('The connection broke before the server answered.'));
    }
    this.comeBackLater();
  }

  private comeBackLater(): void {
    window.setTimeout(() => void this.comeBack(), this.wait);
    this.wait = Math.min(this.wait * 1.7, LONGEST_WAIT);
  }

  /** A socket that is refused does not tell why, so the server is asked first. */
  private async comeBack(): Promise<void> {
    const answer = await fetch('/api/scan', { method: 'HEAD' }).catch(() => null);
    if (answer?.ok) this.open();
    else if (answer?.status === 401) this.emit('replaced', undefined);
    else this.comeBackLater();
  }
}
