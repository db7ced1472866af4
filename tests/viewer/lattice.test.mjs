// SPDX-License-Identifier: MIT
// Pages of structures and of runs on the lattice.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import {after, before, test} from 'node:test';
import {choices, folder, open, pixelAt, placeOf, startBrowser, stigc, still, stopBrowser,
        until}
    from './browser.mjs';

before(async () => {
  stigc(['explore', 'rulesets/staircase.yaml', '--agents', '3', '--trace', 'stairs.stigt']);
  stigc(['explore', 'rulesets/tiling.yaml', '--motion', 'event', '--deposits', '300', '-o',
         'tiling.json']);
  stigc(['verify', 'rulesets/order-dependent.yaml', '--witness', 'two'], 1);
  stigc(['view', 'stairs.stigt', '-o', 'stairs.html']);
  stigc(['view', 'tiling.json', '-o', 'tiling.html']);
  stigc(['view', 'two', '-o', 'two.html']);
  await startBrowser();
});
after(stopBrowser);

const placed = page => page.evaluate(
    () => window.stigView.views[0].visible.reduce((sum, one) => sum + one, 0));

test('a run opens at its end, with all that there is to read', async () => {
  const {page, close} = await open('stairs.html');
  assert.equal((await choices(page)).time, 5);
  assert.equal(await placed(page), 6);
  const text = await page.locator('.panel').innerText();
  for (const part of ['Q1', 'raise the tall column', 'walk', 'saturated']) {
    assert.ok(text.includes(part), part);
  }
  const counts = await page.locator('.legend .count').allInnerTexts();
  assert.deepEqual(counts, ['1', '2', '3']);
  await close();
});

test('time is played, stepped, scrubbed and typed', async () => {
  const {page, close} = await open('stairs.html');
  await page.keyboard.press('Home');
  await still(page);
  assert.equal(await placed(page), 1);
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('ArrowLeft');
  await still(page);
  assert.equal((await choices(page)).time, 1);
  assert.equal(await placed(page), 2);
  await page.locator('.typed').fill('3');
  await page.locator('.typed').press('Enter');
  await still(page);
  assert.equal(await placed(page), 4);
  await page.locator('.scrub').fill('2');
  await still(page);
  assert.equal(await placed(page), 3);
  await page.locator('select[aria-label=speed]').selectOption('50');
  await page.getByRole('button', {name: 'play or pause'}).click();
  await until(page, () => window.stigView.state.now.time === 5);
  assert.equal((await choices(page)).playing, false);
  await close();
});

test('a loop begins again', async () => {
  const {page, close} = await open('stairs.html');
  await page.locator('select[aria-label=speed]').selectOption('50');
  await page.locator('body').press('l');
  await page.evaluate(() => {
    window.returns = 0;
    window.stigView.state.onChange(changed => {
      if (changed.has('time') && window.stigView.state.now.time === 0) ++window.returns;
    });
  });
  await page.getByRole('button', {name: 'play or pause'}).click();
  await until(page, () => window.returns > 2);
  await page.getByRole('button', {name: 'play or pause'}).click();
  await close();
});

test('nothing is drawn while nothing moves', async () => {
  const {page, close} = await open('stairs.html');
  await still(page);
  const frames = await page.evaluate(() => window.stigView.stage.frames);
  await page.waitForTimeout(1000);
  assert.equal(await page.evaluate(() => window.stigView.stage.frames), frames);
  await close();
});

test('a click on a brick tells who placed it, when and by which rule', async () => {
  const {page, close} = await open('stairs.html');
  await still(page);
  // The top of the tall column is seen from everywhere above.
  const top = await page.evaluate(() => {
    const {x, z} = window.stigView.views[0].run.bricks.cells;
    return x.findIndex((_, i) => x[i] === 0 && z[i] === 2);
  });
  const at = await placeOf(page, top);
  await page.mouse.click(at.x, at.y);
  assert.deepEqual((await choices(page)).picked, {run: 0, brick: top});
  const story = await page.locator('.story').innerText();
  assert.match(story, /cell\s+\(0, 0, 2\)/);
  assert.match(story, /placed\s+as number \d+, in step \d+/);
  assert.match(story, /by\s+agent [0-2]/);
  assert.match(story, /rule\s+raise the tall column/);
  assert.match(await page.locator('.story .lines').innerText(), /name: raise the tall column/);
  const around = await page.locator('.story pre').first().textContent();
  assert.equal(around.split('\n')[1], '. . .   . * .   . 3 .');
  await page.keyboard.press('Escape');
  assert.equal((await choices(page)).picked, null);
  await close();
});

