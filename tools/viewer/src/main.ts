// SPDX-License-Identifier: MIT
// Begins when the page is read: unpacks the data and shows them.
import {unpack} from './packed_data.js';
import {pageOf} from './runs.js';
import {Viewer} from './viewer.js';

declare global {
  interface Window {
    /** For tests, and for whoever looks under the bonnet. */
    stigView?: Viewer;
  }
}

async function begin(root: HTMLElement): Promise<void> {
  const data = document.getElementById('stig-data');
  if (!data) throw new Error('the page has no data');
  const packed = await unpack(data.textContent);
  data.remove();
  const partOfReport = document.body.classList.contains('report');
  window.stigView = new Viewer(root, pageOf(packed), partOfReport);
}

const root = document.getElementById('stig-view');
if (root) {
  begin(root).catch((error: unknown) => {
    root.textContent = `This page cannot be shown: ${String(error)}`;
    console.error(error);
  });
}
