// SPDX-License-Identifier: MIT
// The playground's page from disk, in a real browser: typing, running, asking, saving, sharing.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import {after, before, test} from 'node:test';
import {folder, open, placeOf, startBrowser, stigc, still, stopBrowser, until} from './browser.mjs';

before(async () => {
  fs.copyFileSync(path.join(process.env.PLAYGROUND, 'playground.html'),
                  path.join(folder, 'playground.html'));
  await startBrowser();
});
after(stopBrowser);

const start = options => open('playground.html', {width: 1280, height: 800, ...options});
const said = page => page.locator('.said').innerText();
const press = (page, name) => page.getByRole('button', {name, exact: true}).click();
const bricks = page => page.evaluate(() => window.stigView.views[0].run.bricks.count);

/** Begins with a shipped set; waits until its run is on show. */
async function choose(page, set) {
  await page.locator('select[aria-label="start from"]').selectOption(`${set}.yaml`);
  for (let tries = 0; !(await said(page)).startsWith(`${set}:`); ++tries) {
    assert.ok(tries < 600, `${set} is never run`);
    await page.waitForTimeout(50);
  }
}

/** The file that the page hands out. */
async function saved(page, what, ending) {
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.locator('select[aria-label="save"]').selectOption(what)]);
  const file = path.join(folder, `saved-${what}.${ending}`);
  await download.saveAs(file);
  return file;
}

/** The editor with the cursor behind a line that begins so. */
async function goToEndOf(page, line) {
  await page.evaluate(wanted => {
    const {editor} = window.stigPlayground;
    const {doc} = editor.state;
    for (let n = 1; n <= doc.lines; ++n) {
      if (!doc.line(n).text.startsWith(wanted)) continue;
      editor.dispatch({selection: {anchor: doc.line(n).to}, scrollIntoView: true});
    }
    editor.focus();
  }, line);
}

async function waitForText(page, selector, wanted) {
  for (let tries = 0;; ++tries) {
    const texts = await page.locator(selector).allInnerTexts();
    if (texts.some(text => wanted.test(text))) return texts;
    assert.ok(tries < 600, `${selector} never says ${wanted}: ${texts.join('|')}`);
    await page.waitForTimeout(50);
  }
}

test('the page opens from disk and runs a set; others are a choice away', async () => {
  const {page, close} = await start();
  await waitForText(page, '.said', /^staircase:/);
  assert.equal(await bricks(page), 6);
  await choose(page, 'stepped-pyramid');
  assert.equal(await bricks(page), 15);
  const native = JSON.parse(stigc(['explore', 'rulesets/stepped-pyramid.yaml', '--json']));
  assert.ok((await said(page)).includes(native.structure_hash));
  // Stepped as everywhere in the viewer.
  await press(page, 'the event before (←)');
  await still(page);
  assert.equal(await page.evaluate(() => window.stigView.state.now.time), 13);
  await close();
});

test('a mistake is shown under its line as it is typed, and goes with it', async () => {
  const {page, close} = await start();
  await waitForText(page, '.said', /^staircase:/);
  await goToEndOf(page, 'lattice: cubic');
  await page.keyboard.type('k');
  await waitForText(page, '.message', /error\[R104\]/);
  const [line, message] = await page.evaluate(() => {
    const found = document.querySelector('.message');
    return [found.previousElementSibling.textContent, found.textContent];
  });
  assert.equal(line, 'lattice: cubick');
  assert.match(message, /cubic/);
  assert.ok(await page.locator('.wrong').count() > 0);
  await page.locator('.message button').first().click();
  await until(page, () => document.querySelectorAll('.message').length === 0);
  assert.ok(await page.evaluate(() => window.stigPlayground.text.includes('lattice: cubic\n')));
  await close();
});

test('what is typed is run at once, with fewer bricks where rules say so', async () => {
  const {page, close} = await start();
  await waitForText(page, '.said', /^staircase:/);
  await page.evaluate(() => {
    const {editor} = window.stigPlayground;
    const text = editor.state.doc.toString();
    const from = text.lastIndexOf('  - name:');
    editor.dispatch({changes: {from, to: text.length, insert: ''}});
  });
  await until(page, () => window.stigView.views[0].run.bricks.count < 6);
  await close();
});

test('words of the schema are offered', async () => {
  const {page, close} = await start();
  await waitForText(page, '.said', /^staircase:/);
  await goToEndOf(page, 'floor: true');
  await page.keyboard.type('\nconfl');
  await waitForText(page, '.cm-tooltip-autocomplete', /conflicts/);
  await page.waitForTimeout(200);
  await page.keyboard.press('Enter');
  await waitForText(page, '.cm-line', /^conflicts: $/);
  await close();
});

