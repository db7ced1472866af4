// SPDX-License-Identifier: MIT
// Begins when the page is read: unpacks the data and shows them.
import {beginLive, type Live} from './live.js';
import {unpack} from './packed_data.js';
import {pageOf} from './runs.js';
import {Viewer} from './viewer.js';

declare global {
  interface Window {
    /** For tests, and for whoever looks under the bonnet. */
    stigView?: Viewer;
    stigLive?: Live;
  }
}

async function begin(root: HTMLElement): Promise<void> {
  const data = document.getElementById('stig-data');
  if (!data) throw new Error('the page has no data');
  const packed = await unpack(data.textContent);
  data.remove();
  const partOfReport = document.body.classList.contains('report');
  const live = document.querySelector<HTMLMetaElement>('meta[name=stig-live]');
  const page = pageOf(packed);
  if (live) window.stigLive = beginLive(root, page, Number(live.content));
  window.stigView = window.stigLive?.viewer ?? new Viewer(root, page, partOfReport);
}

const root = document.getElementById('stig-view');
if (root) {
  begin(root).catch((error: unknown) => {
    root.textContent = `This page cannot be shown: ${String(error)}`;
    console.error(error);
  });
}
