// SPDX-License-Identifier: MIT
// The bar above the editor: which set, how it is run, and what is done with it.
import {button, element, select} from '../elements.js';
import type {NamedText} from './files.js';
import {kMotions, kNumbers, problemOf, settingsFrom, unusual, type NumberField, type Settings} from
  './settings.js';

export interface Deeds {
  start: (set: NamedText) => void;
  run: () => void;
  verify: () => void;
  compile: () => void;
  synth: () => void;
  stop: () => void;
  link: () => void;
  help: () => void;
  /** One of kSaved. */
  save: (ending: string) => void;
}

const kSaved = [
  {value: 'yaml', text: 'rules (.yaml)'},
  ...['json', 'vox', 'txt', 'stl', 'ply', 'glb', 'svg'].map(
      ending => ({value: ending, text: `structure (.${ending})`})),
  {value: 'stigt', text: 'trace (.stigt)'},
  {value: 'second', text: 'trace of the other run (.stigt)'},
  {value: 'cert', text: 'certificate of the proof'},
  {value: 'png', text: 'picture (.png)'},
  {value: 'html', text: 'this page with this set (.html)'},
];

function numberField({key, title, usual, least, most}: NumberField, onChange: () => void):
    HTMLInputElement {
  const out = element('input', {type: 'number', label: key, title,
                                value: usual === null ? '' : String(usual)});
  [out.min, out.max, out.placeholder] = [String(least), String(most), 'auto'];
  out.addEventListener('change', onChange);
  return out;
}

function named(name: string, field: HTMLElement): HTMLLabelElement {
  return element('label', {}, `${name} `, field);
}

/** A list whose first line is what it is for, and which is back there after every choice. */
function menu(text: string, choices: {value: string; text: string}[],
              onChoice: (value: string) => void): HTMLSelectElement {
  const out = select(text, [{value: '', text: `${text}…`}, ...choices], value => {
    out.value = '';
    if (value) onChoice(value);
  });
  return out;
}

export class Controls {
  readonly bar: HTMLElement;
  private readonly motion: HTMLSelectElement;
  private readonly box = element('input', {type: 'text', label: 'box', value: '', title:
      'size of the world of runs: X,Y,Z, or none with event motion; the file’s where left out'});
  private readonly numbers = new Map<string, HTMLInputElement>();
  private readonly more = element('details', {class: 'more'});
  private readonly stop: HTMLButtonElement;

  constructor(sets: readonly NamedText[], deeds: Deeds) {
    const choices = sets.map(({name}) => ({value: name, text: name.replace('.yaml', '')}));
    const start = menu('start from', choices, name => {
      const set = sets.find(one => one.name === name);
      if (set) deeds.start(set);
    });
    const again = (): void => {
      this.suitMotion();
      deeds.run();
    };
    this.motion = select('motion', kMotions.map(m => ({value: m, text: m})), again);
    this.box.placeholder = 'auto';
    this.box.addEventListener('change', again);
    for (const field of kNumbers) this.numbers.set(field.key, numberField(field, again));
    this.more.append(element('summary', {text: 'more', title: 'more options'}),
                     named('box', this.box), ...this.labels(false));
    this.stop = button('Stop', 'end what is being worked on', deeds.stop);
    this.stop.disabled = true;
    this.bar = element('header', {class: 'bar'}, element('h1', {text: 'stigc playground'}), start,
        this.motion, ...this.labels(true), this.more,
        button('Run', 'let the agents build (Ctrl+Enter)', deeds.run),
        button('Verify', 'does every order of events end alike?', deeds.verify),
        button('Compile', 'what a robot would do where', deeds.compile),
        button('Synthesise', 'rules of one colour for the structure on show', deeds.synth),
        this.stop, menu('save', kSaved, deeds.save),
        button('Link', 'an address that holds this rule set', deeds.link),
        button('?', 'keys of the page (?)', deeds.help));
  }

  private labels(always: boolean): HTMLLabelElement[] {
    return kNumbers.filter(field => (field.always ?? false) === always)
        .map(({key}) => named(key, this.field(key)));
  }

  private field(key: string): HTMLInputElement {
    const found = this.numbers.get(key);
    if (!found) throw new Error(`there is no field '${key}'`);
    return found;
  }

  /** Events have no agents that could move. */
  private suitMotion(): void {
    for (const key of ['agents', 'moves']) this.field(key).disabled = this.motion.value === 'event';
  }

  /** What is wrong with the fields, a line each; empty: nothing. */
  get problems(): string {
    const of = (field: NumberField): string => {
      const {value, validity, disabled} = this.field(field.key);
      if (disabled) return '';
      return validity.badInput ? `${field.key}: this is not a number` : problemOf(field, value);
    };
    return kNumbers.map(of).filter(text => text !== '').join('\n');
  }

  get settings(): Settings {
    const texts: Record<string, string> = {motion: this.motion.value, box: this.box.value};
    return settingsFrom(name => texts[name] ?? this.field(name).value);
  }

  set settings(settings: Settings) {
    this.motion.value = settings.motion;
    this.box.value = settings.box;
    for (const {key} of kNumbers) this.field(key).value = String(settings[key] ?? '');
    const hidden: string[] = kNumbers.filter(field => !field.always).map(({key}) => key);
    // What is not as usual is not hidden.
    if (unusual(settings).some(([name]) => name === 'box' || hidden.includes(name))) {
      this.more.open = true;
    }
    this.suitMotion();
  }

  set busy(yes: boolean) {
    this.stop.disabled = !yes;
  }
}
