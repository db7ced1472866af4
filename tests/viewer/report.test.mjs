// SPDX-License-Identifier: MIT
// Reports of validations, in which their runs can be played.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import {after, before, test} from 'node:test';
import {choices, folder, open, startBrowser, stigc, still, stopBrowser, until} from './browser.mjs';

const kReport = 'out/report.html';

before(async () => {
  // Too short to build anything, which is what the exit status says.
  stigc(['validate', 'rulesets/staircase.yaml', '--runs', '2', '--duration', '15', '-o', 'out'], 1);
  await startBrowser();
});
after(stopBrowser);

const scrolled = page => page.evaluate(() => scrollY);

test('a report plays its runs in place of pictures', async () => {
  const {page, close} = await open(kReport);
  assert.equal(await page.locator('img').count(), 0);
  assert.equal(await page.evaluate(() => window.stigView.page.runs.length), 2);
  assert.deepEqual([(await choices(page)).side, (await choices(page)).time], [false, 15]);
  assert.match(await page.locator('body > h1').innerText(), /complete in 0 of 2 runs/);
  await page.getByRole('button', {name: 'seed 2'}).click();
  assert.equal((await choices(page)).run, 1);
  const box = await page.locator('.stig-view').boundingBox();
  assert.ok(box.x >= 0 && box.x + box.width <= 900 && box.height > 300, 'within the window');
  await close();
});

test('each run of the report leads to its beginning in the player', async () => {
  const {page, close} = await open(kReport);
  await page.getByRole('link', {name: 'Play this run'}).nth(1).click();
  await until(page, () => window.stigView.state.now.run === 1);
  assert.equal((await choices(page)).time, 0);
  const top = await page.evaluate(
      () => document.querySelector('.stig-view').getBoundingClientRect().top);
  assert.ok(Math.abs(top) < 5, 'the player is in view');
  await page.getByRole('button', {name: 'play or pause'}).click();
  await until(page, () => window.stigView.state.now.time > 0.3);
  await page.getByRole('button', {name: 'play or pause'}).click();
  await close();
});

test('keys and wheel are the report\'s until the player is clicked', async () => {
  const {page, close} = await open(kReport);
  const camera = () => page.evaluate(() => window.stigView.viewpoint.numbers());
  const first = await camera();
  await page.keyboard.press('Home');
  assert.equal((await choices(page)).time, 15);
  const canvas = await page.locator('.stig-view canvas').boundingBox();
  await page.mouse.move(canvas.x + 100, canvas.y + 100);
  await page.mouse.wheel(0, 120);
  await until(page, () => scrollY > 50);
  assert.deepEqual(await camera(), first);
  await page.evaluate(() => scrollTo(0, 0));
  await page.mouse.click(canvas.x + 100, canvas.y + 100);
  await page.mouse.wheel(0, 120);
  await until(page, () => window.stigView.stage.frames > 1);
  await still(page);
  assert.notDeepEqual(await camera(), first);
  assert.equal(await scrolled(page), 0);
  await page.keyboard.press('Home');
  assert.equal((await choices(page)).time, 0);
  await page.keyboard.press('z');
  await still(page);
  const {width, height} = await page.locator('.stig-view').boundingBox();
  assert.deepEqual([width, height], [900, 620]);
  await page.keyboard.press('Escape');
  assert.ok((await page.locator('.stig-view').boundingBox()).height < 620);
  await close();
});

test('a report is read in the dark, and on a narrow screen', async () => {
  const {page, close} = await open(kReport, {width: 390, height: 780, dark: true});
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
  const ground = await page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  assert.ok(ground.match(/\d+/g).every(part => Number(part) < 60), ground);
  assert.equal(await page.locator('#stig-view').getAttribute('data-theme'), 'dark');
  await close();
});

test('a report is one file of moderate size', () => {
  const {size} = fs.statSync(path.join(folder, kReport));
  assert.ok(size < 1.2e6, `${size} bytes`);
  assert.doesNotMatch(fs.readFileSync(path.join(folder, kReport), 'latin1'), /(src|href)="http/);
});
