// SPDX-License-Identifier: MIT
// All of a robot: its pane, what is drawn about it, and the view of its camera.
import assert from 'node:assert/strict';
import {after, before, test} from 'node:test';
import {choices, open, startBrowser, stigc, still, stopBrowser, until} from './browser.mjs';

before(async () => {
  // Two bricks of the staircase, which are not all that it takes: the exit status says so.
  stigc(['validate', 'rulesets/staircase.yaml', '--duration', '110', '--trace-detail', '-o', 'out'],
        1);
  stigc(['simulate', 'scenes/robot-fetch.yaml', '--duration', '3', '--trace', 'plain.stigp']);
  stigc(['view', 'out', '-o', 'out.html']);
  stigc(['view', 'plain.stigp', '-o', 'plain.html']);
  await startBrowser();
});
after(stopBrowser);

const set = (page, changes) => page.evaluate(one => window.stigView.state.set(one), changes);

/** When the robot's program first showed these values, by the trace. */
async function firstShown(page, wanted, after = 0) {
  const time = await page.evaluate(([text, from]) => {
    const {show} = window.stigView.page.runs[0];
    for (const {times, texts} of show.values()) {
      const found = texts.findIndex((one, i) => times[i] > from && one.includes(text));
      if (found >= 0) return times[found];
    }
    return null;
  }, [wanted, after]);
  assert.notEqual(time, null, `never shown: ${wanted}`);
  return time;
}

/** When it sets out to the first site: after the first look. */
const setsOut = async page => firstShown(page, '"approach"', await firstShown(page, '"look"'));

/** When it first sees a tag after it has begun to look at the structure. */
async function sees(page) {
  const from = await firstShown(page, '"look"');
  return page.evaluate(after => {
    const [[, {times, texts}]] = window.stigView.page.runs[0].senses;
    return times[texts.findIndex((one, i) => times[i] > after && one.includes('"tags"'))] + 0.01;
  }, from);
}

/** Points of the lines that are drawn about bodies. */
const drawn = page => page.evaluate(() => {
  const {object, within} = window.stigView.views[0].marks;
  return [object, within].map(lines => lines.geometry.getAttribute('position').count);
});

test('the pane has the chart with the state, and the way into it', async () => {
  const {page, close} = await open('out.html');
  await set(page, {time: await setsOut(page) + 0.01});
  assert.equal(await page.locator('.chart > .now > b').innerText(), 'approach site');
  assert.deepEqual(await page.locator('.chart .taken').allInnerTexts(),
                   ['decided → approach site']);
  assert.match(await page.locator('.pane').innerText(), /within it: approach/);
  await close();
});

test('the pane has the decisions, with the branch that the robot took', async () => {
  const {page, close} = await open('out.html');
  await set(page, {time: 1});
  assert.equal(await page.locator('.decides .taken').count(), 0);
  assert.match(await page.locator('.pane').innerText(), /nothing decided so far/);
  // The first is put upon the brick of the start; the program says so before it sets out.
  const decided = await firstShown(page, '"branch"');
  assert.ok(decided <= await setsOut(page) && decided < await firstShown(page, '"placed":1'));
  await set(page, {time: decided - 0.01});
  assert.equal(await page.locator('.decides .taken').count(), 0);
  await set(page, {time: decided + 0.01});
  const taken = await page.locator('.decides .taken').allInnerTexts();
  assert.deepEqual(taken.map(line => line.trim()),
                   ["return { what = 'raise', colour = 3, branch = 3 }"]);
  assert.match(await page.locator('.pane').innerText(), /branch 3; told: top Q3, level 0/);
  await close();
});

test('forces are drawn to a scale that the legend tells', async () => {
  const {page, close} = await open('out.html');
  await set(page, {time: 1});
  assert.ok(await page.locator('.forces').isHidden());
  await page.keyboard.press('7');
  await still(page);
  assert.match(await page.locator('.forces').innerText(), /of contacts; 10 cm are [0-9.]+ N\s+of magnets/);
  // Contacts of the robot's wheels with the floor: upward, together its weight by the legend.
  const {sum, arrows} = await page.evaluate(() => {
    const {run, marks} = window.stigView.views[0];
    const own = new Set(run.robots[0].bodies);
    let up = 0;
    for (const [body, {times, texts}] of run.contacts) {
      const at = times.filter(time => time <= 1).length - 1;
      for (const row of own.has(body) ? JSON.parse(texts[at]) : []) if (row[0] < 0) up += row[6] / 10;
    }
    return {sum: up, arrows: marks.within.geometry.getAttribute('position').count};
  });
  assert.ok(sum > 3 && sum < 30, `weight of a robot: ${sum} N`);
  assert.ok(arrows >= 5 * 2 * 4, `a shaft and four lines of a head, four wheels: ${arrows}`);
  await page.keyboard.press('7');
  assert.ok(await page.locator('.forces').isHidden());
  await close();
});

test('the pane has what the camera makes out, sensors over time, radio and log', async () => {
  const {page, close} = await open('out.html');
  await set(page, {time: await sees(page)});
  const tags = await page.locator('.camera polygon').count();
  assert.ok(tags > 0, 'it sees the brick of the start');
  assert.match(await page.locator('.camera .count').innerText(), new RegExp(`^${tags} tags`));
  const names = await page.locator('.plot > span:first-child').allInnerTexts();
  for (const name of ['placed', 'lift', 'charge', 'left wheel', 'range 1']) {
    assert.ok(names.includes(name), name);
  }
  const lift = page.locator('.plot', {hasText: 'lift'}).locator('svg');
  const {width, height} = await lift.boundingBox();
  await lift.click({position: {x: width / 2, y: height / 2}});
  const {time} = await choices(page);
  assert.ok(Math.abs(time - 55) < 1, `half of 110 s: ${time}`);
  const sent = await page.evaluate(() => {
    const [[, said]] = window.stigView.page.runs[0].senses;
    return said.times[said.texts.findIndex(text => text.includes('"sent"'))];
  });
  await set(page, {time: sent + 0.01});
  assert.match(await page.locator('.pane').innerText(), /sends\s+nfc: \d/);
  await close();
});

