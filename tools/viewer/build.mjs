// SPDX-License-Identifier: MIT
// Builds the template of the pages that `stigc view` writes: page.html with style and script in it.
// @TITLE@ and @DATA@ are left to the program.
//
//   node build.mjs FOLDER        writes FOLDER/viewer.html
import {createHash} from 'node:crypto';
import fs from 'node:fs';
import path from 'node:path';
import {build} from 'esbuild';

const folder = process.argv[2];
const here = path.dirname(new URL(import.meta.url).pathname);

async function bundled(name, loader) {
  const result = await build({
    absWorkingDir: here,
    entryPoints: [path.join('src', name)],
    bundle: true,
    minify: true,
    write: false,
    format: 'iife',
    target: 'es2022',
    legalComments: 'inline',
    loader,
  });
  return result.outputFiles[0].text.trim();
}

const hash = text => `'sha256-${createHash('sha256').update(text).digest('base64')}'`;

const style = `body{margin:0}${await bundled('page.css', {'.css': 'css'})}`;
// Within a script element these would end it.
const script = (await bundled('main.ts', {})).replaceAll('</script', '<\\/script').replaceAll('<!--', '<\\!--');
// Nothing is fetched, no plug-ins, no frames; the one script is known by its hash.
const policy = `default-src 'none'; script-src ${hash(script)}; style-src ${hash(style)}; ` +
    `img-src data:; base-uri 'none'; form-action 'none'`;
const parts = {POLICY: policy, STYLE: style, SCRIPT: script};
const page = fs.readFileSync(path.join(here, 'page.html'), 'utf8')
                 .replace(/@(POLICY|STYLE|SCRIPT)@/g, (_, name) => parts[name]);
fs.mkdirSync(folder, {recursive: true});
fs.writeFileSync(path.join(folder, 'viewer.html'), page);
