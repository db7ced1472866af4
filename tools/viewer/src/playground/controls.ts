// SPDX-License-Identifier: MIT
// The bar above the editor: which set, how it is run, and what is done with it.
import {button, element, select} from '../elements.js';
import type {NamedText} from './files.js';

export interface Deeds {
  start: (set: NamedText) => void;
  run: () => void;
  verify: () => void;
  compile: () => void;
  synth: () => void;
  stop: () => void;
  link: () => void;
  /** The ending of a file: yaml, json, vox, stigt or cert. */
  save: (ending: string) => void;
}

export interface Settings {
  motion: string;
  agents: number;
  seed: number;
}

const kSaved = [
  {value: 'yaml', text: 'rules (.yaml)'},
  {value: 'json', text: 'structure (.json)'},
  {value: 'vox', text: 'structure (.vox)'},
  {value: 'stigt', text: 'trace (.stigt)'},
  {value: 'cert', text: 'certificate of the proof'},
];

function numberField(label: string, value: number, most: number, onChange: () => void):
    HTMLInputElement {
  const out = element('input', {type: 'number', label, title: label, value: String(value)});
  out.min = label === 'agents' ? '1' : '0';
  out.max = String(most);
  out.addEventListener('change', onChange);
  return out;
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
  private readonly agents: HTMLInputElement;
  private readonly seed: HTMLInputElement;
  private readonly stop: HTMLButtonElement;

  constructor(sets: readonly NamedText[], deeds: Deeds) {
    const choices = sets.map(({name}) => ({value: name, text: name.replace('.yaml', '')}));
    const start = menu('start from', choices, name => {
      const set = sets.find(one => one.name === name);
      if (set) deeds.start(set);
    });
    const again = (): void => {
      this.agents.disabled = this.motion.value === 'event';
      deeds.run();
    };
    this.motion = select('motion', ['walk', 'teleport', 'event'].map(m => ({value: m, text: m})),
                         again);
    this.agents = numberField('agents', 10, 10_000, again);
    this.seed = numberField('seed', 1, 1e9, again);
    this.stop = button('Stop', 'end what is being worked on', deeds.stop);
    this.stop.disabled = true;
    this.bar = element('header', {class: 'bar'}, element('h1', {text: 'stigc playground'}), start,
        this.motion, element('label', {}, 'agents ', this.agents),
        element('label', {}, 'seed ', this.seed),
        button('Run', 'let the agents build', deeds.run),
        button('Verify', 'does every order of events end alike?', deeds.verify),
        button('Compile', 'what a robot would do where', deeds.compile),
        button('Synthesise', 'rules of one colour for the structure on show', deeds.synth),
        this.stop, menu('save', kSaved, deeds.save),
        button('Link', 'an address that holds this rule set', deeds.link));
  }

  get settings(): Settings {
    return {motion: this.motion.value, agents: Math.max(1, Math.round(Number(this.agents.value))),
            seed: Math.max(0, Math.round(Number(this.seed.value)))};
  }

  set settings({motion, agents, seed}: Settings) {
    this.motion.value = motion;
    this.agents.value = String(agents);
    this.seed.value = String(seed);
    this.agents.disabled = motion === 'event';
  }

  set busy(yes: boolean) {
    this.stop.disabled = !yes;
  }
}