test('frusta, rays, ways, messages and magnets are drawn by keys', async () => {
  const {page, close} = await open('out.html');
  await set(page, {time: await sees(page)});
  await still(page);
  assert.deepEqual(await drawn(page), [0, 0]);
  const frames = [];
  for (const key of ['u', 'h', 'j', 'm']) {
    await page.keyboard.press(key);
    await still(page);
    frames.push((await drawn(page)).reduce((a, b) => a + b));
  }
  // Twelve edges of a frustum, of two ends each; eight magnets of a block.
  assert.ok(frames[0] >= 24 && frames.every((n, i) => i === 0 || n > frames[i - 1]), frames.join());
  assert.deepEqual((await choices(page)).marks, ['frusta', 'ranges', 'ways', 'magnets']);
  for (const key of ['u', 'h', 'j', 'm']) await page.keyboard.press(key);
  await still(page);
  assert.deepEqual(await drawn(page), [0, 0]);
  await close();
});

test('a robot\'s own camera has its detections where the tags are drawn', async () => {
  const {page, close} = await open('out.html');
  await set(page, {time: await sees(page)});
  await page.keyboard.press('y');
  await still(page);
  assert.equal((await choices(page)).eyes, 0);
  const pairs = await page.evaluate(() => {
    const {camera, stage} = window.stigView;
    const polygons = [...document.querySelectorAll('.eyes polygon')];
    const box = stage.canvas.getBoundingClientRect();
    // Faces of blocks that look to the robot, in the middle of which there is a tag each.
    const {run} = window.stigView.views[0];
    const now = window.stigView.state.now.time;
    const point = camera.position;
    return polygons.map(polygon => {
      const {x, y, width, height} = polygon.getBoundingClientRect();
      const [u, v] = [x + width / 2, y + height / 2];
      let nearest = Infinity;
      run.bodies.forEach((body, i) => {
        const pose = body.block ? run.tracks.at(i, now) : null;
        if (!pose) return;
        for (const axis of [0, 1, 2]) {
          for (const sign of [-1, 1]) {
            const face = point.clone().set(0, 0, 0).setComponent(axis, sign * body.half[axis]);
            face.applyQuaternion(camera.quaternion.clone().set(...pose.q));
            face.add(point.clone().set(...pose.p));
            face.project(camera);
            nearest = Math.min(nearest, Math.hypot(
                box.left + (face.x + 1) / 2 * box.width - u,
                box.top + (1 - face.y) / 2 * box.height - v));
          }
        }
      });
      return nearest;
    });
  });
  assert.ok(pairs.length > 0 && pairs.every(pixels => pixels < 12), pairs.join());
  await page.keyboard.press('y');
  assert.equal((await choices(page)).eyes, null);
  await still(page);
  assert.equal(await page.locator('.eyes.on').count(), 0);
  await close();
});

test('LEDs are lit in the colours of the palette that is chosen', async () => {
  const {page, close} = await open('out.html');
  // The brick of the start shows Q3.
  const tint = () => page.evaluate(() => {
    const {run, meshes} = window.stigView.views[0];
    const lit = run.bodies.findIndex(body => body.block && body.led === '3');
    return {is: meshes[lit].material.color.getHexString(), own: run.bodies[lit].color};
  });
  const {is: before, own} = await tint();
  await page.locator('select[aria-label=palette]').selectOption('okabe-ito');
  await still(page);
  const byte = (text, i) => parseInt(text.slice(1 + 2 * i, 3 + 2 * i), 16);
  const mixed = [0, 1, 2].map(i => Math.round(0.4 * byte(own, i) + 0.6 * byte('#009e73', i)));
  assert.equal((await tint()).is, mixed.map(x => x.toString(16).padStart(2, '0')).join(''));
  await page.keyboard.press('p');
  await page.keyboard.press('p');
  await still(page);
  assert.equal((await tint()).is, before);
  await close();
});

test('a link leads to the same robot and the same marks', async () => {
  const {page, close} = await open('out.html', {hash: '#t=20&marks=ways,frusta,none&eyes=1&follow=1'});
  const {marks, eyes, follow, time} = await choices(page);
  assert.deepEqual([marks, eyes, follow, time], [['frusta', 'ways'], 0, 0, 20]);
  await page.keyboard.press('k');
  assert.match(await page.evaluate(() => location.hash), /marks=frusta,ways&follow=1&eyes=1/);
  await close();
});

test('a trace without details shows what it has, and says what it has not', async () => {
  const {page, close} = await open('plain.html', {width: 390, height: 780, dark: true});
  assert.match(await page.locator('.pane').innerText(), /--trace-detail/);
  assert.equal(await page.locator('.marks .never').count(), 4);
  await page.keyboard.press('u');
  await until(page, () => window.stigView.views[0].marks.object.visible);
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
  await close();
});

test('a run that has fewer robots than are followed is shown all the same', async () => {
  stigc(['view', 'out', 'plain.stigp', '-o', 'both.html']);
  const {page, close} = await open('both.html', {hash: '#follow=9'});
  const frames = () => page.evaluate(() => window.stigView.stage.frames);
  await still(page);
  assert.ok(await frames() > 0);
  const before = await frames();
  await page.keyboard.press('n');
  await still(page);
  assert.ok(await frames() > before);
  await close();
});
