// SPDX-License-Identifier: MIT
// What the parts of a live page know of the whole.
import type {LiveState} from './live_run.js';
import type {BodyTracks} from './pose_run.js';
import type {Run} from './runs.js';
import type {Viewer} from './viewer.js';

/** An answer of the server. */
export interface Answer {
  ok: boolean;
  problem?: string;
  checkpoint?: number;
}

export interface Command {
  do: string;
  [key: string]: unknown;
}

export interface LiveLink {
  readonly viewer: Viewer;
  readonly run: Run;
  /** How the run stands; null before the first word of it. */
  readonly now: LiveState | null;
  /** The tracks of a physical run. */
  readonly tracks: BodyTracks | null;
  ask(command: Command): Promise<Answer>;
  /** Runs or pauses. */
  toggle(): void;
  /** The address of something of the server's. */
  address(path: string, given?: Record<string, string>): string;
}
