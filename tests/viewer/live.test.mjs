// SPDX-License-Identifier: MIT
// Pages of runs that go on: stigc view --live.
import assert from 'node:assert/strict';
import {spawn} from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import {after, before, test} from 'node:test';
import {folder, openAddress, startBrowser, stigc, still, stopBrowser, until} from './browser.mjs';

const kTower = `stigc: 1
name: tower
lattice: cubic
floor: true
bricks:
  a: {name: red, color: "#e6194b"}
start:
  - {at: [0, 0, 0], brick: a}
rules:
  - name: raise
    place: a
    when: |
      ? ? ?   ? ? ?   ? ? ?
      ? ? ?   ? * ?   ? a ?
      ? ? ?   ? ? ?   ? ? ?
    height: {max: 3}
`;

const kHands = `stigc_scene: 1
title: A block, a robot, and blocks to drop
duration: 20
robots:
  - {file: bebot.yaml, at: [0, 0], heading: 0, program: hand.lua}
blocks:
  - {at: [-0.4, 0, 0.0275], color: Q3}
stock: 2
`;
const kDrive = 'function step() robot.differential_drive.set_target_velocity(0.05, -0.05) end\n';

before(async () => {
  fs.writeFileSync(path.join(folder, 'hand.yaml'), kHands);
  fs.writeFileSync(path.join(folder, 'hand.lua'), kDrive);
  await startBrowser();
});
const programs = [];
after(stopBrowser);
// What a test that failed has left running would be waited for.
after(() => programs.forEach(program => program.kill()));

/** A program that serves a run; `end` interrupts it, and returns its exit status. */
async function serve(args) {
  const program = spawn(process.env.STIGC, ['view', '--live', ...args], {cwd: folder});
  programs.push(program);
  const exit = new Promise(done => program.on('exit', done));
  let said = '', complained = '';
  program.stderr.on('data', data => complained += data);
  const address = await new Promise((found, failed) => {
    program.stdout.on('data', data => {
      said += data;
      if (said.endsWith('\n')) found(said.trim());
    });
    exit.then(() => failed(new Error(`it has ended: ${complained}`)));
  });
  return {
    address,
    end: () => {
      program.kill('SIGINT');
      return exit;
    },
  };
}

const state = page => page.evaluate(() => window.stigLive.now);
const press = (page, name) => page.getByRole('button', {name, exact: true}).click();

test('bricks appear, the run pauses and steps, and goes back to a checkpoint', async () => {
  fs.writeFileSync(path.join(folder, 'tower.yaml'), kTower);
  const {address, end} = await serve(['tower.yaml', '--paused', '--seed', '3', '--trace',
                                      'tower.stigt']);
  const {page, close} = await openAddress(address);
  await until(page, () => window.stigLive.now?.mode === 'paused');
  assert.equal((await state(page)).time, 0);
  await press(page, 'step');
  await until(page, () => window.stigLive.now.time === 1);
  await until(page, () => window.stigView.views[0].run.bricks.count === 2);
  assert.equal((await state(page)).mode, 'paused');
  await press(page, 'checkpoint');
  await until(page, () => window.stigLive.now.checkpoints.length === 1);
  await page.getByText('save checkpoint 1').waitFor();
  await press(page, 'run or pause (space)');
  await until(page, () => window.stigLive.now.mode === 'ended');
  await until(page, () => window.stigView.views[0].run.bricks.count === 4);
  assert.match(await page.locator('.live .status').innerText(), /ended: saturated/);
  await page.getByRole('combobox', {name: 'go back'}).selectOption('1');
  await until(page, () => window.stigLive.now.time === 1);
  await until(page, () => window.stigView.views[0].run.bricks.count === 2);
  await page.keyboard.press('Escape');
  await page.locator('canvas').focus();
  await page.keyboard.press('ArrowRight');
  await until(page, () => window.stigLive.now.time === 2);
  await close();
  assert.equal(await end(), 0);
  assert.match(stigc(['replay', 'tower.stigt']), /2 events, identical/);
});

