// SPDX-License-Identifier: MIT
// What the module answers, as far as the page looks into it.

export interface Note {
  message: string;
  line?: number;
}

/** Lines and columns count from 1, columns in code points. */
export interface Diagnostic {
  code: string;
  severity: 'error' | 'warning';
  line: number;
  column: number;
  end_line: number;
  end_column: number;
  message: string;
  suggestion?: string;
  notes: Note[];
}

/** The data of a page of the viewer; columns in base64. */
export interface ViewData {
  json: unknown;
  columns: string;
}

export interface Answer {
  diagnostics?: Diagnostic[];
  /** Why there is nothing else, when no diagnostic says it. */
  problem?: string;
  /** In the program's own words. */
  text?: string;
  view?: ViewData;
  /** Of a run: the stage that it reached. */
  stage?: number;
  files?: {json: string; stigt: string};
  /** Of structure: in base64. */
  file?: string;
  traces?: {name: string; stigt: string}[];
  certificate?: string;
  /** Of compile. */
  builds?: boolean;
  /** Of synth: a rule set. */
  rules?: string;
}

export type Question = Record<string, unknown> & {do: string};
