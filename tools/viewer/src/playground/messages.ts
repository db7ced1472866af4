// SPDX-License-Identifier: MIT
// Diagnostics in the editor: what they are about is underlined, what they say stands below the
// line.
import {StateEffect, StateField, type Range, type Text} from '@codemirror/state';
import {Decoration, EditorView, WidgetType, type DecorationSet} from '@codemirror/view';
import {button, element} from '../elements.js';
import type {Diagnostic} from './answers.js';

/** The place of a line and column, which count from 1, the column in code points. */
export function placeIn(text: Text, line: number, column: number): number {
  if (line > text.lines) return text.length;
  const {from, text: written} = text.line(Math.max(1, line));
  let at = 0;
  for (let i = 1; i < column && at < written.length; ++i) {
    at += (written.codePointAt(at) ?? 0) > 0xffff ? 2 : 1;
  }
  return from + at;
}

class Message extends WidgetType {
  constructor(readonly one: Diagnostic) {
    super();
  }

  override eq(other: Message): boolean {
    return JSON.stringify(other.one) === JSON.stringify(this.one);
  }

  override toDOM(view: EditorView): HTMLElement {
    const {one} = this;
    const out = element('div', {class: `message ${one.severity}`},
                        element('b', {text: `${one.severity}[${one.code}]`}), ` ${one.message} `);
    if (one.suggestion) {
      out.append(button(`write ${one.suggestion}`, 'put this in its place', () => mend(view, one)));
    }
    for (const note of one.notes) {
      const where = note.line ? `line ${note.line}: ` : '';
      out.append(element('div', {class: 'note', text: `${where}${note.message}`}));
    }
    return out;
  }

  override ignoreEvent(): boolean {
    return true;
  }
}

function mend(view: EditorView, one: Diagnostic): void {
  const {doc} = view.state;
  const from = placeIn(doc, one.line, one.column);
  const to = placeIn(doc, one.end_line, one.end_column);
  view.dispatch({changes: {from, to, insert: one.suggestion ?? ''}});
  view.focus();
}

const setMessages = StateEffect.define<readonly Diagnostic[]>();

function decorated(text: Text, all: readonly Diagnostic[]): DecorationSet {
  const out: Range<Decoration>[] = [];
  for (const one of all) {
    const from = placeIn(text, one.line, one.column);
    const to = Math.max(from, placeIn(text, one.end_line, one.end_column));
    const end = Math.min(text.lineAt(from).to, to);
    if (end > from) out.push(Decoration.mark({class: `wrong ${one.severity}`}).range(from, end));
    out.push(Decoration.widget({widget: new Message(one), block: true, side: 1})
                 .range(text.lineAt(from).to));
  }
  return Decoration.set(out, true);
}

/** Stay where they are said of while the text changes, until there are newer ones. */
export const messages = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(now, change) {
    for (const effect of change.effects) {
      if (effect.is(setMessages)) return decorated(change.newDoc, effect.value);
    }
    return now.map(change.changes);
  },
  provide: field => EditorView.decorations.from(field),
});

export function showMessages(view: EditorView, all: readonly Diagnostic[]): void {
  view.dispatch({effects: setMessages.of(all)});
}
