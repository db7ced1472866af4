// SPDX-License-Identifier: MIT
// Questions to the module. One worker answers them one by one; what takes too long is ended with
// the worker, and another begins.
import type {Answer, Question} from './answers.js';

interface Waiting {
  resolve: (answer: Answer) => void;
  reject: (error: Error) => void;
}

interface Reply {
  number: number;
  answer?: Answer;
  failure?: string;
}

export class Engine {
  private worker: Worker;
  private readonly waiting = new Map<number, Waiting>();
  private asked = 0;

  /** `code` of the worker, as the address of a blob; `module` as it is compiled. */
  constructor(private readonly code: string, private readonly module: Uint8Array) {
    this.worker = this.begin();
  }

  get busy(): boolean {
    return this.waiting.size > 0;
  }

  ask(question: Question): Promise<Answer> {
    const number = ++this.asked;
    return new Promise((resolve, reject) => {
      this.waiting.set(number, {resolve, reject});
      this.worker.postMessage({number, question});
    });
  }

  /** Ends what is being worked on; whoever waits for it is told so. */
  stop(): void {
    this.worker.terminate();
    this.worker = this.begin();
    const all = [...this.waiting.values()];
    this.waiting.clear();
    for (const {reject} of all) reject(new Error('stopped'));
  }

  private begin(): Worker {
    const worker = new Worker(this.code);
    worker.postMessage(this.module);
    worker.addEventListener('message', ({data}: MessageEvent<Reply>) => this.take(data));
    return worker;
  }

  private take({number, answer, failure}: Reply): void {
    const waiting = this.waiting.get(number);
    if (!waiting) return;
    this.waiting.delete(number);
    if (answer) {
      waiting.resolve(answer);
      return;
    }
    // A module that failed is not asked again.
    waiting.reject(new Error(failure ?? 'no answer'));
    this.stop();
  }
}