test('colours are hidden, bricks of a rule lit, palettes changed: seen in the picture', async () => {
  const {page, close} = await open('stairs.html');
  await page.keyboard.press('6');
  await still(page);
  const at = await placeOf(page, 0);
  at.x += 5;  // beside the lines between bricks
  const [red, green, blue] = await pixelAt(page, at);
  assert.ok(blue > red && blue > green, 'the start is a blue column');
  await page.locator('.legend input').nth(2).click();
  await still(page);
  assert.notDeepEqual(await pixelAt(page, at), [red, green, blue]);
  await page.locator('.legend input').nth(2).click();
  await page.locator('select[aria-label=palette]').selectOption('okabe-ito');
  await still(page);
  const third = await pixelAt(page, at);
  assert.ok(third[1] > third[0] && third[1] > third[2], 'the third of Okabe and Ito is green');
  await page.locator('.rules li').nth(3).hover();
  await still(page);
  const [r, g, b] = await pixelAt(page, at);
  assert.ok(Math.max(r, g, b) - Math.min(r, g, b) < 8, 'greyed while another rule is lit');
  await page.mouse.move(300, 300);
  await page.locator('select[aria-label=colour]').selectOption('order');
  await still(page);
  assert.equal((await choices(page)).colouring, 'order');
  await close();
});

test('levels are cut off, and what is below shows its top', async () => {
  const {page, close} = await open('stairs.html');
  await page.keyboard.press('[');
  await page.keyboard.press('[');
  await still(page);
  assert.equal((await choices(page)).high, 0);
  assert.equal(await placed(page), 3);
  assert.equal(await page.evaluate(() => window.stigView.views[0].facesDrawn), 14);
  await close();
});

test('the camera turns, keeps to presets, fits, and is parallel on demand', async () => {
  const {page, close} = await open('stairs.html');
  const numbers = () => page.evaluate(() => window.stigView.viewpoint.numbers());
  const first = await numbers();
  await page.mouse.move(400, 300);
  await page.mouse.down();
  await page.mouse.move(500, 340, {steps: 4});
  await page.mouse.up();
  assert.notDeepEqual(await numbers(), first);
  await page.keyboard.press('2');
  const [x, y, z, tx, ty, tz] = await numbers();
  assert.ok(Math.abs(x - tx) < 1e-6 && Math.abs(z - tz) < 1e-6 && y < ty, 'from the front');
  await page.keyboard.press('o');
  await still(page);
  assert.equal(await page.evaluate(() => window.stigView.viewpoint.orthographic), true);
  const parallel = await numbers();
  parallel.forEach((value, i) => assert.ok(Math.abs(value - [x, y, z, tx, ty, tz][i]) < 1e-3));
  await page.mouse.wheel(0, -400);
  await page.keyboard.press('f');
  await close();
});

test('a link leads to the same view', async () => {
  const {page, close} = await open('stairs.html');
  await page.keyboard.press('Home');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('a');
  await page.keyboard.press('c');
  await page.keyboard.press('k');
  const hash = await page.evaluate(() => location.hash);
  const camera = await page.evaluate(() => window.stigView.viewpoint.numbers());
  await close();
  const again = await open('stairs.html', {hash});
  const {time, colouring} = await choices(again.page);
  assert.deepEqual([time, colouring], [1, 'order']);
  const there = await again.page.evaluate(() => window.stigView.viewpoint.numbers());
  there.forEach((value, i) => assert.ok(Math.abs(value - camera[i]) < 1e-3));
  await again.close();
});

