// SPDX-License-Identifier: MIT
// The page at work: what is typed is checked and run at once; everything else on demand. What is
// said of a text that has changed since is dropped.
import type {EditorView} from '@codemirror/view';
import {element} from '../elements.js';
import {keySheet, listen, type KeyAction} from '../keys.js';
import type {Answer, Question} from './answers.js';
import {Controls, type Deeds} from './controls.js';
import {makeEditor, setText} from './editor.js';
import {Engine} from './engine.js';
import type {NamedText, Shipped} from './files.js';
import {showMessages} from './messages.js';
import type {OwnPage} from './own_page.js';
import {Saving} from './saving.js';
import type {Schema} from './schema_path.js';
import {runOptions} from './settings.js';
import {hashOfShared, sharedOfHash} from './share.js';
import {Show, type Asked} from './show.js';

const kPause = 300;  // ms of no typing, after which the text is looked at
const kHint = 'Click an empty cell to learn what keeps it so.';
/** Bounds of the run that follows typing; `Run` goes on to the program's own. */
const kStepsAtOnce = 100_000, kDepositsAtOnce = 5_000;

export class Playground {
  readonly editor: EditorView;
  readonly controls: Controls;
  readonly show: Show;
  /** What was last answered to each kind of question. */
  readonly answers = new Map<string, Answer>();
  private readonly said = element('pre', {class: 'said'});
  private readonly heading = element('h2', {text: 'Run'});
  private schema: Schema | null = null;
  private typing = 0;
  /** Grows with every change of the text. */
  private version = 0;
  private sheet: HTMLElement | null = null;
  private readonly saving: Saving;
  /** The rule set whose camera is kept. */
  private shownSet = '';

  constructor(private readonly root: HTMLElement, private readonly engine: Engine,
              private readonly shipped: Shipped, private readonly own: OwnPage) {
    this.said.setAttribute('role', 'status');
    this.controls = new Controls(shipped.sets, this.deeds());
    const text = element('section', {class: 'text'});
    const view = element('div', {class: 'stig-view'});
    const words = element('section', {class: 'words'},
                          element('p', {class: 'hint', text: kHint}), this.heading, this.said);
    const seen = element('section', {class: 'seen'}, view, words);
    root.replaceChildren(this.controls.bar, element('main', {}, text, seen));
    this.show = new Show(view, asked => void this.explain(asked));
    this.editor = makeEditor({parent: text, schema: () => this.schema,
                              onChange: () => this.changed(), onRun: () => void this.run(false)});
    this.saving = new Saving({text: () => this.text, show: this.show,
                              page: () => this.own.with(this.shared),
                              say: words => this.say('Save', words),
                              ask: question => this.engine.ask(question)});
    listen(document, this.keys());
  }

  async begin(): Promise<void> {
    addEventListener('hashchange', () => this.follow());
    this.schema = await this.engine.ask({do: 'schema'}) as unknown as Schema;
    if (this.follow() || this.follow(this.own.set)) return;
    this.start(this.shipped.sets.find(one => one.name === 'staircase.yaml') ??
               this.shipped.sets[0]);
  }

  get text(): string {
    return this.editor.state.doc.toString();
  }

  /** The set, and how it is run, as in an address. */
  private get shared(): string {
    return hashOfShared({text: this.text, ...this.controls.settings});
  }

  private deeds(): Deeds {
    return {
      start: set => this.start(set),
      run: () => void this.run(false),
      verify: () => void this.verify(),
      compile: () => void this.compile(),
      synth: () => void this.synth(),
      stop: () => this.engine.stop(),
      link: () => this.link(),
      help: () => this.showSheet(),
      save: ending => void this.saving.save(ending),
    };
  }

  /** Where no letter is typed; the view has its own, while it has the focus. */
  private keys(): KeyAction[] {
    const deeds = this.deeds();
    return [
      {keys: ['e'], shown: 'e', does: 'to the editor (back: Escape, then Tab)',
       run: () => this.editor.focus()},
      {keys: ['r'], shown: 'r', does: 'run (in the editor: Ctrl+Enter)', run: deeds.run},
      {keys: ['v'], shown: 'v', does: 'verify', run: deeds.verify},
      {keys: ['c'], shown: 'c', does: 'compile', run: deeds.compile},
      {keys: ['y'], shown: 'y', does: 'synthesise', run: deeds.synth},
      {keys: ['.'], shown: '.', does: 'stop', run: deeds.stop},
      {keys: ['k'], shown: 'k', does: 'a link to this set', run: deeds.link},
      {keys: ['3'], shown: '3', does: 'to the 3-D view, whose ? lists its own keys',
       run: () => this.show.focus()},
      {keys: ['?'], shown: '?', does: 'this sheet', run: deeds.help},
      {keys: ['Escape'], shown: 'Escape', does: 'close', run: () => this.closeSheet()},
    ];
  }

  private showSheet(): void {
    const open = this.sheet !== null;
    this.closeSheet();
    if (open) return;
    this.sheet = keySheet(this.keys(), () => this.closeSheet());
    this.root.append(this.sheet);
  }

  private closeSheet(): void {
    this.sheet?.remove();
    this.sheet = null;
  }

