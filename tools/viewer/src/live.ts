// SPDX-License-Identifier: MIT
// A run that goes on while it is looked at: the server's events become the viewer's runs, and what
// is done on the page becomes commands.
import {LiveBar} from './live_bar.js';
import {LiveHand} from './live_hand.js';
import {growing, showBodies, withBricks, type LiveState, type NewBrick} from './live_run.js';
import {unpack} from './packed_data.js';
import type {Answer, Command, LiveLink} from './live_link.js';
import type {BodyTracks} from './pose_run.js';
import {pageOf, type Page, type Run} from './runs.js';
import {Viewer} from './viewer.js';

const kTellEvery = 1000;  // ms: between two panels made anew
const kGrowEvery = 200;   // ms: between two structures made anew

export class Live implements LiveLink {
  readonly viewer: Viewer;
  /** How the run stands; null before the first word of it. */
  now: LiveState | null = null;
  /** Commands that were answered, for tests. */
  answered = 0;
  private readonly token = new URLSearchParams(location.search).get('token') ?? '';
  private readonly bar: LiveBar;
  private readonly hand: LiveHand;
  private number: number;
  private news: NewBrick[] = [];
  private grown = 0;
  private told = 0;
  private telling: ReturnType<typeof setTimeout> | undefined;
  private fitted = '';
  private events: Promise<void> = Promise.resolve();

  constructor(root: HTMLElement, page: Page, number: number) {
    this.number = number;
    this.viewer = new Viewer(root, {...page, runs: [growing(page)]});
    this.hand = new LiveHand(this);
    this.bar = new LiveBar(this, this.hand);
    root.append(this.bar.element);
    this.takeKeys();
    this.listen();
  }

  get run(): Run {
    return this.viewer.page.runs[0];
  }

  /** The address of something of the server's. */
  address(path: string, given: Record<string, string> = {}): string {
    return `/${path}?${new URLSearchParams({...given, token: this.token}).toString()}`;
  }

  async ask(command: Command): Promise<Answer> {
    const headers = {'Content-Type': 'application/json', 'X-Stig-Token': this.token};
    let answer: Answer;
    try {
      const response =
          await fetch('/command', {method: 'POST', headers, body: JSON.stringify(command)});
      answer = response.ok ? await response.json() as Answer
                           : {ok: false, problem: await response.text()};
    } catch {
      answer = {ok: false, problem: 'the program does not answer any more'};
    }
    ++this.answered;
    this.bar.say(answer.problem ?? '');
    return answer;
  }

  toggle(): void {
    void this.ask({do: this.now?.mode === 'running' ? 'pause' : 'run'});
  }

  /** The keys of a player are those of the run. */
  private takeKeys(): void {
    const {player, state} = this.viewer;
    player.toggle = () => this.toggle();
    player.step = count => void (count > 0 && this.ask({do: 'step', count}));
    player.goTo = () => undefined;
    state.onChange(changed => {
      if (changed.has('speed')) void this.ask({do: 'speed', times: state.now.speed});
    });
  }

  private listen(): void {
    const source = new EventSource(this.address('events'));
    const on = (name: string, take: (data: unknown) => void | Promise<void>): void =>
      source.addEventListener(name, (event: MessageEvent<string>) => {
        // In their order: unpacking a scene takes a while.
        this.events = this.events.then(() => take(JSON.parse(event.data)));
      });
    on('scene', data => this.takeScene(data as {run: number; data: string}));
    on('news', data => this.takeNews(data as unknown[]));
    on('state', data => this.takeState(data as LiveState));
    source.addEventListener('open', () => this.bar.connected(true));
    source.addEventListener('error', () => this.bar.connected(false));
  }

  /** Another run, or the same from another moment on: nothing of the old one holds. */
  private async takeScene({run, data}: {run: number; data: string}): Promise<void> {
    this.news = [];
    this.number = run;
    this.viewer.state.set({picked: null, time: 0});
    this.show(growing(pageOf(await unpack(data))));
  }

  private show(run: Run): void {
    const leads = this.leadsCamera;
    this.viewer.replace(0, run);
    if (leads) this.fit();
  }

  /** Is the camera where it was put by itself? */
  private get leadsCamera(): boolean {
    return this.fitted === '' || this.viewer.viewpoint.numbers().join() === this.fitted;
  }

  private fit(): void {
    const {viewpoint} = this.viewer;
    viewpoint.fit();
    this.fitted = viewpoint.numbers().join();
  }

  private takeNews(news: unknown[]): void {
    const {run} = this;
    if (run.kind === 'lattice') {
      this.news.push(...news as NewBrick[]);
      return;
    }
    for (const [time, body, text] of news as [number, number, string][]) {
      run.log.push({time, body, text});
    }
  }

  private takeState(state: LiveState): void {
    if (state.run !== this.number) return;
    const {run, viewer} = this;
    const stopped = state.mode !== 'running' && this.now?.mode === 'running';
    this.now = state;
    if (run.kind === 'poses') {
      showBodies(run, state);
      viewer.measure();
      // What drives out of the picture is followed, unless somebody has taken the camera, or drags
      // something over it.
      if (this.leadsCamera && !this.hand.holds && !viewer.viewpoint.showsAll) this.fit();
    } else {
      this.grow(run, state);
    }
    viewer.state.set({time: state.time});
    // Moved by a hand while it stands still.
    viewer.stage.draw();
    this.bar.show(state);
    this.tellSoon(stopped);
  }

  /** Makes the panel anew: at once, or when it has stood for long enough. */
  private tellSoon(atOnce: boolean): void {
    clearTimeout(this.telling);
    const wait = this.told + kTellEvery - performance.now();
    if (!atOnce && (wait > 0 || this.viewer.panelInUse)) {
      this.telling = setTimeout(() => this.tellSoon(false), Math.max(wait, kTellEvery));
      return;
    }
    this.told = performance.now();
    this.viewer.tellAgain();
  }

  private grow(run: Extract<Run, {kind: 'lattice'}>, state: LiveState): void {
    const now = performance.now();
    if (this.news.length === 0) return;
    if (state.mode === 'running' && now - this.grown < kGrowEvery) return;
    this.grown = now;
    this.show(withBricks(run, this.news));
    this.news = [];
  }

  /** The tracks of a physical run. */
  get tracks(): BodyTracks | null {
    return this.run.kind === 'poses' ? this.run.tracks : null;
  }
}

export function beginLive(root: HTMLElement, page: Page, run: number): Live {
  return new Live(root, page, run);
}
