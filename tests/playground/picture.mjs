// SPDX-License-Identifier: MIT
// Draws the picture of docs/playground.md; scripts/playground_picture.sh runs it.
import fs from 'node:fs';
import path from 'node:path';
import {folder, open, startBrowser, still, stopBrowser} from './browser.mjs';

const kMistake = 'lattice: cubick';

fs.copyFileSync(path.join(process.env.PLAYGROUND, 'playground.html'),
                path.join(folder, 'playground.html'));
await startBrowser();
const {page, close} = await open('playground.html', {width: 1100, height: 640});
await page.locator('select[aria-label="start from"]').selectOption('order-dependent.yaml');
await page.waitForTimeout(2000);
await page.getByRole('button', {name: 'Verify', exact: true}).click();
await page.locator('.labels b').nth(1).waitFor();
await page.evaluate(wanted => {
  const {editor} = window.stigPlayground;
  const at = editor.state.doc.toString().indexOf('lattice: cubic');
  editor.dispatch({changes: {from: at, to: at + 14, insert: wanted}, selection: {anchor: at}});
  editor.scrollDOM.scrollTop = editor.lineBlockAt(at).top - 120;
}, kMistake);
await page.locator('.message').first().waitFor();
await still(page);
await page.screenshot({path: process.argv[2]});
await close();
await stopBrowser();
