// SPDX-License-Identifier: MIT
// The choice of a palette: of bricks on the lattice, of LEDs in the physical world.
import {kPalettes} from './colours.js';
import {select} from './elements.js';
import type {ViewState} from './view_state.js';

const kPaletteText: Record<string, string> = {
  file: 'colours of the file',
  'okabe-ito': 'Okabe–Ito (colour-blind)',
  'tol-bright': 'Tol bright (colour-blind)',
};

export function paletteSelect(state: ViewState): HTMLSelectElement {
  return select('palette', kPalettes.map(value => ({value, text: kPaletteText[value]})),
                value => state.set({palette: kPalettes.find(p => p === value) ?? 'file'}));
}
