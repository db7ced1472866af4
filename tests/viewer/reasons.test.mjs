// SPDX-License-Identifier: MIT
// Why rules are refused, what a site showed, and structures that take long to draw.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import {after, before, test} from 'node:test';
import {choices, folder, open, pixelAt, startBrowser, stigc, still, stopBrowser}
    from './browser.mjs';

const kRules = `stigc: 1
name: walled
lattice: cubic
symmetry: none
floor: true
bricks:
  1: {name: Q1, color: "#e6194b", led: Q1}
  2: {name: Q2, color: "#3cb44b", led: Q2}
  3: {name: Q3, color: "#4363d8", led: Q3}
  4: {name: Q4, color: "#f58231", led: Q4}
start:
  - {at: [0, 0, 0], brick: 1}
  - {at: [2, 0, 0], brick: 1}
  - {at: [1, 1, 0], brick: 2}
  - {at: [1, -1, 0], brick: 2}
rules:
  - name: in the middle
    place: 3
    when: |
      ? ? ?   ? 2 ?   ? ? ?
      ? ? ?   1 * 1   ? ? ?
      ? ? ?   ? 2 ?   ? ? ?
`;

before(async () => {
  fs.writeFileSync(path.join(folder, 'middle.yaml'), kRules);
  stigc(['compile', 'middle.yaml', '--why', 'why.html', '-q'], 1);
  stigc(['explore', 'rulesets/staircase.yaml', '--trace', 'stairs.stigt']);
  stigc(['view', 'stairs.stigt', '-o', 'stairs.html']);
  // Every other cell: a hundred thousand faces, and more than half as many again.
  const cells = [];
  for (let x = 0; x < 38; ++x) {
    for (let y = 0; y < 38; ++y) {
      for (let z = (x + y) % 2; z < 38; z += 2) cells.push([x, y, z, 1]);
    }
  }
  fs.writeFileSync(path.join(folder, 'many.json'), JSON.stringify({
    stigc_structure: 1, lattice: 'cubic', bricks: [{symbol: 'a', name: 'a', color: '#336699'}],
    cells,
  }));
  stigc(['view', 'many.json', '-o', 'many.html']);
  await startBrowser();
});
after(stopBrowser);

test('a refusal has the brick that is wanted, and those in the way', async () => {
  const {page, close} = await open('why.html');
  await still(page);
  const text = await page.locator('.refusal').innerText();
  assert.match(text, /rule 'in the middle' places the brick at \(1, 0, 0\)/);
  assert.match(text, /\(2, 0, 0\) in the way: from \+x/);
  assert.match(text, /\(1, 0, 0\) wanted/);
  const marks = await page.evaluate(() => window.stigView.page.runs[0].marks);
  assert.deepEqual(marks.filter(({way}) => !way).map(({at}) => at), [[1, 0, 0]]);
  assert.equal(marks.filter(({way}) => way).length, 4);
  // From above the site is green: nothing but what is wanted stands there.
  await page.keyboard.press('6');
  await still(page);
  const at = await page.evaluate(() => {
    const {viewpoint, stage} = window.stigView;
    const place = viewpoint.camera.position.clone().set(1.2, 0.2, 1).project(viewpoint.camera);
    const box = stage.canvas.getBoundingClientRect();
    return {x: box.left + (place.x + 1) / 2 * box.width,
            y: box.top + (1 - place.y) / 2 * box.height};
  });
  const [red, green, blue] = await pixelAt(page, at);
  assert.ok(green > red && green > blue, [red, green, blue].join());
  await close();
});

test('a brick has the states of its site, each of which leads to its moment', async () => {
  const {page, close} = await open('stairs.html');
  await page.evaluate(() => window.stigView.state.set({picked: {run: 0, brick: 5}}));
  const states = page.locator('.story .states').first().locator('.state');
  assert.ok(await states.count() >= 2);
  assert.match(await states.first().innerText(), /at first/);
  const last = states.last();
  const time = Number(/from brick (\d+) on/.exec(await last.innerText())[1]);
  await last.click();
  assert.equal((await choices(page)).time, time);
  await close();
});

test('what takes long to draw is drawn in coarse cells while it turns', async () => {
  const {page, close} = await open('many.html');
  await still(page);
  const shown = () => page.evaluate(() => {
    const [{faces, coarse}] = window.stigView.views;
    return [faces.object.visible, coarse.object.visible, coarse.count];
  });
  const turning = await page.evaluate(async () => {
    const {stage, viewpoint, views: [{faces, coarse}]} = window.stigView;
    const before = stage.frames;
    viewpoint.turn(0.1, 0, 1);
    while (stage.frames === before) await new Promise(resolve => setTimeout(resolve, 1));
    return [faces.object.visible, coarse.object.visible];
  });
  assert.deepEqual(turning, [false, true]);
  await still(page);
  const [fine, coarse, faces] = await shown();
  assert.deepEqual([fine, coarse], [true, false], 'all of it once it is still');
  assert.ok(faces < 10_000, `${faces} coarse faces`);
  await close();
});
