// SPDX-License-Identifier: MIT
// A rule set, and how it is run, as the part of an address behind '#': a link is all that it takes
// to hand on either.
import {deflateSync, inflateSync, strFromU8, strToU8} from 'fflate';
import {settingsFrom, unusual, type Settings} from './settings.js';

export type Shared = Settings & {text: string};

/** A text of no more than what a rule file may have; a link can hold anything. */
const kMost = 1 << 20;

export function hashOfShared({text, ...settings}: Shared): string {
  const packed = deflateSync(strToU8(text), {level: 9});
  let binary = '';
  for (const byte of packed) binary += String.fromCharCode(byte);
  const set = btoa(binary).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
  const others = unusual(settings).map(([name, value]) => `&${name}=${encodeURIComponent(value)}`);
  return `#set=${set}&motion=${settings.motion}${others.join('')}`;
}

/** What an address says; null where it says nothing of a rule set. */
export function sharedOfHash(hash: string): Shared | 'damaged' | null {
  const given = new URLSearchParams(hash.replace(/^#/, ''));
  const set = given.get('set');
  if (!set) return null;
  try {
    const binary = atob(set.replaceAll('-', '+').replaceAll('_', '/'));
    const bytes = inflateSync(Uint8Array.from(binary, c => c.charCodeAt(0)),
                              {out: new Uint8Array(kMost)});
    return {text: strFromU8(bytes), ...settingsFrom(name => given.get(name))};
  } catch {
    return 'damaged';
  }
}
