// SPDX-License-Identifier: MIT
// The canvas: one run, or up to nine in a grid. A frame is drawn when somebody asks for one, so
// that nothing is drawn while nothing moves.
import * as three from 'three';

/** What a pane shows. */
export interface Shown {
  scene: three.Scene;
  /** Before it is drawn; `coarse`: it moves, and all of it takes long. */
  turnTo(camera: three.Camera, coarse: boolean): void;
  /** Planes beyond which nothing is drawn. */
  planes(): three.Plane[];
}

const kSlowFrame = 60;    // ms: beyond, resolution is given up while the picture moves
const kStillAfter = 200;  // ms
const kLongFrame = 250;   // ms: beyond, the first frame of a turn is coarse too
const kForgets = 0.85;    // with each whole frame, of how long those before have taken
const kLeastDetail = 0.4;
const kBackground = {light: 0xf4f6f8, dark: 0x171c23};

/** Columns and rows for so many panes. */
export function gridOf(panes: number, aspect: number): [number, number] {
  let best: [number, number] = [1, panes], worst = Infinity;
  for (let columns = 1; columns <= panes; ++columns) {
    const rows = Math.ceil(panes / columns);
    const off = Math.abs(Math.log(aspect * rows / columns)) + 0.2 * (columns * rows - panes);
    if (off < worst) [best, worst] = [[columns, rows], off];
  }
  return best;
}

function drawnBySoftware(context: WebGL2RenderingContext): boolean {
  const info = context.getExtension('WEBGL_debug_renderer_info');
  const name = info ? String(context.getParameter(info.UNMASKED_RENDERER_WEBGL)) : '';
  return /swiftshader|llvmpipe|software/i.test(name);
}

/** With smooth edges, unless software draws. Which it is a context alone can tell; one of software
    takes half a second to be made, and so is kept. */
function makeRenderer(): {renderer: three.WebGLRenderer; software: boolean} {
  const options = {preserveDrawingBuffer: true, powerPreference: 'high-performance'} as const;
  const canvas = document.createElement('canvas');
  // As three.js asks for it.
  const context = canvas.getContext('webgl2', {...options, antialias: false, stencil: false});
  if (context && drawnBySoftware(context)) {
    return {renderer: new three.WebGLRenderer({...options, canvas, context}), software: true};
  }
  context?.getExtension('WEBGL_lose_context')?.loseContext();
  return {renderer: new three.WebGLRenderer({...options, antialias: true}), software: false};
}

export class Stage {
  readonly canvas: HTMLCanvasElement;
  /** Frames drawn so far. */
  frames = 0;
  dark = false;
  panes: Shown[] = [];
  /** Before each frame. */
  onFrame: () => void = () => undefined;
  private readonly software: boolean;
  private readonly renderer: three.WebGLRenderer;
  private readonly sizes = new ResizeObserver(() => this.draw());
  private asked = false;
  private turns = false;  // the frame that is asked for is one of a camera that moves
  private detail = 1;
  private coarse = false;
  private wholeTime = 0;  // ms: of the last frame that was not coarse
  private askedAt = 0;
  private freeAt = 0;     // ms: when the last frame was done with
  private frameTime = 0;  // ms
  private still = 0;
  private shape = '';

  constructor(private readonly host: HTMLElement, private readonly camera: () => three.Camera) {
    ({renderer: this.renderer, software: this.software} = makeRenderer());
    this.canvas = this.renderer.domElement;
    this.canvas.tabIndex = 0;
    this.renderer.autoClear = false;
    host.prepend(this.canvas);
    this.sizes.observe(host);
  }