test('rules that are saved begin the run again, bad ones are told and leave it', async () => {
  const file = path.join(folder, 'saved.yaml');
  fs.writeFileSync(file, kTower);
  const {address, end} = await serve(['saved.yaml']);
  const {page, close} = await openAddress(address);
  await until(page, () => window.stigView.views[0].run.bricks.count === 4);
  const {run} = await state(page);
  fs.writeFileSync(file, kTower.replace('place: a', 'place: nobody'));
  await until(page, () => window.stigLive.now.trouble.includes('nobody'));
  assert.match(await page.locator('.trouble').innerText(), /error\[R\d+\]/);
  assert.equal((await state(page)).run, run);
  // As an editor does that writes another file and renames it.
  fs.writeFileSync(`${file}~`, kTower.replace('max: 3', 'max: 5'));
  fs.renameSync(`${file}~`, file);
  await until(page, () => window.stigView.views[0].run.bricks.count === 6);
  const now = await state(page);
  assert.equal(now.trouble, '');
  assert.equal(now.run, run + 1);
  await close();
  assert.equal(await end(), 0);
});

test('a block is moved by hand, a robot breaks and is mended, and all of it is in the trace', async () => {
  const {address, end} = await serve(['hand.yaml', '--paused', '--trace',
                                      'hand.stigp', '--checkpoint', 'hand.stigk']);
  const {page, close} = await openAddress(address);
  await until(page, () => window.stigLive.now?.mode === 'paused');
  const block = await page.evaluate(() => {
    const {run} = window.stigView.views[0];
    return run.bodies.findIndex(body => body.block);  // the first body
  });
  const placeOf = () => page.evaluate(body => window.stigView.views[0].run.tracks.at(body, 0).p,
                                      block);
  const pick = brick => page.evaluate(body =>
    window.stigView.state.set({picked: {run: 0, brick: body}}), brick);
  await pick(block);
  const [x, y, z] = await placeOf();
  await page.getByRole('textbox', {name: 'x in m'}).fill(String(x + 0.05));
  await press(page, 'put there');
  await until(page, () => window.stigView.views[0].run.tracks.at(0, 0).p[0] > -0.36);
  const moved = await placeOf();
  assert.ok(Math.hypot(moved[0] - x - 0.05, moved[1] - y, moved[2] - z) < 2e-3, String(moved));
  // It is the farthest towards -x of all, and `f` fits what there is now.
  const lowest = () => page.evaluate(() => window.stigView.views[0].bounds.low[0]);
  assert.ok(Math.abs(await lowest() - (moved[0] - 0.0275)) < 1e-3, String(await lowest()));
  const seenFrom = () => page.evaluate(() => window.stigView.viewpoint.numbers().join());
  const before = await seenFrom();
  await page.keyboard.press('f');
  await until(page, was => window.stigView.viewpoint.numbers().join() !== was, before);
  await press(page, 'checkpoint');
  await until(page, () => window.stigLive.now.checkpoints.length === 1);
  const robot = await page.evaluate(() => window.stigView.views[0].run.robots[0].bodies[0]);
  await pick(robot);
  await press(page, 'break');
  await until(page, () => window.stigLive.now.broken[0] === 1);
  assert.match(await page.locator('.live .status').innerText(), /1 broken/);
  await press(page, 'step');
  await press(page, 'mend');
  await until(page, () => window.stigLive.now.broken[0] === 0);
  // Where the picked robot stands there is no room; above it there is.
  await press(page, 'drop');
  await page.getByText(/^it would/).waitFor();
  await page.getByRole('textbox', {name: 'z in m'}).fill('0.5');
  await press(page, 'drop');
  await until(page, () => document.querySelector('.live .said').textContent === '');
  await page.getByRole('combobox', {name: 'speed', exact: true}).selectOption('max');
  await press(page, 'run or pause (space)');
  await until(page, () => window.stigLive.now.time > 2);
  await close();
  assert.equal(await end(), 0);
  assert.match(stigc(['replay', '--verify', 'hand.stigp']), /identical/);
  assert.ok(fs.statSync(path.join(folder, 'hand.stigk')).size > 100);
});

