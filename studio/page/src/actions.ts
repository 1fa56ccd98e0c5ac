/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What the person does to the session, and what is asked of the server: errors end here as sentences.
 */

import { Cancelled, Disconnected } from './connection';
import type { Connection } from './connection';
import type { Messages } from './messages';
import type { Answer, Arrays, Header, Message } from './protocol';
import type { Session } from './session';

export class Actions {
  constructor(
    private connection: Connection,
    private session: Session,
    private messages: Messages,
  ) {}

  /** Whether this page may change the session now; if not, says why. */
  may(): boolean {
    if (!this.connection.isOpen || !this.session.ready) {
      this.messages.error('The server is not there. The last action was not taken; do it again when it is back.');
      return false;
    }
    if (!this.session.writer) {
      this.messages.note('Another tab is working on this scan; this one looks on.');
      return false;
    }
    return true;
  }

  async change(header: Header, arrays: Arrays = {}): Promise<Message | null> {
    if (!this.may()) return null;
    return this.send(header, arrays);
  }

  ask(header: Header): Promise<Message | null> {
    if (!this.connection.isOpen) return Promise.resolve(null);
    return this.send(header, {});
  }

  /** Asks until there is an answer: what a change cancelled is asked again. */
  async insist(header: Header): Promise<Message | null> {
    for (;;) {
      if (!this.connection.isOpen) return null;
      try {
        return await this.connection.request(header);
      } catch (error) {
        if (error instanceof Cancelled) continue;
        this.tell(error, header);
        return null;
      }
    }
  }

  private async send(header: Header, arrays: Arrays): Promise<Message | null> {
    try {
      return await this.connection.request(header, arrays);
    } catch (error) {
      if (!(error instanceof Cancelled)) this.tell(error, header);
      return null;
    }
  }

  private tell(error: unknown, header: Header): void {
    if (!(error instanceof Disconnected)) {
      this.messages.error(error instanceof Error ? error.message : String(error));
    } else if ('do' in header) {
      // What changed nothing can simply be asked again.
      this.messages.error('The connection broke before the server answered. Look whether the last action was taken.');
    }
  }

  /** The fields for a label or a new instance. */
  static labelFields(answer: Answer): Header {
    return 'class' in answer ? { class: answer.class } : { label: answer.label };
  }
}
