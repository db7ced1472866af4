// SPDX-License-Identifier: MIT
// What robots and blocks of a physical run have, as lib/view/pose_devices.h writes it.
import type {Triple} from './cells.js';

export interface CameraDevice {
  name: string;
  body: number;
  /** Pose on its body: z ahead, x right, y down. */
  p: [number, number, number];
  q: [number, number, number, number];
  /** Of the picture and of the lens, in pixels. */
  size: [number, number];
  focal: [number, number];
  centre: [number, number];
  /** Of what it sees: four near ones, four far ones, in its own frame; or none. */
  corners: Triple[];
}

export interface RangeDevice {
  name: string;
  body: number;
  from: Triple;
  way: Triple;
  /** m */
  range: number;
  /** Of its readings, as robots/device_rangefinder.h has them: none, metres; of two, a v^b; of
      three, a polynomial of v; v = exp(-metres). */
  calibration: number[];
}

/** The distance that a rangefinder tells, m; its range where it tells of nothing. */
export function distanceOf({range, calibration: c}: RangeDevice, told: number): number {
  if (c.length === 0) return Math.min(told, range);
  if (told <= 0) return range;
  const v = c.length === 2 ? (told / c[0]) ** (1 / c[1]) : rootOf(c, told);
  const way = -Math.log(v);
  return way >= 0 && way < range ? way : way < 0 ? 0 : range;
}

/** Of c0 + c1 v + c2 v² = told, the one between 0 and 1, on which it rises. */
function rootOf([c0, c1, c2]: number[], told: number): number {
  const inner = Math.max(c1 * c1 - 4 * c2 * (c0 - told), 0);
  return c2 === 0 ? (told - c0) / c1 : (-c1 + Math.sqrt(inner)) / (2 * c2);
}

export interface RadioDevice {
  name: string;
  body: number;
  at: Triple;
  range: number;
}

export interface RobotDevices {
  name: string;
  root: number;
  period: number;
  /** Index into the programs, or -1. */
  program: number;
  cameras: CameraDevice[];
  ranges: RangeDevice[];
  radios: RadioDevice[];
}

export interface ChartState {
  state: string;
  /** The behaviour of programs/mission. */
  does: string;
  /** Events, and the states that they lead to. */
  to: [string, string][];
}

export interface Program {
  chart: ChartState[];
  /** Its decisions as text, from a line of the program on. */
  decides: {line: number; text: string};
}

export interface Devices {
  robots: RobotDevices[];
  programs: Program[];
  /** Places of magnets in a block, by kind of block. */
  magnets: Triple[][];
  /** By body: its kind of block, or -1. */
  blocks: number[];
}

export const kNoDevices: Devices = {robots: [], programs: [], magnets: [], blocks: []};
