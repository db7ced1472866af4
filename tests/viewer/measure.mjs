// SPDX-License-Identifier: MIT
// What pages of large structures cost: how long they take to open and to turn where software draws,
// and whether anything is drawn while nothing moves. Prints a table; `run.sh measure`.
import fs from 'node:fs';
import path from 'node:path';
import {folder, open, startBrowser, stigc, still, stopBrowser} from './browser.mjs';

const kOpenings = 5, kTurns = 40;

/** A cube of bricks, or every other one of them, of four colours. */
function cube(side, sparse) {
  const cells = [];
  for (let z = 0; z < side; ++z) {
    for (let y = 0; y < side; ++y) {
      for (let x = 0; x < side; ++x) {
        if (!sparse || (x + y + z) % 2 === 0) cells.push(`[${x}, ${y}, ${z}, ${1 + (x + z) % 4}]`);
      }
    }
  }
  const bricks = ['#cc3333', '#33aa33', '#3333cc', '#ccaa33'].map((color, i) =>
    `{"symbol": "${i + 1}", "name": "kind ${i + 1}", "color": "${color}"}`);
  return {count: cells.length,
          text: `{"stigc_structure": 1, "lattice": "cubic", "bricks": [${bricks}],` +
              ` "cells": [${cells.join(',\n')}]}`};
}

function made(name, side, sparse) {
  const {count, text} = cube(side, sparse);
  fs.writeFileSync(path.join(folder, `${name}.json`), text);
  stigc(['view', `${name}.json`, '-o', `${name}.html`]);
  return count;
}

const median = numbers => numbers.toSorted((a, b) => a - b)[Math.floor(numbers.length / 2)];

/** s, from the request to the first frame that is on the screen. */
async function openingTime(name) {
  const begun = performance.now();
  const {page, close} = await open(`${name}.html`, {width: 1280, height: 800});
  await page.evaluate(() => new Promise(done => requestAnimationFrame(() => done())));
  const seconds = (performance.now() - begun) / 1000;
  await close();
  return seconds;
}

/** ms a frame while it turns, ms of one when it is still, frames that nobody asked for. */
async function turning(name) {
  const {page, close} = await open(`${name}.html`, {width: 1280, height: 800});
  await still(page);
  const times = await page.evaluate(async turns => {
    const {viewpoint, stage} = window.stigView;
    const out = [];
    for (let i = 0; i < turns; ++i) {
      const before = stage.frames, begun = performance.now();
      viewpoint.turn(0.05, 0, 1);
      while (stage.frames === before) await new Promise(done => requestAnimationFrame(() => done()));
      await new Promise(done => setTimeout(done));
      out.push(performance.now() - begun);
    }
    return out;
  }, kTurns);
  await still(page);
  const before = await page.evaluate(() => window.stigView.stage.frames);
  await page.waitForTimeout(3000);
  const idle = await page.evaluate(() => window.stigView.stage.frames) - before;
  const faces = await page.evaluate(() => window.stigView.views[0].facesDrawn);
  await close();
  return {frame: median(times.slice(4)), idle, faces};
}

async function row(name, side, sparse) {
  const bricks = made(name, side, sparse);
  const times = [];
  for (let i = 0; i < kOpenings; ++i) times.push(await openingTime(name));
  const {frame, idle, faces} = await turning(name);
  const megabytes = fs.statSync(path.join(folder, `${name}.html`)).size / 1e6;
  const [least, most] = [Math.min(...times), Math.max(...times)];
  console.log(`| ${name}: ${bricks} bricks, ${faces} faces | ${megabytes.toFixed(1)} MB | ` +
              `${median(times).toFixed(2)} s (${least.toFixed(2)} to ${most.toFixed(2)}) | ` +
              `${frame.toFixed(0)} ms | ${idle} |`);
}

await startBrowser();
console.log('| structure | page | opens in | a frame while it turns | frames drawn in 3 s at rest |');
console.log('|---|---|---|---|---|');
await row('solid', 47, false);
await row('sparse', 59, true);
await row('million', 126, true);
await stopBrowser();
