// SPDX-License-Identifier: MIT
// The faces that bricks show, as buffers for WebGL. Hidden faces are left out, which is what lets
// software draw large structures: of a solid, most bricks show none. Faces of one direction make up
// one mesh, so that those that look away are not even handed to the graphics.
import * as three from 'three';
import type {Bricks} from './bricks.js';
import type {CellFace, Triple} from './cells.js';

/** Which bricks are drawn, and how. */
export interface Look {
  /** By brick: 0 or 1. */
  visible: Uint8Array;
  /** Three bytes a brick. */
  rgb: Uint8Array;
  /** How far bricks are drawn apart; 0: they touch. */
  apart: number;
}

const kVertex = /* glsl */ `
in vec4 colour;
out vec3 vColour;
out vec2 vAcross;
uniform bool cap;
void main() {
  int corner = gl_VertexID % CORNERS;
  if (cap) vAcross = vec2(corner == CORNERS - 1 ? 0.5 : 0.0);
  else vAcross = vec2(corner == 1 || corner == 2, corner >= 2);
  vColour = colour.rgb;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

// Edges are one pixel wide at least, and fade where faces are hardly larger than that.
const kFragment = /* glsl */ `
in vec3 vColour;
in vec2 vAcross;
out vec4 pixel;
uniform float opacity;
void main() {
  vec2 inward = min(vAcross, 1.0 - vAcross);
  float toEdge = min(inward.x, inward.y);
  float width = fwidth(toEdge);
  float line = 1.0 - smoothstep(0.5, 1.5, toEdge / max(width, 0.015));
  line *= clamp(0.15 / max(width, 1e-4) - 0.5, 0.0, 1.0);
  pixel = vec4(vColour * (1.0 - 0.45 * line), opacity);
}`;

const kIndices = new Map<number, three.BufferAttribute>();

/** Vertices of so many faces: the same for all sides with as many corners, and so shared. */
function indexFor(faces: number, corners: number, triangles: readonly number[]):
    three.BufferAttribute {
  const known = kIndices.get(corners);
  if (known && known.count >= faces * triangles.length) return known;
  const index = new Uint32Array(faces * triangles.length);
  for (let f = 0, to = 0; f < faces; ++f) {
    for (const corner of triangles) index[to++] = f * corners + corner;
  }
  const made = new three.BufferAttribute(index, 1);
  kIndices.set(corners, made);
  return made;
}

/** Those of one direction. */
class Side {
  readonly mesh: three.Mesh;
  private readonly geometry = new three.BufferGeometry();
  private position = new Float32Array(0);
  private colour = new Uint8Array(0);
  private readonly corners: Triple[];
  private readonly triangles: number[];
  private room = 0;

  constructor(readonly face: CellFace, private readonly number: number,
              material: (cap: boolean, corners: number) => three.Material) {
    const cap = face.corners.length > 4;
    this.corners = cap ? [...face.corners, [0, 0, face.normal[2] / 2]] : face.corners;
    const last = face.corners.length;
    this.triangles = cap ? face.corners.flatMap((_, i) => [last, i, (i + 1) % last])
                         : [0, 1, 2, 0, 2, 3];
    this.mesh = new three.Mesh(this.geometry, material(cap, this.corners.length));
    this.mesh.frustumCulled = false;
    // Or it would be found, for an order that nobody needs, from all vertices.
    this.geometry.boundingSphere = new three.Sphere();
  }

  /** The number of faces drawn. */
  fill(bricks: Bricks, look: Look, centres: Float32Array): number {
    const {count, neighbours, shape} = bricks;
    const {visible} = look;
    const sides = shape.faces.length;
    const shown = (i: number): boolean => {
      if (visible[i] === 0) return false;
      const beyond = neighbours[i * sides + this.number];
      return beyond < 0 || visible[beyond] === 0 || look.apart > 0;
    };
    let faces = 0, vertex = 0;
    for (let i = 0; i < count; ++i) if (shown(i)) ++faces;
    this.reserve(faces);
    for (let i = 0; faces > 0 && i < count; ++i) {
      if (shown(i)) vertex = this.put(i, vertex, look, centres);
    }
    for (const name of ['position', 'colour']) {
      const attribute = this.geometry.getAttribute(name) as three.BufferAttribute;
      attribute.clearUpdateRanges();
      attribute.addUpdateRange(0, vertex * attribute.itemSize);
      attribute.needsUpdate = true;
    }
    this.geometry.setDrawRange(0, faces * this.triangles.length);
    this.mesh.visible = faces > 0;
    return faces;
  }

  private put(brick: number, vertex: number, look: Look, centres: Float32Array): number {
    const {position, colour} = this;
    const {shade} = this.face;
    const at = brick * 3;
    for (const corner of this.corners) {
      for (let axis = 0; axis < 3; ++axis) {
        position[vertex * 3 + axis] = centres[at + axis] + corner[axis];
        colour[vertex * 4 + axis] = look.rgb[at + axis] * shade;
      }
      ++vertex;
    }
    return vertex;
  }

  /** Makes room for so many faces, and a good deal more, since runs grow. */
  private reserve(faces: number): void {
    if (faces <= this.room && this.room > 0) return;
    this.room = Math.max(64, Math.ceil(faces * 1.3));
    const vertices = this.room * this.corners.length;
    this.position = new Float32Array(3 * vertices);
    this.colour = new Uint8Array(4 * vertices);  // of four bytes each: aligned ones are faster
    this.geometry.dispose();
    this.geometry.setAttribute('position', new three.BufferAttribute(this.position, 3));
    this.geometry.setAttribute('colour', new three.BufferAttribute(this.colour, 4, true));
    this.geometry.setIndex(indexFor(this.room, this.corners.length, this.triangles));
  }

  dispose(): void {
    this.geometry.dispose();
  }
}

function materialOf(cap: boolean, corners: number, opacity: number): three.Material {
  return new three.ShaderMaterial({
    glslVersion: three.GLSL3,
    vertexShader: kVertex,
    fragmentShader: kFragment,
    defines: {CORNERS: corners},
    uniforms: {cap: {value: cap}, opacity: {value: opacity}},
    transparent: opacity < 1,
    depthWrite: opacity === 1,
  });
}

/** All faces of a set of bricks. */
export class Faces {
  readonly object = new three.Group();
  /** Faces drawn, of all directions. */
  count = 0;
  /** Where bricks are drawn. */
  centres: Float32Array;
  private readonly sides: Side[];

  constructor(private readonly bricks: Bricks, opacity = 1) {
    this.centres = bricks.centres;
    const known = new Map<boolean, three.Material>();
    const material = (cap: boolean, corners: number): three.Material => {
      const found = known.get(cap) ?? materialOf(cap, corners, opacity);
      known.set(cap, found);
      return found;
    };
    this.sides = bricks.shape.faces.map((face, f) => new Side(face, f, material));
    for (const side of this.sides) this.object.add(side.mesh);
  }

  fill(look: Look): void {
    this.centres = look.apart > 0 ? this.drawnApart(look.apart) : this.bricks.centres;
    this.count = 0;
    for (const side of this.sides) this.count += side.fill(this.bricks, look, this.centres);
  }

  /** Leaves out directions that no brick can show to this camera. */
  turnTo(camera: three.Camera, apart: number): void {
    const {low, high} = this.bricks.bounds;
    // Drawn apart, every face may be the outermost.
    const reach = apart * Math.hypot(...high.map((h, axis) => h - low[axis]));
    const towards = camera.getWorldDirection(new three.Vector3()).negate();
    for (const {face, mesh} of this.sides) {
      const [x, y, z] = face.normal;
      const least = x * (x > 0 ? low : high)[0] + y * (y > 0 ? low : high)[1] +
          z * (z > 0 ? low : high)[2];
      const there = x * camera.position.x + y * camera.position.y + z * camera.position.z;
      const faced = camera instanceof three.OrthographicCamera
          ? towards.x * x + towards.y * y + towards.z * z > 0
          : there > least - reach;
      mesh.layers.set(faced ? 0 : 1);
    }
  }

  dispose(): void {
    for (const side of this.sides) side.dispose();
  }

  private drawnApart(apart: number): Float32Array {
    const {low, high} = this.bricks.bounds;
    const middle = [0, 1].map(axis => (low[axis] + high[axis]) / 2);
    middle.push(low[2] + 0.5);
    return this.bricks.centres.map((at, i) => at + (at - middle[i % 3]) * apart);
  }
}
