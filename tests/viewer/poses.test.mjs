// SPDX-License-Identifier: MIT
// Pages of runs in the physical world.
import assert from 'node:assert/strict';
import {after, before, test} from 'node:test';
import {choices, open, startBrowser, stigc, still, stopBrowser} from './browser.mjs';

before(async () => {
  stigc(['simulate', 'scenes/drop.yaml', '--duration', '1', '--trace', 'drop.stigp']);
  stigc(['simulate', 'scenes/robot-fetch.yaml', '--duration', '6', '--trace', 'fetch.stigp']);
  stigc(['simulate', 'scenes/pull-together.yaml', '--duration', '2', '--trace', 'pull.stigp']);
  stigc(['view', 'drop.stigp', '-o', 'drop.html']);
  stigc(['view', 'pull.stigp', '-o', 'pull.html']);
  stigc(['view', 'fetch.stigp', '-o', 'fetch.html']);
  await startBrowser();
});
after(stopBrowser);

/** Place of a body by the page's own tracks. */
const poseOf = (page, name, time) => page.evaluate(([body, at]) => {
  const {run} = window.stigView.views[0];
  return run.tracks.at(run.bodies.findIndex(one => one.name === body), at);
}, [name, time]);

test('bodies are where the trace has them', async () => {
  const told = JSON.parse(stigc(['replay', 'drop.stigp', '--at', '0.5', '--json', '-q']));
  const {page, close} = await open('drop.html');
  assert.ok(told.moment.bodies.length > 90);
  for (const {name, at, quaternion: [w, x, y, z]} of told.moment.bodies) {
    const {p, q} = await poseOf(page, name, 0.5);
    p.forEach((value, i) => assert.ok(Math.abs(value - at[i]) < 2e-4, `${name}: ${p} for ${at}`));
    const same = Math.abs(q[0] * x + q[1] * y + q[2] * z + q[3] * w);
    assert.ok(same > 0.99999, `${name}: turned otherwise`);
  }
  await close();
});

test('time is in seconds, and blocks fall as it passes', async () => {
  const {page, close} = await open('drop.html');
  assert.equal((await choices(page)).time, 1);
  const lowest = () => page.evaluate(() => Math.min(...window.stigView.views[0].meshes
      .filter(mesh => mesh).map(mesh => mesh.position.z)));
  await still(page);
  const end = await lowest();
  await page.locator('.typed').fill('0');
  await page.locator('.typed').press('Enter');
  await still(page);
  assert.ok(await lowest() > end + 0.01);
  await close();
});

test('a robot shows its values, is followed, and says what it is on a click', async () => {
  const {page, close} = await open('fetch.html');
  await still(page);
  assert.match(await page.locator('.robots').innerText(), /bebot 1/);
  assert.ok(await page.locator('.robots .facts tr').count() > 0, 'values of robot.show');
  const robot = await page.evaluate(() => {
    const {robots} = window.stigView.views[0].run;
    return {bodies: robots[0].bodies.length, count: robots.length};
  });
  assert.equal(robot.count, 1);
  assert.ok(robot.bodies > 5);
  await page.keyboard.press('v');
  await still(page);
  const camera = () => page.evaluate(() => window.stigView.viewpoint.numbers());
  const [, , , x, y] = await camera();
  await page.keyboard.press('Home');
  await still(page);
  const [, , , x0, y0] = await camera();
  assert.ok(Math.hypot(x - x0, y - y0) > 0.02, 'the camera went with it');
  const canvas = await page.locator('canvas').boundingBox();
  await page.mouse.click(canvas.x + canvas.width / 2, canvas.y + canvas.height / 2);
  const {picked} = await choices(page);
  assert.notEqual(picked, null, 'the robot is in the middle of the picture');
  assert.match(await page.locator('.story').innerText(), /place/);
  await close();
});

test('an event leads to its moment', async () => {
  const {page, close} = await open('pull.html', {width: 390, height: 780, dark: true});
  const snap = page.locator('.events li', {hasText: 'snapped to'}).first();
  const time = Number(await snap.locator('.when').innerText());
  await snap.click();
  assert.ok(Math.abs((await choices(page)).time - time) < 0.006);
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
  await close();
});
