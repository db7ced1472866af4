// SPDX-License-Identifier: MIT
// What can be written at a place of a rule file, from the schema that the module has (that of
// `stigc schema`).
import type {Completion, CompletionContext, CompletionResult} from '@codemirror/autocomplete';
import {placeAt, resolved, schemaAt, type Place, type Schema} from './schema_path.js';

/** Symbols of the bricks that the file names. */
function symbolsOf(text: string): string[] {
  const block = /^bricks:\s*\n((?: +.*\n|\s*#.*\n)*)/m.exec(`${text}\n`)?.[1] ?? '';
  return [...block.matchAll(/^ +([^\s:#]+) *:/gm)].map(found => found[1].replaceAll('"', ''));
}

function keysAt(schema: Schema, place: Place): Completion[] {
  const wanted = new Set(schema.required);
  return Object.entries(schema.properties ?? {})
      .filter(([key]) => !place.before.includes(key))
      .map(([key, of]) => ({
        label: key,
        type: 'property',
        apply: key === 'when' ? 'when: |\n      ' : `${key}: `,
        info: of.description ?? '',
        detail: wanted.has(key) ? 'must be there' : '',
        boost: wanted.has(key) ? 1 : 0,
      }));
}

function valuesAt(given: Schema, root: Schema, text: string): Completion[] {
  const schema = given.type === 'array' ? resolved(given.items, root) : given;
  const info = given.description ?? '';
  if (schema.enum) return schema.enum.map(word => ({label: String(word), type: 'enum', info}));
  if (schema.const !== undefined) return [{label: String(schema.const), type: 'enum', info}];
  if (schema.type === 'boolean') {
    return ['true', 'false'].map(label => ({label, type: 'keyword', info}));
  }
  // Where examples are symbols, those of the file are better ones.
  if (!schema.examples) return [];
  const known = symbolsOf(text);
  const reserved = schema.examples.map(String).filter(one => /^[.?#=]$/.test(one));
  return [...known, ...reserved].map(label => ({label, type: 'variable', info}));
}

export function completionsAt(root: Schema, text: string, at: number):
    {from: number; options: Completion[]} {
  const place = placeAt(text.slice(0, at));
  const from = at - place.word.length;
  const here = schemaAt(root, place.path);
  if (place.key === null) return {from, options: keysAt(here, place)};
  const value = resolved(here.properties?.[place.key] ??
                         Object.values(here.patternProperties ?? {}).at(0), root);
  return {from, options: valuesAt(value, root, text)};
}

/** `schema`: null until the module has said it. */
export function completer(schema: () => Schema | null) {
  return (context: CompletionContext): CompletionResult | null => {
    const root = schema();
    if (!root) return null;
    const {from, options} = completionsAt(root, context.state.doc.toString(), context.pos);
    // Unasked only where a word has begun, or a value is wanted.
    const wanted = context.state.sliceDoc(Math.max(0, from - 2), from) === ': ';
    const begun = from < context.pos || wanted;
    return options.length > 0 && (begun || context.explicit) ? {from, options} : null;
  };
}
