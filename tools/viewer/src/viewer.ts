// SPDX-License-Identifier: MIT
// The page: a stage with one or more runs, the panel beside it, time below.
import * as three from 'three';
import {planesOf} from './cut.js';
import {button, element} from './elements.js';
import {keySheet, listen} from './keys.js';
import {keyActions, type Actions} from './key_actions.js';
import {latticePanel} from './lattice_panel.js';
import {LatticeView} from './lattice_view.js';
import {posePanel} from './pose_panel.js';
import {PoseView} from './pose_view.js';
import {choicesOf, hashOf} from './permalink.js';
import {RobotEyes} from './robot_eyes.js';
import {Player, type Timeline} from './player.js';
import {endOf, partingTextOf, type Page, type Run, standing} from './runs.js';
import {Stage} from './stage.js';
import {timeBar} from './time_bar.js';
import {kFirstChoices, ViewState, type Choices} from './view_state.js';
import {Viewpoint} from './viewpoint.js';
import type {Bounds} from './bricks.js';

export const kMostPanes = 9;
const kSecondsForARun = 12;
const kClickWithin = 5;  // pixels
const kTouched = 0;

type View = LatticeView | PoseView;

function boundsOf(views: readonly View[]): Bounds {
  const all = views.map(view => view.bounds);
  const extreme = (of: (...x: number[]) => number, key: keyof Bounds): [number, number, number] =>
    [0, 1, 2].map(axis => of(...all.map(b => b[key][axis]))) as [number, number, number];
  return {low: extreme(Math.min, 'low'), high: extreme(Math.max, 'high')};
}

/** Moments of a physical run to step through: all but touches, of which there are too many. */
function momentsOf(runs: readonly Run[]): Float64Array {
  const all = runs.flatMap(run => run.kind === 'poses' ? run.events : []);
  const times = all.filter(({kind}) => kind !== kTouched).map(({time}) => time);
  return Float64Array.from(new Set(times)).sort();
}

function timelineOf(runs: readonly Run[]): Timeline {
  const end = Math.max(...runs.map(endOf));
  if (runs[0].kind === 'poses') return {end, unit: 's', rate: 1, events: momentsOf(runs)};
  const events = Float64Array.from({length: end}, (_, i) => i + 1);
  return {end, unit: 'brick', rate: Math.max(1, end / kSecondsForARun), events};
}

export class Viewer {
  readonly state: ViewState;
  readonly stage: Stage;
  readonly viewpoint: Viewpoint;
  readonly player: Player;
  readonly views: View[];
  private readonly panel = element('aside', {class: 'panel'});
  private readonly labels = element('div', {class: 'labels'});
  private readonly dark = matchMedia('(prefers-color-scheme: dark)');
  private panelUpdate: (changed: ReadonlySet<keyof Choices>) => void = () => undefined;
  private sheet: HTMLElement | null = null;
  /** Has the camera been placed, which takes the shape of the pane? */
  private placed = false;
  /** Where the robot that is followed was in the frame before. */
  private followed: three.Vector3 | null = null;
  private readonly eyes = new RobotEyes();
  /** Over when something else takes the place. */
  private readonly gone = new AbortController();
  /** Is it a robot's camera that is looked through? */
  private looking = false;

  /** `embedded`: as a part of a report, which leaves the rest of the page its keys and wheel. */
  constructor(readonly root: HTMLElement, readonly page: Page, readonly embedded = false) {
    const timeline = timelineOf(page.runs);
    const side = !embedded && page.runs.length > 1 && page.runs.length <= kMostPanes;
    this.state = new ViewState({...kFirstChoices, time: timeline.end, side});
    this.player = new Player(this.state, timeline);
    const host = element('div', {class: 'stage'}, this.labels);
    host.append(this.eyes.picture);
    this.stage = new Stage(host, () => this.camera);
    this.views = page.runs.map((run, i) => this.viewOf(run, i));
    const draw = (): void => this.stage.draw(true);
    this.viewpoint = new Viewpoint(this.stage.canvas, boundsOf(this.views), draw);
    root.replaceChildren(this.topBar(), element('main', {}, host, this.panel));
    if (timeline.end > 0) root.append(timeBar(this.state, this.player));
    this.connect();
    this.follow(location.hash);
    this.changed(new Set<keyof Choices>(['run', 'side', 'theme']));
  }