test('a click on an empty cell says why nothing is built there', async () => {
  const {page, close} = await start();
  await waitForText(page, '.said', /^staircase:/);
  await still(page);
  // The upper face of the highest brick: the cell above it.
  const top = await page.evaluate(() => {
    const {z} = window.stigView.views[0].run.bricks.cells;
    return z.indexOf(Math.max(...z));
  });
  const {x, y} = await placeOf(page, top);
  await page.mouse.click(x, y);
  await waitForText(page, '.words h2', /at \(0, 0, 3\)/);
  const text = await said(page);
  assert.match(text, /site \(0, 0, 3\), stage 1, sees/);
  assert.match(text, /does not fire/);
  await close();
});

test('a verdict of no shows the two ends side by side', async () => {
  const {page, close} = await start({dark: true});
  await choose(page, 'order-dependent');
  await press(page, 'Verify');
  await waitForText(page, '.said', /REFUTED/);
  await until(page, () => window.stigView.page.runs.length === 2);
  await still(page);
  assert.equal(await page.evaluate(() => window.stigView.state.now.side), true);
  assert.deepEqual(await page.evaluate(() => window.stigView.views.map(v => v.run.bricks.count)),
                   [3, 2]);
  const labels = await page.locator('.labels').innerText();
  assert.match(labels, /one end[^]*another/);
  await close();
});

test('compile says what a robot does, or shows the brick in the way', async () => {
  const {page, close} = await start();
  await waitForText(page, '.said', /^staircase:/);
  await press(page, 'Compile');
  await waitForText(page, '.said', /before the foremost column/);
  await close();
});

test('rules, structure and trace are saved as files of the program', async () => {
  const {page, close} = await start();
  await waitForText(page, '.said', /^staircase:/);
  stigc(['check', await saved(page, 'yaml', 'yaml')]);
  for (const ending of ['json', 'vox', 'txt', 'stl', 'ply', 'glb']) {
    stigc(['explore', 'rulesets/staircase.yaml', '-o', `own.${ending}`]);
    assert.deepEqual(fs.readFileSync(await saved(page, ending, ending)),
                     fs.readFileSync(path.join(folder, `own.${ending}`)), ending);
  }
  assert.match(stigc(['replay', await saved(page, 'stigt', 'stigt')]), /identical/);
  const svg = fs.readFileSync(await saved(page, 'svg', 'svg'), 'utf8');
  assert.match(svg, /^<svg [^]*>Three columns of falling height<[^]*<\/svg>\n$/);
  const root = await page.evaluate(text => {
    const {documentElement: found} = new DOMParser().parseFromString(text, 'image/svg+xml');
    return [found.localName, found.querySelectorAll('polygon').length > 20];
  }, svg);
  assert.deepEqual(root, ['svg', true]);
  await close();
});

test('a picture is saved of what is on show', async () => {
  const {page, close} = await start();
  await waitForText(page, '.said', /^staircase:/);
  await still(page);
  const bytes = fs.readFileSync(await saved(page, 'png', 'png'));
  assert.equal(bytes.subarray(1, 4).toString(), 'PNG');
  // Sizes as the canvas has them, and more in it than one colour.
  const size = await page.evaluate(() => [window.stigView.stage.canvas.width,
                                          window.stigView.stage.canvas.height]);
  assert.deepEqual([bytes.readUInt32BE(16), bytes.readUInt32BE(20)], size);
  assert.ok(bytes.length > 2000, `${bytes.length} bytes`);
  await close();
});

test('the two runs of a verdict of no are traces that the program replays', async () => {
  const {page, close} = await start();
  await choose(page, 'order-dependent');
  // Before there is a second one, the page says so.
  await page.locator('select[aria-label="save"]').selectOption('second');
  await waitForText(page, '.said', /one run alone/);
  await press(page, 'Verify');
  await waitForText(page, '.said', /REFUTED/);
  const placed = await page.evaluate(() => window.stigView.views.map(v => v.run.bricks.count - 1));
  for (const [i, which] of ['stigt', 'second'].entries()) {
    const file = await saved(page, which, 'stigt');
    const {events, identical} = JSON.parse(stigc(['replay', file, '--json']));
    assert.deepEqual([events, identical], [placed[i], true], which);
  }
  await close();
});

test('how a set is run is asked in fields, kept in the address and taken from it', async () => {
  const first = await start();
  await waitForText(first.page, '.said', /^staircase:/);
  await first.page.locator('.more summary').click();
  for (const [name, value] of [['box', '9,9,9'], ['moves', '6'], ['deposits', '4']]) {
    await first.page.locator(`input[aria-label=${name}]`).fill(value);
    await first.page.locator(`input[aria-label=${name}]`).press('Tab');
  }
  await until(first.page, () => window.stigView.views[0].run.bricks.count === 5);
  const hash = await first.page.evaluate(() => location.hash);
  assert.match(hash, /moves=6.*deposits=4.*box=9%2C9%2C9/);
  await first.page.locator('input[aria-label=box]').fill('1e9');
  await first.page.keyboard.press('Tab');
  await waitForText(first.page, '.said', /box: three integers parted by commas/);
  await first.close();
  const second = await start({hash});
  await until(second.page, () => window.stigView.views[0].run.bricks.count === 5);
  assert.ok(await second.page.locator('input[aria-label=box]').isVisible(), 'it is not hidden');
  assert.equal(await second.page.locator('input[aria-label=box]').inputValue(), '9,9,9');
  await second.close();
});

