// SPDX-License-Identifier: MIT
// Palettes, and what bricks are coloured by. Okabe and Ito 2008 ("Color Universal Design") and
// Tol's bright scheme (SRON/EPS/TN/09-002) can be told apart with any kind of colour vision; the
// scale of time is a piecewise line through cividis (Nuñez et al. 2018, PLoS ONE 13:e0199239).
import type {LatticeRun} from './runs.js';

export const kPalettes = ['file', 'okabe-ito', 'tol-bright'] as const;
export type Palette = typeof kPalettes[number];
export const kColourings = ['brick', 'order', 'rule', 'agent'] as const;
export type Colouring = typeof kColourings[number];

export type Rgb = readonly [number, number, number];

const kOkabeIto = ['#0072b2', '#e69f00', '#009e73', '#cc79a7', '#d55e00', '#56b4e9', '#f0e442',
                   '#999999'];
const kTolBright = ['#4477aa', '#ee6677', '#228833', '#ccbb44', '#66ccee', '#aa3377', '#bbbbbb'];
const kCividis = ['#00224e', '#35456c', '#666970', '#948e77', '#c8b866', '#fee838'];

export function rgbOf(text: string): Rgb {
  const value = parseInt(text.slice(1), 16);
  return [value >> 16 & 255, value >> 8 & 255, value & 255];
}

export function cssOf([r, g, b]: Rgb): string {
  return `rgb(${Math.round(r)} ${Math.round(g)} ${Math.round(b)})`;
}

function categorical(palette: Palette, index: number): Rgb {
  const list = palette === 'tol-bright' ? kTolBright : kOkabeIto;
  return rgbOf(list[index % list.length]);
}

/** From dark blue to yellow, for 0 to 1. */
export function scale(share: number): Rgb {
  const at = Math.min(Math.max(share, 0), 1) * (kCividis.length - 1);
  const below = Math.min(Math.floor(at), kCividis.length - 2);
  const [a, b] = [rgbOf(kCividis[below]), rgbOf(kCividis[below + 1])];
  const mix = (i: 0 | 1 | 2): number => a[i] + (b[i] - a[i]) * (at - below);
  return [mix(0), mix(1), mix(2)];
}

/** LEDs that show a colour from 1 on; 0, off, is the same in all palettes. */
export function colourOfLed(led: number, own: Rgb, palette: Palette): Rgb {
  return palette === 'file' || led === 0 ? own : categorical(palette, led - 1);
}

/** Colour k of a run, from 1. */
export function colourOfKind(run: LatticeRun, colour: number, palette: Palette): Rgb {
  if (palette !== 'file') return categorical(palette, colour - 1);
  return rgbOf(run.kinds[colour - 1].color);
}

const kUnknown: Rgb = [150, 150, 150];

export function colourOfRule(rule: number, palette: Palette): Rgb {
  return categorical(palette, rule);
}

/** Three bytes a brick. */
export function brickColours(run: LatticeRun, by: Colouring, palette: Palette): Uint8Array {
  const {count} = run.bricks;
  const placed = Math.max(1, count - run.start - 1);
  const of = (i: number): Rgb => {
    if (by === 'brick') return colourOfKind(run, run.colour[i], palette);
    const event = i - run.start;
    if (event < 0) return kUnknown;
    if (by === 'order') return scale(event / placed);
    if (by === 'rule') return colourOfRule(run.rule[event], palette);
    return run.agent[event] < 0 ? kUnknown : categorical(palette, run.agent[event]);
  };
  const out = new Uint8Array(3 * count);
  for (let i = 0; i < count; ++i) out.set(of(i), 3 * i);
  return out;
}
