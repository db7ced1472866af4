// SPDX-License-Identifier: MIT
// Time, camera and what is shown, as the part of an address behind '#', so that a link leads to
// the same view of the same file.
import {kColourings, kPalettes} from './colours.js';
import {kCuts, kMarks, type Choices} from './view_state.js';

function numbers(text: string | null): number[] {
  const list = (text ?? '').split(',').map(Number);
  return text !== null && list.every(Number.isFinite) ? list : [];
}

export function hashOf(choices: Readonly<Choices>, camera: readonly number[]): string {
  const out = new URLSearchParams();
  const short = (x: number): string => String(Number(x.toPrecision(6)));
  out.set('t', short(choices.time));
  out.set('camera', camera.map(short).join());
  if (choices.run > 0) out.set('run', String(choices.run + 1));
  for (const flag of ['side', 'ghost', 'difference', 'orthographic'] as const) {
    if (choices[flag]) out.set(flag, '1');
  }
  if (Number.isFinite(choices.low)) out.set('low', String(choices.low));
  if (Number.isFinite(choices.high)) out.set('high', String(choices.high));
  if (choices.apart > 0) out.set('apart', short(choices.apart));
  if (choices.cut !== 'none') {
    out.set('cut', choices.cut);
    out.set('cutat', short(choices.cutAt));
  }
  if (!choices.target) out.set('target', '0');
  if (choices.colouring !== 'brick') out.set('by', choices.colouring);
  if (choices.palette !== 'file') out.set('palette', choices.palette);
  if (choices.marks.length > 0) out.set('marks', choices.marks.join());
  if (choices.robot > 0) out.set('robot', String(choices.robot + 1));
  if (choices.follow !== null) out.set('follow', String(choices.follow + 1));
  if (choices.eyes !== null) out.set('eyes', String(choices.eyes + 1));
  if (choices.hidden.length > 0) out.set('hidden', choices.hidden.join());
  return `#${out.toString().replaceAll('%2C', ',')}`;
}

/** What a link says; anything that makes no sense is passed over. */
export function choicesOf(hash: string): {choices: Partial<Choices>; camera: number[]} {
  const given = new URLSearchParams(hash.replace(/^#/, ''));
  const choices: Partial<Choices> = {};
  for (const [key, name] of [['t', 'time'], ['low', 'low'], ['high', 'high'],
                             ['apart', 'apart'], ['cutat', 'cutAt']] as const) {
    const value = numbers(given.get(key)).at(0);
    if (value !== undefined) choices[name] = value;
  }
  const run = numbers(given.get('run')).at(0);
  if (run !== undefined) choices.run = Math.round(run) - 1;
  for (const flag of ['side', 'ghost', 'difference', 'orthographic'] as const) {
    if (given.get(flag) === '1') choices[flag] = true;
  }
  const colouring = kColourings.find(name => name === given.get('by'));
  if (colouring) choices.colouring = colouring;
  const palette = kPalettes.find(name => name === given.get('palette'));
  if (palette) choices.palette = palette;
  if (given.has('hidden')) choices.hidden = numbers(given.get('hidden'));
  const cut = kCuts.find(name => name === given.get('cut'));
  if (cut) choices.cut = cut;
  if (given.get('target') === '0') choices.target = false;
  const marks = given.get('marks')?.split(',') ?? [];
  if (marks.length > 0) choices.marks = kMarks.filter(mark => marks.includes(mark));
  for (const key of ['robot', 'follow', 'eyes'] as const) {
    const value = numbers(given.get(key)).at(0);
    if (value !== undefined && value >= 1) choices[key] = Math.round(value) - 1;
  }
  const camera = numbers(given.get('camera'));
  return {choices, camera: camera.length === 6 ? camera : []};
}
