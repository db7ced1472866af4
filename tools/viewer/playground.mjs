// SPDX-License-Identifier: MIT
// Builds the playground: playground.html with style, scripts, the module and what ships in it.
//
//   node playground.mjs FOLDER MODULE ROOT      writes FOLDER/playground.html, and for tests
//                                               FOLDER/playground_engine.mjs
import fs from 'node:fs';
import path from 'node:path';
import zlib from 'node:zlib';
import {bundled, hashOf, inScript} from './bundle.mjs';

const [folder, module, root] = process.argv.slice(2);
const here = path.dirname(new URL(import.meta.url).pathname);

const named = name => ({name: path.basename(name),
                        text: fs.readFileSync(path.join(root, name), 'utf8')});
const files = {
  sets: fs.readdirSync(path.join(root, 'rulesets')).sort().map(name => named(`rulesets/${name}`)),
  robot: named('robots/bebot.yaml'),
  block: named('blocks/stigmergic.yaml'),
};

const style = `body{margin:0}${await bundled('playground/playground.css', {'.css': 'css'})}`;
const script = inScript(await bundled('playground/main.ts'));
// Nothing is fetched. The worker is a part of the page, and so is the module that it compiles; the
// editor makes style sheets and sets widths as it goes.
const policy = `default-src 'none'; script-src ${hashOf(script)} 'wasm-unsafe-eval'; ` +
    `worker-src blob:; style-src 'unsafe-inline'; img-src data:; base-uri 'none'; ` +
    `form-action 'none'`;
const parts = {
  POLICY: policy,
  STYLE: style,
  SCRIPT: script,
  WORKER: inScript(await bundled('playground/worker.ts')),
  FILES: JSON.stringify(files).replaceAll('<', '\\u003c'),
  MODULE: zlib.deflateSync(fs.readFileSync(module), {level: 9}).toString('base64'),
};
const page = fs.readFileSync(path.join(here, 'playground.html'), 'utf8')
                 .replace(/@([A-Z]+)@/g, (_, name) => parts[name]);
fs.writeFileSync(path.join(folder, 'playground.html'), page);
fs.writeFileSync(path.join(folder, 'playground_engine.mjs'),
                 await bundled('playground/for_tests.ts', {}, 'esm'));