test('the two runs of a refuted verdict stand side by side, with where they part', async () => {
  const {page, close} = await open('two.html');
  assert.equal((await choices(page)).side, true);
  assert.equal(await page.evaluate(() => window.stigView.stage.panes.length), 2);
  assert.match(await page.locator('.labels').innerText(), /parts after \d+ brick/);
  await page.getByRole('button', {name: 'go there'}).first().click();
  await page.keyboard.press('d');
  await still(page);
  const camera = await page.evaluate(() => window.stigView.viewpoint.numbers());
  await page.getByRole('button', {name: 'two-second.stigt'}).click();
  await still(page);
  const now = await choices(page);
  assert.deepEqual([now.side, now.run], [false, 1]);
  assert.deepEqual(await page.evaluate(() => window.stigView.viewpoint.numbers()), camera);
  await close();
});

test('a structure without history has no time bar; hexagonal bricks are picked too', async () => {
  const {page, close} = await open('tiling.html', {dark: true});
  await still(page);
  assert.equal(await page.locator('.time').count(), 0);
  assert.equal(await page.locator('#stig-view').getAttribute('data-theme'), 'dark');
  const at = await placeOf(page, 150);
  await page.mouse.click(at.x, at.y);
  assert.equal((await choices(page)).picked.brick, 150);
  await still(page);
  // Its outline is that of a hexagonal prism, about it.
  const outline = await page.evaluate(() => {
    const {marker, run} = window.stigView.views[0];
    const places = [...marker.geometry.getAttribute('position').array];
    const corners = new Set();
    for (let i = 0; i < places.length; i += 3) {
      corners.add(places.slice(i, i + 3).map(x => x.toFixed(3)).join());
    }
    const away = [...corners].map(c => Math.hypot(...c.split(',').slice(0, 2)));
    return {edges: places.length / 6, corners: corners.size, away, visible: marker.visible,
            off: marker.position.toArray().map((x, i) => x - run.bricks.centres[3 * 150 + i])};
  });
  assert.deepEqual([outline.edges, outline.corners, outline.visible], [18, 12, true]);
  for (const away of outline.away) assert.ok(Math.abs(away - 1.06 / Math.sqrt(3)) < 0.01, away);
  for (const off of outline.off) assert.ok(Math.abs(off) < 1e-6);
  await close();
});

test('keys are listed on ?, and every one does something without an error', async () => {
  const {page, close} = await open('stairs.html');
  await page.keyboard.press('?');
  const sheet = await page.locator('.sheet').innerText();
  assert.match(sheet, /play or pause/);
  await page.keyboard.press('Escape');
  assert.equal(await page.locator('.sheet').count(), 0);
  // The loop is ended before the run is played: it would go on for ever.
  const keys = [...'.,lgbcpnsdtaewx+-f123456o[]kvryuhjim', 'l', ' ', 'End'];
  for (const key of keys) await page.keyboard.press(key);
  await close();
});

test('a narrow screen has everything within its width', async () => {
  const {page, close} = await open('two.html', {width: 390, height: 780});
  await still(page);
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
  for (const part of ['.stage', '.panel', '.time']) {
    const box = await page.locator(part).boundingBox();
    assert.ok(box.height > 60 && box.x >= 0 && box.x + box.width <= 390, part);
  }
  await close();
});

test('what files say stays text', async () => {
  const evil = '<img src=x onerror="window.bad=1"></script><script>window.bad=1</script>';
  fs.writeFileSync(path.join(folder, 'evil.json'), JSON.stringify({
    stigc_structure: 1, lattice: 'cubic', bricks: [{symbol: 'a', name: evil, color: '#112233'}],
    cells: [[0, 0, 0, 1]],
  }));
  stigc(['view', 'evil.json', '--title', evil, '-o', 'evil.html']);
  const {page, close} = await open('evil.html');
  await still(page);
  assert.equal(await page.evaluate(() => window.bad), undefined);
  assert.ok((await page.locator('.legend').innerText()).includes('onerror'));
  assert.equal(await page.locator('img').count(), 0);
  await close();
});