test('keys do what buttons do, and a sheet lists them', async () => {
  const {page, close} = await start();
  await waitForText(page, '.said', /^staircase:/);
  await page.locator('h1').first().click();
  await page.keyboard.press('?');
  await waitForText(page, '.playground > .sheet', /verify/);
  await page.keyboard.press('Escape');
  assert.equal(await page.locator('.playground > .sheet').count(), 0);
  await page.keyboard.press('v');
  await waitForText(page, '.said', /PROVED/i);
  // In the editor letters are letters.
  await page.keyboard.press('e');
  await page.keyboard.press('Control+Home');
  await page.keyboard.type('#?v');
  assert.ok(await page.evaluate(() => window.stigPlayground.text.startsWith('#?v')));
  assert.equal(await page.locator('.playground > .sheet').count(), 0);
  await page.keyboard.press('Control+Enter');
  await waitForText(page, '.words h2', /Run/);
  await close();
});

for (const [what, text] of [
  ['many lines', '# no more than this\n'.repeat(100_000)],
  ['deep nesting', `name: ${'['.repeat(20_000)}`],
  ['bytes of zero', 'stigc: 1\nname: a\0b\n'],
  ['a huge box', 'stigc: 1\nname: a\nlattice: cubic\nbox: {size: [1000000000, 9, 9]}\n'],
]) {
  test(`${what}: the page says what is wrong, and stays awake`, async () => {
    const {page, close} = await start();
    await waitForText(page, '.said', /^staircase:/);
    await page.evaluate(given => {
      const {editor} = window.stigPlayground;
      editor.dispatch({changes: {from: 0, to: editor.state.doc.length, insert: given}});
    }, text);
    await until(page, () => window.stigPlayground.answers.get('check').diagnostics.length > 0);
    await choose(page, 'wall');
    await close();
  });
}

test('an address of garbage is called damaged, and the page works', async () => {
  const {page, close} = await start();
  await waitForText(page, '.said', /^staircase:/);
  await page.evaluate(() => {
    location.hash = '#set=%00%ff&agents=1e99&box=<b>&motion=x';
  });
  await waitForText(page, '.said', /address is damaged/);
  await choose(page, 'wall');
  await close();
});

test('the address holds the set, and how it is run', async () => {
  const first = await start();
  await waitForText(first.page, '.said', /^staircase:/);
  await first.page.locator('input[aria-label=seed]').fill('9');
  await goToEndOf(first.page, 'title:');
  await first.page.keyboard.type(' é');
  await until(first.page, () => location.hash.includes('seed=9'));
  await waitForText(first.page, '.said', /é/);
  await press(first.page, 'Link');
  const [hash, text] = await first.page.evaluate(
      () => [location.hash, window.stigPlayground.text]);
  await first.close();
  const second = await start({hash});
  await waitForText(second.page, '.said', /seed 9/);
  assert.equal(await second.page.evaluate(() => window.stigPlayground.text), text);
  await second.close();
});

test('on a phone nothing is wider than the screen', async () => {
  const {page, close} = await start({width: 390, height: 780});
  await waitForText(page, '.said', /^staircase:/);
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
  await close();
});

test('the page saves itself with the set in it, and the saved page does so, too', async () => {
  const first = await start();
  await choose(first.page, 'stepped-pyramid');
  await goToEndOf(first.page, 'title:');
  await first.page.keyboard.type(' é</script><!--');
  await first.page.locator('input[aria-label=seed]').fill('9');
  await first.page.locator('input[aria-label=seed]').press('Tab');
  await waitForText(first.page, '.said', /seed 9/);
  const text = await first.page.evaluate(() => window.stigPlayground.text);
  const file = await saved(first.page, 'html', 'html');
  await first.close();
  const second = await open(path.basename(file), {width: 1280, height: 800});
  await waitForText(second.page, '.said', /seed 9/);
  assert.equal(await second.page.evaluate(() => window.stigPlayground.text), text);
  assert.equal(await bricks(second.page), 15);
  const bytes = fs.readFileSync(file);
  assert.deepEqual(fs.readFileSync(await saved(second.page, 'html', 'html')), bytes);
  assert.ok(bytes.length < 1.01 * fs.statSync(path.join(folder, 'playground.html')).size + 5000);
  await second.close();
});

test('a number that makes no sense is refused in words, and nothing is run', async () => {
  const {page, close} = await start();
  await waitForText(page, '.said', /^staircase:/);
  const before = await bricks(page);
  const seed = page.getByRole('spinbutton', {name: 'seed', exact: true});
  await seed.fill('-1');
  await press(page, 'Run');
  await waitForText(page, '.said', /^seed: '-1' is not a whole number from 0 to /);
  assert.equal(await bricks(page), before);
  await seed.fill('2');
  await press(page, 'Run');
  await waitForText(page, '.said', /^staircase:/);
  await close();
});
