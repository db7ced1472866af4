// SPDX-License-Identifier: MIT
// Builds the template of the pages that `stigc view` writes: page.html with style and script in it.
// @TITLE@ and @DATA@ are left to the program.
//
//   node build.mjs FOLDER        writes FOLDER/viewer.html
import fs from 'node:fs';
import path from 'node:path';
import {bundled, hashOf, inScript} from './bundle.mjs';

const folder = process.argv[2];
const here = path.dirname(new URL(import.meta.url).pathname);

const style = `body{margin:0}${await bundled('page.css', {'.css': 'css'})}`;
const script = inScript(await bundled('main.ts'));
// Nothing is fetched, no plug-ins, no frames; the one script is known by its hash.
const policy = `default-src 'none'; script-src ${hashOf(script)}; style-src ${hashOf(style)}; ` +
    `img-src data:; base-uri 'none'; form-action 'none'`;
const parts = {POLICY: policy, STYLE: style, SCRIPT: script};
const page = fs.readFileSync(path.join(here, 'page.html'), 'utf8')
                 .replace(/@(POLICY|STYLE|SCRIPT)@/g, (_, name) => parts[name]);
fs.mkdirSync(folder, {recursive: true});
fs.writeFileSync(path.join(folder, 'viewer.html'), page);
