// SPDX-License-Identifier: MIT
// Beside the page, so that it stays awake while the module works: the first message is the module,
// every other a question.
import {startModule, type Ask} from './module.js';
import {yamlEvents} from './yaml_events.js';

interface Asked {
  number: number;
  question: Record<string, unknown>;
}

let ask: Promise<Ask> | null = null;

async function reply(asked: Asked): Promise<void> {
  try {
    const answer = (await ask)?.(asked.question);
    postMessage({number: asked.number, answer});
  } catch (error) {
    postMessage({number: asked.number, failure: String(error)});
  }
}

addEventListener('message', ({data}: MessageEvent<Uint8Array<ArrayBuffer> | Asked>) => {
  if (data instanceof Uint8Array) ask = startModule(data, yamlEvents);
  else void reply(data);
});
