// SPDX-License-Identifier: MIT
// What the builds of the pages share.
import {createHash} from 'node:crypto';
import path from 'node:path';
import {build} from 'esbuild';

const here = path.dirname(new URL(import.meta.url).pathname);

/** A source of src/ with all that it imports, as one text. */
export async function bundled(name, loader = {}, format = 'iife') {
  const result = await build({
    absWorkingDir: here,
    entryPoints: [path.join('src', name)],
    bundle: true,
    minify: true,
    write: false,
    format,
    target: 'es2022',
    legalComments: 'inline',
    loader,
  });
  return result.outputFiles[0].text.trim();
}

/** Within a script element these would end it. */
export const inScript = text => text.replaceAll('</script', '<\\/script').replaceAll('<!--', '<\\!--');

/** As a content security policy names a text. */
export const hashOf = text => `'sha256-${createHash('sha256').update(text).digest('base64')}'`;
