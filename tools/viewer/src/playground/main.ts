// SPDX-License-Identifier: MIT
// Begins when the page is read: unpacks the module and hands it to a worker.
import {bytesOfBase64, inflated} from '../packed_data.js';
import {Engine} from './engine.js';
import {taken, type Shipped} from './files.js';
import {OwnPage} from './own_page.js';
import {Playground} from './playground.js';

declare global {
  interface Window {
    /** For tests, and for whoever looks under the bonnet. */
    stigPlayground?: Playground;
  }
}

async function begin(root: HTMLElement): Promise<void> {
  const page = new OwnPage();
  const shipped = JSON.parse(taken('stig-files')) as Shipped;
  const worker = new Blob([taken('stig-worker')], {type: 'text/javascript'});
  const module = await inflated(bytesOfBase64(taken('stig-module')));
  const playground = new Playground(root, new Engine(URL.createObjectURL(worker), module), shipped,
                                    page);
  window.stigPlayground = playground;
  await playground.begin();
}

const root = document.getElementById('stig-playground');
if (root) {
  begin(root).catch((error: unknown) => {
    root.textContent = `This page cannot be shown: ${String(error)}`;
    console.error(error);
  });
}
