// SPDX-License-Identifier: MIT
// Which part of the schema a place in a rule file belongs to, found from the lines above: while
// somebody types, the file is hardly ever sound.

export interface Schema {
  description?: string;
  type?: string | string[];
  enum?: (string | number)[];
  const?: string | number;
  properties?: Record<string, Schema>;
  patternProperties?: Record<string, Schema>;
  items?: Schema;
  allOf?: Schema[];
  $ref?: string;
  definitions?: Record<string, Schema>;
  examples?: (string | number)[];
  required?: string[];
}

export interface Place {
  /** Keys from the root; '-' is an entry of a list. */
  path: string[];
  /** The key whose value is written, or null where a key is. */
  key: string | null;
  /** What stands of the word so far. */
  word: string;
  /** Keys that are there already, as far as they stand above. */
  before: string[];
}

interface Line {
  indent: number;
  /** Columns of the dashes before the key. */
  dashes: number[];
  key: string | null;
}

function lineOf(text: string): Line {
  const lead = /^ *(?:- +)*/.exec(text)?.[0] ?? '';
  const dashes = [...lead.matchAll(/-/g)].map(found => found.index);
  const key = /^([^\s:#{}[\],"'|]+) *:(?:\s|$)/.exec(text.slice(lead.length))?.[1] ?? null;
  return {indent: lead.length, dashes, key};
}

/** The path of what begins in a column below these lines, and the keys beside it; `entry`: it is
    an entry of a list, whose dash stands there. */
function pathAbove(lines: readonly string[], column: number, entry: boolean):
    {path: string[]; before: string[]} {
  const path: string[] = [], before: string[] = [];
  let within = column, dash = entry;
  for (let i = lines.length; i-- > 0 && (within > 0 || dash || path.length === 0);) {
    if (/^\s*(#|$)/.test(lines[i])) continue;
    const {indent, dashes, key} = lineOf(lines[i]);
    const beside = indent === within && !dash;
    if (beside && key && path.length === 0) before.push(key);
    // A list may begin in the column of its key.
    const same = dash && indent === within && dashes.length === 0;
    const owns = key !== null && (indent < within || same);
    if (owns) path.unshift(key);
    if (owns || beside && dashes.length > 0) {
      within = dashes[0] ?? indent;
      dash = dashes.length > 0;
      if (dash) path.unshift('-');
    }
  }
  return {path, before};
}

/** Within braces that the line opens: the keys before them, and what stands within so far. */
function braces(text: string): {outer: string | null; list: boolean; inner: string} | null {
  let open = -1;
  for (let i = 0, depth = 0; i < text.length; ++i) {
    if (text[i] === '{' && depth++ === 0) open = i;
    if (text[i] === '}' && --depth === 0) open = -1;
  }
  if (open < 0) return null;
  const head = text.slice(0, open);
  const outer = /([^\s:#{}[\],"']+) *: *(\[ *)?$/.exec(head);
  return {outer: outer?.[1] ?? null, list: outer?.[2] !== undefined, inner: text.slice(open + 1)};
}

/** What is written at the end of the text. */
export function placeAt(text: string): Place {
  const lines = text.split('\n');
  const last = lines.pop() ?? '';
  const {indent, dashes} = lineOf(last);
  const {path, before} = pathAbove(lines, dashes[0] ?? indent, dashes.length > 0);
  path.push(...dashes.map(() => '-'));
  const flow = braces(last);
  let written = last.slice(indent);
  if (flow) {
    if (flow.outer) path.push(flow.outer);
    if (flow.list) path.push('-');
    const parts = flow.inner.split(',');
    written = parts.at(-1)?.trimStart() ?? '';
    before.length = 0;
    before.push(...parts.slice(0, -1).map(part => part.split(':')[0].trim()));
  } else if (dashes.length > 0) {
    before.length = 0;
  }
  const value = /^([^\s:#]+) *: +\[?(?:.*, *)?(\S*)$/.exec(written);
  if (value) return {path, key: value[1], word: value[2], before};
  return {path, key: null, word: /\S*$/.exec(written)?.[0] ?? '', before};
}

/** A schema without the references in it. */
export function resolved(schema: Schema | undefined, root: Schema): Schema {
  if (!schema) return {};
  const parts = [...schema.allOf ?? []];
  if (schema.$ref) {
    const name = schema.$ref.split('/').at(-1) ?? '';
    parts.push(root.definitions?.[name] ?? {});
  }
  return parts.reduce((sum: Schema, part) => ({...resolved(part, root), ...sum}), schema);
}

/** The part of the schema at a path. */
export function schemaAt(root: Schema, path: readonly string[]): Schema {
  let now = root;
  for (const step of path) {
    const next: Schema | undefined = step === '-' ? now.items
        : now.properties?.[step] ?? Object.values(now.patternProperties ?? {}).at(0);
    now = resolved(next, root);
  }
  return now;
}
