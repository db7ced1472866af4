// SPDX-License-Identifier: MIT
// Runs held against a target and against each other, and planes that cut.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import {after, before, test} from 'node:test';
import {choices, folder, open, startBrowser, stigc, still, stopBrowser} from './browser.mjs';

const write = (name, text) => fs.writeFileSync(path.join(folder, name), text);

before(async () => {
  const pyramid = ['explore', 'rulesets/stepped-pyramid.yaml'];
  stigc([...pyramid, '-o', 'all.txt']);
  stigc([...pyramid, '--deposits', '6', '--trace', 'some.stigt']);
  stigc(['view', 'some.stigt', '--target', 'all.txt', '-o', 'some.html']);
  // An L of four cells beside three that are an L turned by a quarter.
  write('part.json', JSON.stringify({
    stigc_structure: 1, lattice: 'cubic', bricks: [{symbol: 'a', name: 'a', color: '#112233'}],
    cells: [[5, 5, 0, 1], [5, 6, 0, 1], [5, 7, 0, 1]],
  }));
  write('l.txt', 'a .\na .\na a\n');
  stigc(['view', 'part.json', '--target', 'l.txt', '-o', 'l.html']);
  write('three.yaml', `stigc_scene: 1
blocks:
  - {at: [0.2, 0.1, 0.0275], fixed: true}
  - {at: [0.255, 0.1, 0.0275], fixed: true}
  - {at: [0.255, 0.1, 0.0825], fixed: true}
  - {at: [-0.3, 0.1, 0.0275], name: loose}
`);
  write('four.txt', 'a a\n. .\n---\na a\n. .\n');
  stigc(['simulate', 'three.yaml', '--duration', '0.4', '--trace', 'three.stigp']);
  stigc(['view', 'three.stigp', '--target', 'four.txt', '-o', 'three.html']);
  write('fall.yaml', `stigc_scene: 1
blocks:
  - {grid: [2, 2, 3], at: [0, 0, 0.1], tumble: 20, jitter: 0.004}
`);
  for (const seed of ['1', '2']) {
    stigc(['simulate', 'fall.yaml', '--duration', '0.5', '--seed', seed, '--trace',
           `seed-${seed}.stigp`]);
  }
  stigc(['view', 'seed-1.stigp', 'seed-2.stigp', '-o', 'seeds.html']);
  fs.copyFileSync(path.join(folder, 'seed-1.stigp'), path.join(folder, 'again.stigp'));
  stigc(['view', 'seed-1.stigp', 'again.stigp', '-o', 'same.html']);
  await startBrowser();
});
after(stopBrowser);

const faces = (page, which) => page.evaluate(
    name => window.stigView.views[0][name].count, which);
const targetText = page => page.locator('.target').innerText();

test('what is missing of a target stands as a ghost, and is counted', async () => {
  const {page, close} = await open('some.html');
  await still(page);
  assert.match(await targetText(page), /there\s+7 of 15\s+not in it\s+0/);
  const missing = await faces(page, 'missing');
  assert.ok(missing > 0);
  await page.keyboard.press('Home');
  await still(page);
  assert.match(await targetText(page), /there\s+1 of 15/);
  assert.ok(await faces(page, 'missing') > missing, 'more is missing at first');
  await page.keyboard.press('0');
  await still(page);
  assert.equal(await faces(page, 'missing'), 0);
  await close();
});

test('a target that is nowhere is turned and laid upon what is there', async () => {
  const {page, close} = await open('l.html');
  await still(page);
  assert.match(await targetText(page), /there\s+3 of 4\s+not in it\s+0/);
  await close();
});

test('a target is laid upon the blocks of a physical run', async () => {
  const {page, close} = await open('three.html');
  await still(page);
  assert.match(await targetText(page), /there\s+3 of 4/);
  const places = await page.evaluate(() => window.stigView.views[0].missing.object.children
      .filter(mesh => mesh.visible).map(mesh => mesh.position.toArray()));
  assert.equal(places.length, 1);
  places[0].forEach((value, i) => assert.ok(Math.abs(value - [0.2, 0.1, 0.0825][i]) < 1e-3,
                                            places[0].join()));
  await close();
});

test('a plane leaves out whole bricks of a lattice, and cuts bodies', async () => {
  const {page, close} = await open('some.html');
  const shown = () => page.evaluate(
      () => window.stigView.views[0].visible.reduce((sum, one) => sum + one, 0));
  await still(page);
  assert.equal(await shown(), 7);
  for (let i = 0; i < 5; ++i) await page.keyboard.press('q');
  assert.equal((await choices(page)).cut, '+z');
  for (let i = 0; i < 5; ++i) await page.keyboard.press('}');
  await still(page);
  assert.equal(await shown(), 4, 'the lowest level is left');
  await page.locator('.cut select').selectOption('none');
  await still(page);
  assert.equal(await shown(), 7);
  await close();
  const poses = await open('three.html', {hash: '#cut=-x&cutat=0.75'});
  await still(poses.page);
  const planes = await poses.page.evaluate(
      () => window.stigView.stage.renderer.clippingPlanes.map(
          ({normal, constant}) => [...normal.toArray(), constant]));
  assert.equal(planes.length, 1);
  assert.deepEqual(planes[0].slice(0, 3), [1, 0, 0]);
  assert.ok(planes[0][3] < 0, 'right of the middle');
  await poses.close();
});

test('physical runs are told apart body by body', async () => {
  const {page, close} = await open('seeds.html');
  assert.match(await page.locator('.labels').innerText(), /differs from 0\.0 s on/);
  await page.keyboard.press('d');
  await still(page);
  assert.ok(await page.evaluate(() => window.stigView.views[0].ways.visible));
  await close();
  const same = await open('same.html');
  assert.doesNotMatch(await same.page.locator('.labels').innerText(), /differs/);
  await same.page.keyboard.press('d');
  await still(same.page);
  const [greyed, bodies] = await same.page.evaluate(() => {
    const [view] = window.stigView.views;
    return [view.greyed.size, view.meshes.filter(mesh => mesh).length];
  });
  assert.equal(greyed, bodies);
  await same.page.keyboard.press('d');
  await still(same.page);
  assert.equal(await same.page.evaluate(() => window.stigView.views[0].greyed.size), 0);
  await same.close();
});

test('a long title does not make a narrow page wider', async () => {
  const {page, close} = await open('some.html', {width: 390, height: 780});
  await still(page);
  assert.match(await page.locator('h1').innerText(), /staircase on four sides/);
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
  const tools = await page.locator('.tools').boundingBox();
  assert.ok(tools.x >= 0 && tools.x + tools.width <= 390);
  await close();
});