  get camera(): three.PerspectiveCamera | three.OrthographicCamera {
    return this.looking ? this.eyes.camera : this.viewpoint.camera;
  }

  /** The run that differences of a run are told from: the first; of the first, the second. */
  private otherThan(number: number): Run | null {
    return this.page.runs.at(number === 0 ? 1 : 0) ?? null;
  }

  private viewOf(run: Run, number: number): View {
    const other = this.page.runs.length > 1 ? this.otherThan(number) : null;
    const {target} = this.page;
    if (run.kind === 'poses') {
      return new PoseView(run, number, other?.kind === 'poses' ? other : null, target);
    }
    return new LatticeView(run, number, other?.kind === 'lattice' ? other : null, target);
  }

  private connect(): void {
    this.state.onChange(changed => this.changed(changed));
    this.stage.onFrame = () => this.beforeFrame();
    this.dark.addEventListener('change', () => this.changed(new Set<keyof Choices>(['theme'])),
                               {signal: this.gone.signal});
    addEventListener('hashchange', () => {
      this.follow(location.hash);
      if (this.embedded) this.root.scrollIntoView();
    }, {signal: this.gone.signal});
    const {canvas} = this.stage;
    let pressed: [number, number] = [0, 0];
    canvas.addEventListener('pointerdown', event => pressed = [event.clientX, event.clientY]);
    canvas.addEventListener('click', event => {
      const moved = Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]);
      if (moved <= kClickWithin) this.pick(event.clientX, event.clientY);
    });
    listen(this.embedded ? this.root : document, keyActions(this.actions()));
    if (this.embedded) this.mindFocus();
  }

  /** Until somebody turns to the player, wheel and fingers move the report. */
  private mindFocus(): void {
    const {root, viewpoint, stage} = this;
    root.tabIndex = -1;
    const take = (all: boolean): void => {
      viewpoint.zooms = all;
      stage.canvas.style.touchAction = all ? 'none' : 'pan-y';
    };
    root.addEventListener('focusin', () => take(true));
    root.addEventListener('focusout', event => {
      if (!(event.relatedTarget instanceof Node && root.contains(event.relatedTarget))) take(false);
    });
    take(false);
  }

  private actions(): Actions {
    return {
      state: this.state,
      player: this.player,
      viewpoint: this.viewpoint,
      runs: this.page.runs.length,
      levels: () => this.levels(),
      robots: () => this.robots(),
      pickable: () => this.pickable(),
      embedded: this.embedded,
      link: () => this.link(),
      switchTheme: () => this.switchTheme(),
    };
  }

  private levels(): readonly [number, number] {
    const run = this.page.runs[this.state.now.run];
    return run.kind === 'lattice' ? run.bricks.levels : [0, 0];
  }

  private robots(): number {
    const run = this.page.runs[this.state.now.run];
    return run.kind === 'poses' ? run.robots.length : 0;
  }

  private topBar(): HTMLElement {
    const {page, state} = this;
    const bar = element('header', {class: 'top'}, element('h1', {text: page.title}));
    const tabs = page.runs.length < 2 ? [] : page.runs.map((run, i) => {
      const out = button(run.name, run.title, () => state.set({run: i, side: false}));
      const show = (): boolean =>
        out.classList.toggle('chosen', !state.now.side && state.now.run === i);
      state.onChange(show);
      show();
      return out;
    });
    if (page.runs.length > 1 && page.runs.length <= kMostPanes) {
      tabs.push(this.switchOf('side', 'side by side', 'all runs at once (s)'));
      tabs.push(this.switchOf('difference', 'difference', 'only what another run has not (d)'));
    }
    bar.append(element('nav', {}, ...tabs), element('span', {class: 'tools'},
        button('fit', 'fit the view (f)', () => this.viewpoint.fit()),
        ...this.embedded ? [this.switchOf('whole', 'enlarge', 'the whole window (z)')] : [],
        button('link', 'a link to this view (k)', () => this.link()),
        button('theme', 'light or dark (t)', () => this.switchTheme()),
        button('?', 'keys (?)', () => state.set({help: true}))));
    return bar;
  }

  /** A button that is on or off. */
  private switchOf(key: 'side' | 'difference' | 'whole', text: string, title: string):
      HTMLButtonElement {
    const {state} = this;
    const out = button(text, title, () => state.set({[key]: !state.now[key]}));
    const show = (): boolean => out.classList.toggle('chosen', state.now[key]);
    state.onChange(show);
    show();
    return out;
  }

  switchTheme(): void {
    this.state.set({theme: this.isDark ? 'light' : 'dark'});
  }

  get isDark(): boolean {
    const {theme} = this.state.now;
    return theme === 'dark' || theme === 'auto' && this.dark.matches;
  }

  private changed(changed: ReadonlySet<keyof Choices>): void {
    const {run, side, help, orthographic} = this.state.now;
    if (changed.has('run') || changed.has('side')) this.arrange(run, side);
    this.panelUpdate(changed);
    if (changed.has('theme')) {
      this.root.dataset.theme = this.isDark ? 'dark' : 'light';
      this.stage.dark = this.isDark;
    }
    if (changed.has('help')) this.showSheet(help);
    this.root.classList.toggle('whole', this.state.now.whole);
    this.viewpoint.orthographic = orthographic;
    this.stage.draw();
  }

  /** Shows another run in place of one; the camera stays. */
  replace(number: number, run: Run): void {
    const old = this.views[number].scene;
    this.page.runs[number] = run;
    this.views[number] = this.viewOf(run, number);
    this.viewpoint.shown = boundsOf(this.views);
    this.arrange(this.state.now.run, this.state.now.side);
    this.stage.draw();
    old.traverse(part => {
      if (part instanceof three.Mesh || part instanceof three.LineSegments) {
        (part.geometry as three.BufferGeometry).dispose();
      }
    });
  }

  /** Makes the panel anew, of a run that has grown. */
  tellAgain(): void {
    const {scrollTop} = this.panel;
    this.arrange(this.state.now.run, this.state.now.side);
    this.panel.scrollTop = scrollTop;
  }

  /** Is somebody at work in the panel? */
  get panelInUse(): boolean {
    return this.panel.matches(':hover') || this.panel.contains(document.activeElement);
  }

  private arrange(run: number, side: boolean): void {
    const shown = side ? this.views.slice(0, kMostPanes) : [this.views[run]];
    this.stage.panes = shown.map(view => ({
      scene: view.scene,
      turnTo: (camera: three.Camera, coarse: boolean) =>
        view.turnTo(camera, this.state.now.apart, coarse),
      planes: () => this.planesOf(view),
    }));
    const [columns] = this.stage.grid;
    this.labels.style.gridTemplateColumns = `repeat(${columns}, 1fr)`;
    this.labels.replaceChildren(...side ? shown.map(view => this.label(view)) : []);
    const view = this.views[run];
    const {parts, update} = view instanceof PoseView
        ? posePanel(view.run, this.state, view.missing)
        : latticePanel(view.run, this.state, view.target);
    this.panelUpdate = update;
    this.panel.replaceChildren(...parts);
  }

  /** Bricks are left out whole, which shows the next ones; bodies are cut. */
  private planesOf(view: View): three.Plane[] {
    const {cut, cutAt} = this.state.now;
    return view instanceof PoseView ? planesOf(cut, cutAt, view.bounds) : [];
  }

  /** What bodies of a run that goes on have come to be about, for `fit`. */
  measure(): void {
    for (const view of this.views) if (view instanceof PoseView) view.measure();
    this.viewpoint.shown = boundsOf(this.views);
  }

  private label({run}: View): HTMLElement {
    const out = element('div', {}, element('b', {text: run.name}));
    const other = this.otherThan(this.page.runs.indexOf(run));
    const parts = other && partingTextOf(run, other);
    if (!parts) return out;
    out.append(parts.text, button('go there', 'the first event that differs',
                                  () => this.player.goTo(parts.time)));
    return out;
  }

  private beforeFrame(): void {
    if (this.player.advance(performance.now())) this.stage.draw();
    const {run, side} = this.state.now;
    this.viewpoint.resize(this.stage.aspect);
    if (!this.placed) this.viewpoint.fit('iso');
    this.placed = true;
    this.views.forEach((view, i) => {
      if (side || i === run) view.update(this.state.now, this.isDark);
    });
    this.goWith();
    this.lookThrough();
  }

  /** Takes a robot's camera for that of the picture, if that is wanted. */
  private lookThrough(): void {
    const {eyes, run, side, time} = this.state.now;
    const shown = this.page.runs[run];
    this.looking = eyes !== null && !side && shown.kind === 'poses' &&
        this.eyes.look(shown, eyes, time, this.stage.aspect);
    this.viewpoint.enabled = !this.looking;
    this.eyes.picture.classList.toggle('on', this.looking);
  }

  /** Moves the camera as the robot that is followed has moved. */
  private goWith(): void {
    const {follow, run, time} = this.state.now;
    const view = this.views[run];
    const at = follow !== null && view instanceof PoseView ? view.placeOf(follow, time) : null;
    if (at && this.followed) this.viewpoint.shift(at.clone().sub(this.followed));
    else if (at) this.viewpoint.lookAt(at);
    this.followed = at;
  }

  private pickable(): number {
    const shown = this.page.runs[this.state.now.run];
    return shown.kind === 'poses' ? shown.bodies.length : standing(shown, this.state.now.time);
  }

  /** Tells about the brick at a place on the page. */
  pick(x: number, y: number): void {
    const found = this.stage.paneAt(x, y);
    if (!found) return;
    const run = this.state.now.side ? found.pane : this.state.now.run;
    const caster = new three.Raycaster();
    caster.setFromCamera(found.at, this.camera);
    const brick = this.views[run].pick(caster.ray);
    this.state.set({run, picked: brick < 0 ? null : {run, brick}});
  }

  private showSheet(wanted: boolean): void {
    this.sheet?.remove();
    const close = (): void => this.state.set({help: false});
    this.sheet = wanted ? keySheet(keyActions(this.actions()), close) : null;
    if (this.sheet) this.root.append(this.sheet);
  }

  /** Puts the view into the address, and the address into the clipboard where that is allowed. */
  private link(): void {
    const hash = hashOf(this.state.now, this.viewpoint.numbers());
    history.replaceState(null, '', hash);
    if ('clipboard' in navigator) {
      navigator.clipboard.writeText(location.href).catch(() => undefined);
    }
  }

  private follow(hash: string): void {
    if (hash.length < 2) return;
    const {choices, camera} = choicesOf(hash);
    if (choices.run !== undefined && !this.page.runs[choices.run]) delete choices.run;
    if (choices.side && this.page.runs.length < 2) delete choices.side;
    if (choices.time !== undefined) {
      choices.time = Math.min(Math.max(choices.time, 0), this.player.timeline.end);
    }
    this.state.set({side: false, ...choices});
    if (camera.length > 0) this.lookFrom(camera);
  }

  /** Places the camera, as `viewpoint.numbers()` has it. */
  lookFrom(camera: readonly number[]): void {
    this.viewpoint.place(camera);
    this.placed = true;
  }

  /** Lets go of the page, for another in its place. */
  dispose(): void {
    this.gone.abort();
    this.state.set({playing: false});
    this.stage.dispose();
    this.root.replaceChildren();
  }
}

