// SPDX-License-Identifier: MIT
// A rule set, and how it is run, as the part of an address behind '#': a link is all that it takes
// to hand on either.
import {deflateSync, inflateSync, strFromU8, strToU8} from 'fflate';

export interface Shared {
  text: string;
  motion: string;
  agents: number;
  seed: number;
}

/** A text of no more than what a rule file may have; a link can hold anything. */
const kMost = 1 << 20;

export function hashOfShared({text, motion, agents, seed}: Shared): string {
  const packed = deflateSync(strToU8(text), {level: 9});
  let binary = '';
  for (const byte of packed) binary += String.fromCharCode(byte);
  const set = btoa(binary).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
  return `#set=${set}&motion=${motion}&agents=${agents}&seed=${seed}`;
}

function whole(text: string | null, usual: number, most: number): number {
  const value = Number(text ?? usual);
  return Number.isInteger(value) && value >= 0 && value <= most ? value : usual;
}

/** What an address says; null where it says nothing, or what makes no sense. */
export function sharedOfHash(hash: string): Shared | null {
  const given = new URLSearchParams(hash.replace(/^#/, ''));
  const set = given.get('set');
  if (!set) return null;
  try {
    const binary = atob(set.replaceAll('-', '+').replaceAll('_', '/'));
    const bytes = inflateSync(Uint8Array.from(binary, c => c.charCodeAt(0)),
                              {out: new Uint8Array(kMost)});
    return {
      text: strFromU8(bytes),
      motion: ['walk', 'teleport', 'event'].find(m => m === given.get('motion')) ?? 'walk',
      agents: whole(given.get('agents'), 10, 1e6),
      seed: whole(given.get('seed'), 1, Number.MAX_SAFE_INTEGER),
    };
  } catch {
    return null;
  }
}
