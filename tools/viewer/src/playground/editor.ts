// SPDX-License-Identifier: MIT
// The editor of rule sets.
import {autocompletion, completionKeymap} from '@codemirror/autocomplete';
import {defaultKeymap, history, historyKeymap, indentWithTab} from '@codemirror/commands';
import {bracketMatching, syntaxHighlighting} from '@codemirror/language';
import {EditorState, Prec} from '@codemirror/state';
import {EditorView, drawSelection, highlightActiveLine, keymap, lineNumbers} from
  '@codemirror/view';
import {classHighlighter} from '@lezer/highlight';
import {completer} from './completion.js';
import {messages} from './messages.js';
import type {Schema} from './schema_path.js';
import {yaml} from './yaml_language.js';

export interface EditorWishes {
  parent: HTMLElement;
  schema: () => Schema | null;
  /** After every change of the text. */
  onChange: () => void;
  onRun: () => void;
}

export function makeEditor({parent, schema, onChange, onRun}: EditorWishes): EditorView {
  const label = EditorView.contentAttributes.of({'aria-label': 'rule set', 'spellcheck': 'false'});
  const changes = EditorView.updateListener.of(update => {
    if (update.docChanged) onChange();
  });
  const run = Prec.highest(keymap.of([{key: 'Mod-Enter', run: () => (onRun(), true)}]));
  return new EditorView({
    parent,
    state: EditorState.create({
      extensions: [
        lineNumbers(), history(), drawSelection(), highlightActiveLine(), bracketMatching(), yaml(),
        syntaxHighlighting(classHighlighter), autocompletion({override: [completer(schema)]}),
        keymap.of([...completionKeymap, ...defaultKeymap, ...historyKeymap, indentWithTab]),
        messages, changes, label, run,
      ],
    }),
  });
}

/** Another text in place of what is there; one step of undo. */
export function setText(view: EditorView, text: string): void {
  view.dispatch({changes: {from: 0, to: view.state.doc.length, insert: text}});
}
