// SPDX-License-Identifier: MIT
// The 3-D view beside the editor: the viewer itself, with what the module has answered, and the
// empty cell that was clicked.
import * as three from 'three';
import {cellOutline} from '../cell_outline.js';
import {bytesOfBase64} from '../packed_data.js';
import {LatticeView} from '../lattice_view.js';
import {pageOf, standing, type LatticeRun} from '../runs.js';
import {Viewer} from '../viewer.js';
import type {Triple} from '../cells.js';
import type {ViewData} from './answers.js';
import {pickCell} from './pick_cell.js';

const kClickWithin = 5;  // pixels

/** A cell, and the bricks that stand: x, y, z and the number of the brick's kind. */
export interface Asked {
  at: Triple;
  bricks: number[][];
}

/** The bricks of a run that stand at a moment. */
function bricksAt(run: LatticeRun, time: number): number[][] {
  const {x, y, z} = run.bricks.cells;
  return Array.from({length: standing(run, time)}, (_, i) => [x[i], y[i], z[i], run.colour[i]]);
}

export class Show {
  viewer: Viewer | null = null;
  private marker: three.LineSegments | null = null;

  /** `onCell`: an empty cell was clicked. */
  constructor(private readonly root: HTMLElement,
              private readonly onCell: (asked: Asked) => void) {}

  /** `keep`: the camera stays where it is. */
  show({json, columns}: ViewData, keep: boolean): void {
    const camera = keep ? this.viewer?.viewpoint.numbers() : undefined;
    this.viewer?.dispose();
    const page = pageOf({json, bytes: bytesOfBase64(columns)});
    this.viewer = new Viewer(this.root, page, true);
    if (page.runs.length > 1) this.viewer.state.set({side: true});
    if (camera) this.viewer.lookFrom(camera);
    this.marker = null;
    this.listen(this.viewer);
    window.stigView = this.viewer;
  }

  /** Keys are the view's from now on. */
  focus(): void {
    this.root.focus();
  }

  /** What is drawn now; null where nothing is. */
  picture(): Promise<Blob | null> {
    const stage = this.viewer?.stage;
    if (!stage) return Promise.resolve(null);
    stage.draw();
    // A canvas is read while its frame is still there: in the turn in which it was drawn.
    return new Promise(resolve => {
      requestAnimationFrame(() => stage.canvas.toBlob(resolve, 'image/png'));
    });
  }

  private listen(viewer: Viewer): void {
    const {canvas} = viewer.stage;
    let pressed: [number, number] = [0, 0];
    canvas.addEventListener('pointerdown', event => pressed = [event.clientX, event.clientY]);
    canvas.addEventListener('click', event => {
      const moved = Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]);
      if (moved <= kClickWithin) this.click(viewer, event.clientX, event.clientY);
    });
    viewer.state.onChange(changed => {
      if (changed.has('time') && this.marker) this.marker.visible = false;
    });
  }

  private click(viewer: Viewer, x: number, y: number): void {
    const found = viewer.stage.paneAt(x, y);
    if (!found) return;
    const view = viewer.views[viewer.state.now.side ? found.pane : viewer.state.now.run];
    if (!(view instanceof LatticeView)) return;
    const caster = new three.Raycaster();
    caster.setFromCamera(found.at, viewer.camera);
    const at = pickCell(view, view.run.bricks.centres, caster.ray);
    if (!at) return;
    this.mark(viewer, view, at);
    this.onCell({at, bricks: bricksAt(view.run, viewer.state.now.time)});
  }

  private mark(viewer: Viewer, view: LatticeView, at: Triple): void {
    this.marker?.removeFromParent();
    this.marker = cellOutline(view.run.bricks.shape, 1, 0x2f8f4e);
    this.marker.renderOrder = 2;
    this.marker.position.set(...view.run.bricks.shape.centre(...at));
    view.scene.add(this.marker);
    viewer.stage.draw();
  }
}
