// SPDX-License-Identifier: MIT
// How a rule set is run and how hard it is thought about: the options of the program that the page
// has fields for. Declared here alone; the bar shows them, the address holds them.

export const kMotions = ['walk', 'teleport', 'event'];

export interface NumberField {
  key: 'agents' | 'seed' | 'moves' | 'steps' | 'deposits' | 'effort';
  title: string;
  /** Null: the program's own, which depends on the rules. */
  usual: number | null;
  least: number;
  most: number;
  /** Is it looked at often enough to be always on show? */
  always?: boolean;
}

export const kNumbers: readonly NumberField[] = [
  {key: 'agents', title: 'how many agents build', usual: 10, least: 1, most: 1e6, always: true},
  {key: 'seed', title: 'of all random choices', usual: 1, least: 0, most: Number.MAX_SAFE_INTEGER,
   always: true},
  {key: 'moves', title: 'neighbours an agent steps to: 6, 18 or 26; hexagonal 8 or 20',
   usual: null, least: 6, most: 26},
  {key: 'steps', title: 'the run stops after so many', usual: null, least: 1, most: 1e12},
  {key: 'deposits', title: 'the run stops after so many bricks', usual: null, least: 1, most: 1e9},
  {key: 'effort', title: 'how much Verify and Synthesise try', usual: 1, least: 1, most: 1e6},
];

export type Settings = Record<NumberField['key'], number | null> & {
  motion: string;
  /** As --box of the program: X,Y,Z or none; empty: the file's, or the program's own. */
  box: string;
};

function isNumberOf({least, most}: NumberField, text: string): boolean {
  const value = Number(text);
  return Number.isInteger(value) && value >= least && value <= most;
}

/** What a text says of a field; the usual where it makes no sense. */
export function numberOf(field: NumberField, text: string | null): number | null {
  return text && isNumberOf(field, text) ? Number(text) : field.usual;
}

/** What is wrong with a field's text; empty: nothing. */
export function problemOf(field: NumberField, text: string): string {
  return text === '' || isNumberOf(field, text)
      ? '' : `${field.key}: '${text}' is not a whole number from ${field.least} to ${field.most}`;
}

/** Settings from texts by name, wherever these come from. */
export function settingsFrom(get: (name: string) => string | null): Settings {
  const numbers = kNumbers.map(field => [field.key, numberOf(field, get(field.key))] as const);
  return {
    motion: kMotions.find(motion => motion === get('motion')) ?? kMotions[0],
    box: (get('box') ?? '').trim().slice(0, 60),
    ...Object.fromEntries(numbers) as Record<NumberField['key'], number | null>,
  };
}

/** Names and texts of all that is not as usual. */
export function unusual(settings: Settings): [string, string][] {
  const numbers = kNumbers.filter(({key, usual}) => settings[key] !== usual)
                      .map(({key}): [string, string] => [key, String(settings[key])]);
  return settings.box ? [...numbers, ['box', settings.box]] : numbers;
}

/** What a question about a run says of it; what is null or empty is left to the program. */
export function runOptions(settings: Settings): Record<string, unknown> {
  return Object.fromEntries(Object.entries(settings).filter(
      ([name, value]) => name !== 'effort' && value !== null));
}
