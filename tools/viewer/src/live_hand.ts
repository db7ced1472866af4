// SPDX-License-Identifier: MIT
// Moving things by hand: what is dragged goes along on the height at which it was grasped, or with
// shift upright. Each place is a command of its own, one at a time.
import * as three from 'three';
import type {Answer, LiveLink} from './live_link.js';
import {robotOf} from './pose_panel.js';

interface Grasp {
  body: number;
  /** Of what is moved, when it was grasped, and where it was grasped. */
  from: readonly number[];
  at: three.Vector3;
}

export class LiveHand {
  /** Does dragging move things, rather than the camera? */
  on = false;
  /** Told of each place where something was put, m. */
  onPlaced: (at: readonly number[]) => void = () => undefined;
  private grasp: Grasp | null = null;
  /** Has it been dragged since it was grasped? A click moves nothing. */
  private moved = false;
  private next: number[] | null = null;
  private busy = false;

  constructor(private readonly live: LiveLink) {
    const {canvas} = live.viewer.stage;
    const first = {capture: true};
    canvas.addEventListener('pointerdown', event => this.take(event), first);
    canvas.addEventListener('pointermove', event => this.drag(event), first);
    canvas.addEventListener('pointerup', event => this.release(event), first);
    canvas.addEventListener('pointercancel', () => this.letGo(), first);
  }

  /** Is something being dragged? */
  get holds(): boolean {
    return this.grasp !== null;
  }

  /** Where a block, or a body's robot, is: m. */
  placeOf(body: number): readonly number[] | null {
    const {run, now} = this.live;
    if (run.kind !== 'poses' || body < 0) return null;
    const robot = robotOf(run, body);
    return robot >= 0 ? now?.robots?.[robot].slice(0, 3) ?? null
                      : run.tracks.at(body, 0)?.p ?? null;
  }

  /** Moves what is picked. */
  async put(at: readonly number[]): Promise<Answer | null> {
    const body = this.live.viewer.state.now.picked?.brick ?? -1;
    return body < 0 ? null : this.move(body, at);
  }

  private move(body: number, at: readonly number[]): Promise<Answer> {
    const {run} = this.live;
    const robot = run.kind === 'poses' ? robotOf(run, body) : -1;
    return this.live.ask({do: 'move', ...robot >= 0 ? {robot} : {block: body}, at});
  }

  private rayAt(event: PointerEvent): three.Ray | null {
    const {stage, camera} = this.live.viewer;
    const found = stage.paneAt(event.clientX, event.clientY);
    if (!found) return null;
    const caster = new three.Raycaster();
    caster.setFromCamera(found.at, camera);
    return caster.ray;
  }

  private take(event: PointerEvent): void {
    const ray = this.on && event.button === 0 ? this.rayAt(event) : null;
    if (!ray) return;
    const body = this.live.viewer.views[0].pick(ray);
    const from = this.placeOf(body), pose = this.live.tracks?.at(body, 0);
    if (!from || !pose) return;
    const height = new three.Plane(new three.Vector3(0, 0, 1), -pose.p[2]);
    const at = ray.intersectPlane(height, new three.Vector3());
    if (!at) return;
    event.stopImmediatePropagation();
    this.live.viewer.stage.canvas.setPointerCapture(event.pointerId);
    this.live.viewer.state.set({picked: {run: 0, brick: body}});
    this.grasp = {body, from, at};
  }

  private drag(event: PointerEvent): void {
    const {grasp} = this;
    const ray = grasp && this.rayAt(event);
    if (!grasp || !ray) return;
    event.stopImmediatePropagation();
    const towards = this.live.viewer.camera.getWorldDirection(new three.Vector3()).setZ(0);
    const plane = new three.Plane().setFromNormalAndCoplanarPoint(
        event.shiftKey ? towards.normalize() : new three.Vector3(0, 0, 1), grasp.at);
    const to = ray.intersectPlane(plane, new three.Vector3());
    if (!to) return;
    const [x, y, z] = grasp.from;
    const by = to.sub(grasp.at);
    this.moved = true;
    this.next = event.shiftKey ? [x, y, z + by.z] : [x + by.x, y + by.y, z];
    void this.send(grasp.body);
  }

  /** The newest place, once the one before is answered. */
  private async send(body: number): Promise<void> {
    if (this.busy) return;
    this.busy = true;
    while (this.next) {
      const at = this.next;
      this.next = null;
      await this.move(body, at);
      this.onPlaced(at);
    }
    this.busy = false;
  }

  /** Moves that come faster than pictures are left out, all but this last one. */
  private release(event: PointerEvent): void {
    if (this.moved) this.drag(event);
    this.letGo();
  }

  private letGo(): void {
    this.grasp = null;
    this.moved = false;
  }
}