/** Where a body stands, and where on the page that is drawn. */
const drawnAt = (page, number) => page.evaluate(body => {
  const {views, viewpoint, stage} = window.stigView;
  const {camera} = viewpoint;
  const p = views[0].run.tracks.at(body, 0).p;
  const place = camera.position.clone().fromArray(p).project(camera);
  const box = stage.canvas.getBoundingClientRect();
  return {p, x: box.left + (place.x + 1) / 2 * box.width, y: box.top + (1 - place.y) / 2 * box.height};
}, number);

async function drag(page, {x, y}, right, steps = 4) {
  await press(page, 'hand');
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + right, y, {steps});
  await page.mouse.up();
}

const kBlock = () => window.stigView.views[0].run.bodies.findIndex(one => one.block);

test('the camera goes back when a robot drives out of the picture, unless somebody moved it', async () => {
  const {address, end} = await serve(['hand.yaml', '--paused']);
  const {page, close} = await openAddress(address);
  await until(page, () => window.stigLive.now?.mode === 'paused');
  const put = x => page.evaluate(
      to => window.stigLive.ask({do: 'move', robot: 0, at: [to, 0, 0.001]}), x);
  const answer = await put(4);
  assert.ok(answer.ok, answer.problem);
  await until(page, () => window.stigView.viewpoint.showsAll &&
                          window.stigView.viewpoint.camera.position.length() > 5);
  await page.evaluate(() => window.stigView.viewpoint.turn(0.5, 0, 1));
  const numbers = () => page.evaluate(() => window.stigView.viewpoint.numbers().map(x => x.toFixed(6)));
  const before = await numbers();
  await put(12);
  await until(page, () => !window.stigView.viewpoint.showsAll);
  assert.deepEqual(await numbers(), before);
  await close();
  await end();
});

test('a block is dragged where the mouse leads it', async () => {
  const {address, end} = await serve(['hand.yaml', '--paused']);
  const {page, close} = await openAddress(address);
  await until(page, () => window.stigLive.now?.mode === 'paused');
  const block = await page.evaluate(kBlock);
  const at = await drawnAt(page, block);
  await drag(page, at, 30);
  await until(page, () => window.stigView.views[0].run.tracks.at(0, 0).p[1] !== 0);
  const now = await drawnAt(page, block);
  assert.ok(Math.hypot(now.p[0] - at.p[0], now.p[1] - at.p[1]) > 0.01, String(now.p));
  assert.ok(Math.abs(now.p[2] - at.p[2]) < 2e-3);
  await close();
  assert.equal(await end(), 0);
});

test('however fast the mouse goes, a block ends where it was let go, and the page says where', async () => {
  const {address, end} = await serve(['hand.yaml', '--paused']);
  const {page, close} = await openAddress(address);
  await until(page, () => window.stigLive.now?.mode === 'paused');
  const block = await page.evaluate(kBlock);
  const at = await drawnAt(page, block);
  await drag(page, at, 120, 30);
  // As it is drawn, the place that was grasped is below the mouse; on the way there it may be still.
  await until(page, ([body, right]) => {
    const {views, viewpoint, stage} = window.stigView;
    const [x, y, z] = views[0].run.tracks.at(body, 0).p;
    const place = viewpoint.camera.position.clone().set(x, y, z).project(viewpoint.camera);
    const box = stage.canvas.getBoundingClientRect();
    const told = /place\s*([-.\d]+), ([-.\d]+)/.exec(document.querySelector('.panel').innerText);
    const field = Number(document.querySelector('input[aria-label="x in m"]').value);
    return Math.abs(box.left + (place.x + 1) / 2 * box.width - right) < 12 && told &&
        Math.abs(told[1] - x) < 1e-3 && Math.abs(told[2] - y) < 1e-3 && Math.abs(field - x) < 2e-3;
  }, [block, at.x + 120]);
  // A click alone moves nothing.
  const before = await page.evaluate(() => window.stigLive.answered);
  const now = await drawnAt(page, block);
  await page.mouse.click(now.x, now.y);
  await page.waitForTimeout(200);
  assert.equal(await page.evaluate(() => window.stigLive.answered), before);
  await close();
  assert.equal(await end(), 0);
});

