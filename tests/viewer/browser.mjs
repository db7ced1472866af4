// SPDX-License-Identifier: MIT
// What the tests of pages share: making them with stigc, and opening them in headless Chromium.
import assert from 'node:assert/strict';
import {spawnSync} from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import {chromium} from 'playwright-core';

export const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'stig-viewer-'));
process.on('exit', () => fs.rmSync(folder, {recursive: true, force: true}));

/** Runs stigc in the folder of the tests; returns what it said. */
export function stigc(args, expected = 0) {
  const done = spawnSync(process.env.STIGC, args, {cwd: folder, encoding: 'utf8'});
  assert.equal(done.status, expected, `stigc ${args.join(' ')}: ${done.stderr}`);
  return done.stdout;
}

const kPatience = 180_000;  // ms: a machine may have much else to do

let browser = null;

export async function startBrowser() {
  // Tests may run as root, and where there is nothing but a processor to draw.
  browser = await chromium.launch({
    executablePath: process.env.BROWSER,
    timeout: kPatience,
    args: ['--no-sandbox', '--enable-unsafe-swiftshader', '--use-angle=swiftshader'],
  });
}

export async function stopBrowser() {
  await browser?.close();
}

/** Opens a page, and holds it to saying nothing on the console and asking nothing of any network. */
export async function open(name, given = {}) {
  // What a page makes itself, it asks nobody for.
  const address = `file://${path.join(folder, name)}`;
  return openAt(address, given, url => url.split('#')[0] === address || url.startsWith('blob:'));
}

/** Likewise one that is served, which may ask its server and nobody else. */
export async function openAddress(address, given = {}) {
  const {origin} = new URL(address);
  return openAt(address, given, url => new URL(url).origin === origin || url === 'data:,');
}

async function openAt(address, {width = 900, height = 620, dark = false, hash = ''}, mayAsk) {
  const context = await browser.newContext(
      {viewport: {width, height}, colorScheme: dark ? 'dark' : 'light'});
  const page = await context.newPage();
  page.setDefaultTimeout(kPatience);
  const problems = [];
  page.on('console', message => {
    // The driver's own remarks on speed are not the page's.
    if (!message.text().includes('GL Driver Message')) problems.push(message.text());
  });
  page.on('pageerror', error => problems.push(error.message));
  page.on('request', request => {
    if (!mayAsk(request.url())) problems.push(`request: ${request.url()}`);
  });
  await page.goto(address + hash);
  await until(page, () => window.stigView?.stage.frames > 0);
  return {
    page,
    close: async () => {
      // A page that is served may go on for ever.
      if (address.startsWith('file:')) await still(page);
      assert.deepEqual(problems, []);
      await context.close();
    },
  };
}

/** Waits until a function is true in the page. The page's policy forbids the driver's own way. */
export async function until(page, wanted, given) {
  for (let tries = 0; !await page.evaluate(wanted, given); ++tries) {
    assert.ok(tries < kPatience / 50, `never came true: ${wanted}`);
    await page.waitForTimeout(50);
  }
}

/** Waits until no frame has been drawn for half a second, and none is asked for. */
export async function still(page) {
  for (let last = -1, tries = 0;; ++tries) {
    assert.ok(tries < kPatience / 500, 'never still');
    const [frames, asked] = await page.evaluate(
        () => [window.stigView.stage.frames, window.stigView.stage.asked]);
    if (frames === last && !asked) return;
    last = frames;
    await page.waitForTimeout(500);
  }
}

export const choices = page => page.evaluate(() => window.stigView.state.now);

/** Where on the page the upper face of a brick is drawn, when its run is the only one shown. */
export function placeOf(page, brick, run = 0) {
  return page.evaluate(([number, which]) => {
    const {views, viewpoint, stage} = window.stigView;
    const {camera} = viewpoint;
    const centres = views[which].run.bricks.centres;
    camera.updateMatrixWorld();
    const at = camera.position.clone().fromArray(centres, 3 * number);
    at.z += 0.5;
    at.project(camera);
    const box = stage.canvas.getBoundingClientRect();
    return {x: box.left + (at.x + 1) / 2 * box.width, y: box.top + (1 - at.y) / 2 * box.height};
  }, [brick, run]);
}

/** Red, green and blue at a place of the page, as drawn. */
export function pixelAt(page, {x, y}) {
  return page.evaluate(([left, top]) => {
    const {canvas} = window.stigView.stage;
    const box = canvas.getBoundingClientRect();
    const copy = document.createElement('canvas');
    [copy.width, copy.height] = [canvas.width, canvas.height];
    const context = copy.getContext('2d');
    context.drawImage(canvas, 0, 0);
    const scale = canvas.width / box.width;
    return [...context.getImageData((left - box.left) * scale, (top - box.top) * scale, 1, 1).data]
        .slice(0, 3);
  }, [x, y]);
}
