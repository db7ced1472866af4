// SPDX-License-Identifier: MIT
// Draws the picture of a live run in docs/viewer.md; scripts/live_picture.sh runs it.
import {spawn} from 'node:child_process';
import path from 'node:path';
import {openAddress, startBrowser, stopBrowser, until} from './browser.mjs';

const kSeconds = 3;

const [, , scene, picture] = process.argv;
const program = spawn(process.env.STIGC, ['view', '--live', scene, '--paused'],
                      {stdio: ['ignore', 'pipe', 'inherit'], cwd: path.dirname(scene)});
const address = await new Promise(found => program.stdout.once('data', data =>
  found(data.toString().trim())));
await startBrowser();
const {page, close} = await openAddress(address, {width: 1100, height: 640});
await page.getByRole('combobox', {name: 'speed', exact: true}).selectOption('1');
await page.getByRole('button', {name: 'run or pause (space)', exact: true}).click();
for (let now = 0; now < kSeconds;) {
  now = await page.evaluate(() => window.stigLive.now.time);
  await page.waitForTimeout(20);
}
await page.getByRole('button', {name: 'run or pause (space)', exact: true}).click();
await until(page, () => window.stigLive.now.mode === 'paused');
await page.evaluate(() => {
  const {run} = window.stigView.views[0];
  window.stigView.state.set({picked: {run: 0, brick: run.robots[0].bodies[0]}});
});
await page.waitForTimeout(1000);
await page.screenshot({path: picture});
await close();
await stopBrowser();
program.kill('SIGINT');