test('the newest checkpoint is the one that is kept in the file', async () => {
  const {address, end} = await serve(['hand.yaml', '--paused', '--checkpoint', 'newest.stigk']);
  const {page, close} = await openAddress(address);
  await until(page, () => window.stigLive.now?.mode === 'paused');
  const file = path.join(folder, 'newest.stigk');
  await press(page, 'checkpoint');
  await until(page, () => window.stigLive.now.checkpoints.length === 1);
  const first = fs.readFileSync(file);
  await press(page, 'step');
  await until(page, () => window.stigLive.now.time > 0);
  await press(page, 'checkpoint');
  await until(page, () => window.stigLive.now.checkpoints.length === 2);
  assert.notDeepEqual(fs.readFileSync(file), first);
  await close();
  assert.equal(await end(), 0);
});

test('a block is taken off the robot that carries it', async () => {
  const {address, end} = await serve(['scenes/robot-fetch.yaml', '--paused', '--trace',
                                      'carried.stigp']);
  const {page, close} = await openAddress(address);
  await until(page, () => window.stigLive.now?.mode === 'paused');
  // Not at full speed: on a busy machine the run would end before the page has seen anything.
  await press(page, 'run or pause (space)');
  // Until a block is away from the cache.
  await until(page, () => window.stigView.views[0].run.bodies.some((body, i) => {
    const at = body.block && i > 0 && window.stigView.views[0].run.tracks.at(i, 0);
    return at && Math.hypot(at.p[0] - 0.35, at.p[1]) > 0.1;
  }));
  await press(page, 'run or pause (space)');
  await until(page, () => window.stigLive.now.mode === 'paused');
  const {block, robot} = await page.evaluate(() => {
    const {run} = window.stigView.views[0];
    const places = run.bodies.map((body, i) => run.tracks.at(i, 0)?.p);
    const far = i => places[i] && run.bodies[i].block ? places[i][0] : -Infinity;
    const numbers = [...places.keys()];
    return {block: numbers.reduce((best, i) => far(i) > far(best) ? i : best, 0),
            robot: run.robots[0].bodies[0]};
  });
  await page.locator('canvas').focus();
  await page.keyboard.press('f');
  await still(page);
  const at = await drawnAt(page, block), carrier = await drawnAt(page, robot);
  assert.ok(at.p[2] > 0.04, `it is not held up: ${at.p}`);
  await drag(page, at, 150);
  await until(page, ([body, was]) =>
    window.stigView.views[0].run.tracks.at(body, 0).p[1] !== was, [block, at.p[1]]);
  const now = await drawnAt(page, block);
  assert.ok(Math.hypot(now.p[0] - at.p[0], now.p[1] - at.p[1]) > 0.05, String(now.p));
  assert.deepEqual((await drawnAt(page, robot)).p, carrier.p);
  // Nothing holds it now.
  await press(page, 'run or pause (space)');
  await until(page, body => window.stigView.views[0].run.tracks.at(body, 0).p[2] < 0.03, block);
  await close();
  assert.equal(await end(), 0);
  assert.match(stigc(['replay', '--verify', 'carried.stigp']), /identical/);
});

test('a program that does not load, or fails at work, is mended by saving it again', async () => {
  const file = path.join(folder, 'hand.lua');
  const {address, end} = await serve(['hand.yaml']);
  const {page, close} = await openAddress(address);
  // On a slow machine the run may have ended by now.
  await until(page, () => window.stigLive.now);
  fs.writeFileSync(file, 'function step( end\n');
  await until(page, () => window.stigLive.now.trouble.includes('hand.lua'));
  assert.equal((await state(page)).run, 1);
  fs.writeFileSync(file, 'function step() error("no way on") end\n');
  await until(page, () => window.stigLive.now.run === 2 && window.stigLive.now.broken[0] === 2);
  assert.equal((await state(page)).trouble, '');
  assert.match(await page.locator('.live .status').innerText(), /1 broken/);
  fs.writeFileSync(file, kDrive);
  await until(page, () => window.stigLive.now.run === 3 && window.stigLive.now.time > 0.1);
  assert.equal((await state(page)).broken[0], 0);
  await close();
  assert.equal(await end(), 0);
});