  /** Gives back what the browser has few of. */
  dispose(): void {
    this.asked = true;  // no more frames
    clearTimeout(this.still);
    this.sizes.disconnect();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  get size(): [number, number] {
    return [Math.max(1, this.host.clientWidth), Math.max(1, this.host.clientHeight)];
  }

  /** Width by height of one pane. */
  get aspect(): number {
    const [width, height] = this.size;
    const [columns, rows] = this.grid;
    return (width / columns) / (height / rows);
  }

  get grid(): [number, number] {
    const [width, height] = this.size;
    return gridOf(Math.max(1, this.panes.length), width / height);
  }

  /** Asks for a frame; `turns`: since the camera moves. */
  draw(turns = false): void {
    this.turns ||= turns;
    if (this.asked) return;
    this.asked = true;
    this.askedAt = performance.now();
    requestAnimationFrame(() => this.frame());
  }

  /** The pane at a place on the page, and the place in it from -1 to 1, y up. */
  paneAt(x: number, y: number): {pane: number; at: three.Vector2} | null {
    const box = this.canvas.getBoundingClientRect();
    const [columns, rows] = this.grid;
    const across = (x - box.left) / box.width * columns, down = (y - box.top) / box.height * rows;
    const pane = Math.floor(down) * columns + Math.floor(across);
    if (across < 0 || across >= columns || down < 0 || pane >= this.panes.length) return null;
    return {pane, at: new three.Vector2(across % 1 * 2 - 1, 1 - down % 1 * 2)};
  }

  private frame(): void {
    this.asked = false;
    const begun = performance.now();
    this.noteWait(begun - this.askedAt);
    this.chooseDetail();
    this.onFrame();
    this.shapeCanvas();
    this.renderer.setScissorTest(false);
    this.renderer.setClearColor(this.dark ? kBackground.dark : kBackground.light);
    this.renderer.clear();
    this.panes.forEach((pane, i) => this.drawPane(pane, i));
    ++this.frames;
    // What software draws holds up whatever comes after this function, and not the function.
    setTimeout(() => {
      this.freeAt = performance.now();
      this.frameTime = this.freeAt - begun;
      if (!this.coarse) this.wholeTime = Math.max(this.frameTime, this.wholeTime * kForgets);
      clearTimeout(this.still);
      if (this.detail === 1 && !this.coarse) return;
      this.still = setTimeout(() => this.draw(), kStillAfter + 50);
    });
  }

  /** A canvas whose size is set, even to what it was, is made anew. */
  private shapeCanvas(): void {
    const [width, height] = this.size;
    const ratio = Math.min(devicePixelRatio, 2) * this.detail;
    const shape = [width, height, ratio].join();
    if (shape === this.shape) return;
    this.shape = shape;
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
  }

  private drawPane(pane: Shown, number: number): void {
    const [width, height] = this.size;
    const [columns, rows] = this.grid;
    const [wide, high] = [width / columns, height / rows];
    const left = number % columns * wide, low = height - (Math.floor(number / columns) + 1) * high;
    this.renderer.setViewport(left, low, wide, high);
    this.renderer.setScissor(left, low, wide, high);
    this.renderer.setScissorTest(true);
    pane.turnTo(this.camera(), this.coarse);
    this.renderer.clippingPlanes = pane.planes();
    this.renderer.render(pane.scene, this.camera());
  }

  /** A frame that is slow to be drawn may hold up the one after it in place of its own function. */
  private noteWait(waited: number): void {
    if (this.askedAt - this.freeAt > kStillAfter) return;
    this.frameTime = Math.max(this.frameTime, waited);
    if (!this.coarse) this.wholeTime = Math.max(this.wholeTime, waited);
  }

  /** Coarser while frames are slow and follow each other; fine again once all is still. */
  private chooseDetail(): void {
    const moving = this.askedAt - this.freeAt < kStillAfter ||
        this.turns && (this.software || this.wholeTime > kLongFrame);
    if (moving && this.turns && this.software) this.coarse = true;
    this.turns = false;
    const slow = this.frameTime > kSlowFrame;
    if (!moving) {
      this.detail = 1;
      this.coarse = false;
    } else if (!this.coarse) {
      this.coarse = slow;
    } else if (slow) {
      this.detail = Math.max(kLeastDetail, this.detail * 0.7);
    }
  }
}