  private start({text}: NamedText): void {
    setText(this.editor, text);
    this.editor.scrollDOM.scrollTop = 0;
  }

  /** Takes over what the address, or the page itself, says; false where it says nothing. */
  private follow(said = location.hash): boolean {
    const shared = sharedOfHash(said);
    if (shared === 'damaged') {
      this.say('Link', 'the rule set in this address is damaged: part of the address is missing, ' +
                       'or it was changed on its way');
      return true;
    }
    if (!shared) return false;
    const again = hashOfShared({...shared, text: ''}) !==
        hashOfShared({...this.controls.settings, text: ''});
    this.controls.settings = shared;
    if (shared.text !== this.text) setText(this.editor, shared.text);
    else if (again) void this.run(false);
    return true;
  }

  private link(): void {
    this.keepInAddress();
    if ('clipboard' in navigator) {
      navigator.clipboard.writeText(location.href).catch(() => undefined);
    }
  }

  private keepInAddress(): void {
    history.replaceState(null, '', this.shared);
  }

  private changed(): void {
    ++this.version;
    clearTimeout(this.typing);
    this.typing = setTimeout(() => void this.look(), kPause);
  }

  /** After typing: checks, and runs what is sound. */
  private async look(): Promise<void> {
    // A run of a text that is no more is not waited for.
    if (this.engine.busy) this.engine.stop();
    this.keepInAddress();
    const answer = await this.ask({do: 'check'});
    if (!answer) return;
    showMessages(this.editor, answer.diagnostics ?? []);
    const wrong = answer.diagnostics?.some(({severity}) => severity === 'error');
    if (!wrong) await this.run(true);
  }

  /** Null when the text has changed since, or when the work was stopped. */
  private async ask(question: Question): Promise<Answer | null> {
    const {version} = this;
    const {problems} = this.controls;
    if (problems !== '' && question.do !== 'check') {
      this.say('Not done', problems);
      return null;
    }
    this.controls.busy = true;
    try {
      // half a character stands for none in any file
      const text = this.text.replaceAll(/\p{Surrogate}/gu, '\ufffd');
      const answer = await this.engine.ask({text, ...question});
      if (version !== this.version) return null;
      this.answers.set(question.do, answer);
      return answer;
    } catch (error) {
      const problem = error instanceof Error ? error.message : String(error);
      if (version === this.version) this.say(question.do, problem);
      return null;
    } finally {
      this.controls.busy = this.engine.busy;
    }
  }

  private say(heading: string, text: string): void {
    this.heading.textContent = heading;
    this.said.textContent = text;
  }

  /** Shows and says what was answered; diagnostics stand in the editor. */
  private tell(heading: string, answer: Answer, keep: boolean): void {
    if (answer.view) this.show.show(answer.view, keep);
    const wrong = answer.diagnostics?.map(one => `${one.severity}[${one.code}]: ${one.message}`);
    this.say(heading, answer.text ?? answer.problem ?? wrong?.join('\n') ?? '');
  }

  async run(atOnce: boolean): Promise<void> {
    const {settings} = this.controls;
    this.keepInAddress();
    const {steps, deposits} = settings;
    const most = settings.motion === 'event'
        ? {deposits: Math.min(deposits ?? kDepositsAtOnce, kDepositsAtOnce)}
        : {steps: Math.min(steps ?? kStepsAtOnce, kStepsAtOnce)};
    const answer = await this.ask({do: 'explore', ...runOptions(settings), ...atOnce && most});
    if (!answer) return;
    const name = /^name: *(.*)$/m.exec(this.text)?.[1] ?? '';
    this.tell('Run', answer, name === this.shownSet);
    this.saving.ran(answer);
    this.shownSet = name;
  }

  private async explain({at, bricks}: Asked): Promise<void> {
    const stage = this.answers.get('explore')?.stage ?? 1;
    const answer = await this.ask({do: 'explain', at, bricks, stage});
    if (answer) this.tell(`Why, or why not, at (${at.join(', ')})`, answer, true);
  }

  private async verify(): Promise<void> {
    this.say('Verify', 'at work…');
    const answer = await this.ask({do: 'verify', effort: this.controls.settings.effort});
    if (!answer) return;
    this.tell('Verify', answer, false);
    this.saving.verified(answer);
    this.shownSet = '';
  }

  private async compile(): Promise<void> {
    this.say('Compile', 'at work…');
    const {robot, block} = this.shipped;
    const answer = await this.ask({do: 'compile', robot, block});
    if (!answer) return;
    showMessages(this.editor, answer.diagnostics ?? []);
    this.tell('Compile', answer, false);
    this.shownSet = '';
  }

  private async synth(): Promise<void> {
    const json = this.answers.get('explore')?.files?.json;
    this.say('Synthesise', 'at work…');
    const floor = /^floor: *true/m.test(this.text);
    const answer = await this.ask({do: 'synth', target: {name: 'structure.json', text: json ?? ''},
                                   floor, effort: this.controls.settings.effort});
    if (!answer) return;
    if (answer.rules) setText(this.editor, answer.rules);
    else this.tell('Synthesise', answer, true);
  }
}
