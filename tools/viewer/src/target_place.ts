// SPDX-License-Identifier: MIT
// Where a target is laid: turned about the vertical and moved so that most of its bricks are where
// those of a structure are. Of places alike that which moves it least is taken.
import type {Cells} from './bricks.js';
import type {Triple} from './cells.js';

/** Quarter turns about z, then a move. */
export interface Place {
  turns: number;
  move: Triple;
}

/** Pairs of cells beyond which corners alone are laid upon each other. */
const kMostPairs = 4_000_000;

export function turned(x: number, y: number, turns: number): [number, number] {
  switch (turns % 4) {
    case 1: return [-y, x];
    case 2: return [-x, -y];
    case 3: return [y, -x];
    default: return [x, y];
  }
}

export function placed([x, y, z]: Triple, {turns, move}: Place): Triple {
  const [u, v] = turned(x, y, turns);
  return [u + move[0], v + move[1], z + move[2]];
}

function cornerOf(cells: readonly Triple[]): Triple {
  return cells.reduce<Triple>((a, b) => [Math.min(a[0], b[0]), Math.min(a[1], b[1]),
                                         Math.min(a[2], b[2])], [Infinity, Infinity, Infinity]);
}

/** The move on which most pairs agree, and how many do. */
function bestMove(target: readonly Triple[], there: readonly Triple[], up: number):
    {move: Triple; votes: number} {
  const votes = new Map<string, number>();
  let best: {move: Triple; votes: number} = {move: [0, 0, up], votes: 0};
  const size = ([x, y]: Triple): number => Math.abs(x) + Math.abs(y);
  for (const [a, b, c] of there) {
    for (const [x, y, z] of target) {
      if (z + up !== c) continue;
      const move: Triple = [a - x, b - y, up], key = `${move[0]} ${move[1]}`;
      const count = (votes.get(key) ?? 0) + 1;
      votes.set(key, count);
      const better = count > best.votes || count === best.votes && size(move) < size(best.move);
      if (better) best = {move, votes: count};
    }
  }
  return best;
}

/** `turns`: may it be turned? Hexagonal cells are only moved. */
export function placeOf(target: readonly Triple[], there: readonly Triple[], turns: boolean):
    {place: Place; fit: number} {
  const low = cornerOf(target), other = cornerOf(there);
  const nowhere = target.length === 0 || there.length === 0;
  if (nowhere) return {place: {turns: 0, move: [0, 0, 0]}, fit: 0};
  const up = other[2] - low[2];
  if (target.length * there.length > kMostPairs) {
    return {place: {turns: 0, move: [other[0] - low[0], other[1] - low[1], up]}, fit: 0};
  }
  let best: {place: Place; fit: number} = {place: {turns: 0, move: [0, 0, up]}, fit: -1};
  for (let turn = 0; turn < (turns ? 4 : 1); ++turn) {
    const cells = target.map(([x, y, z]): Triple => [...turned(x, y, turn), z]);
    const {move, votes} = bestMove(cells, there, up);
    if (votes > best.fit) best = {place: {turns: turn, move}, fit: votes};
  }
  return best;
}

export function triplesOf({x, y, z}: Cells): Triple[] {
  return Array.from(x, (_, i): Triple => [x[i], y[i], z[i]]);
}
