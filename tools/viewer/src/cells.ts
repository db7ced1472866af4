// SPDX-License-Identifier: MIT
// Cells of the two lattices as solids: a cube, or a hexagonal prism, of width and height 1. The
// centre of a cell is where lib/rules/neighbourhood.h has it; z = 0 is the lower end of cells at
// height 0.

export type Triple = readonly [number, number, number];

export interface CellFace {
  /** Offset to the cell on the other side. */
  neighbour: Triple;
  /** Points outward; the face is half a width from the centre. */
  normal: Triple;
  /** Relative to the centre, counter-clockwise from outside. */
  corners: Triple[];
  /** Of the light that falls on it, 0 to 1. */
  shade: number;
}

export interface CellShape {
  faces: CellFace[];
  /** In cell widths. */
  centre(x: number, y: number, z: number): Triple;
}

export type Lattice = 'cubic' | 'hexagonal';

const kLight: Triple = [0.32, -0.55, 0.77];

function shadeOf(normal: Triple): number {
  const cosine = normal[0] * kLight[0] + normal[1] * kLight[1] + normal[2] * kLight[2];
  return 0.72 + (cosine > 0 ? 0.33 : 0.2) * cosine;
}

function face(neighbour: Triple, normal: Triple, corners: Triple[]): CellFace {
  return {neighbour, normal, corners, shade: Math.min(1, shadeOf(normal))};
}

/** A prism of height 1 upon a polygon, whose sides face the given neighbours. */
function prism(base: (readonly [number, number])[], sides: Triple[]): CellFace[] {
  const at = (i: number): readonly [number, number] => base[i % base.length];
  const faces = sides.map((neighbour, i) => {
    const [a, b] = [at(i), at(i + 1)];
    const middle = [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2] as const;
    const length = Math.hypot(middle[0], middle[1]);
    return face(neighbour, [middle[0] / length, middle[1] / length, 0],
                [[a[0], a[1], -0.5], [b[0], b[1], -0.5], [b[0], b[1], 0.5], [a[0], a[1], 0.5]]);
  });
  const cap = (z: number): Triple[] => base.map(([x, y]) => [x, y, z] as const);
  faces.push(face([0, 0, 1], [0, 0, 1], cap(0.5)));
  faces.push(face([0, 0, -1], [0, 0, -1], cap(-0.5).reverse()));
  return faces;
}

const kCubic: CellShape = {
  faces: prism([[0.5, -0.5], [0.5, 0.5], [-0.5, 0.5], [-0.5, -0.5]],
               [[1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0]]),
  centre: (x, y, z) => [x, y, z + 0.5],
};

function hexagon(): (readonly [number, number])[] {
  const radius = 1 / Math.sqrt(3);
  return [-30, 30, 90, 150, 210, 270].map(degrees => {
    const angle = degrees * Math.PI / 180;
    return [radius * Math.cos(angle), radius * Math.sin(angle)] as const;
  });
}

const kHexagonal: CellShape = {
  faces: prism(hexagon(), [[1, 0, 0], [0, 1, 0], [-1, 1, 0], [-1, 0, 0], [0, -1, 0], [1, -1, 0]]),
  centre: (x, y, z) => [x + y / 2, y * Math.sqrt(3) / 2, z + 0.5],
};

export function cellShape(lattice: Lattice): CellShape {
  return lattice === 'cubic' ? kCubic : kHexagonal;
}

/** The edges of a cell about its centre, a little wider than it: two places an edge. */
export function outlineOf({faces}: CellShape, wider: number): number[] {
  return faces.flatMap(({corners, neighbour}) => {
    // Sides have an upper and an upright edge each; the bottom has the lower ones.
    if (neighbour[2] > 0) return [];
    const upright = neighbour[2] === 0;
    const edges = upright ? [[1, 2], [2, 3]] : corners.map((_, i) => [i, (i + 1) % corners.length]);
    return edges.flatMap(([a, b]) => [...corners[a], ...corners[b]].map(x => x * wider));
  });
}

/** Offsets that make up a neighbourhood's slice, as rows of a drawing; null: no neighbour. */
export function sliceRows(lattice: Lattice): (readonly [number, number] | null)[][] {
  return [1, 0, -1].map(y => [-1, 0, 1].map(x => {
    const beyond = lattice === 'hexagonal' && x * y === 1;
    return beyond ? null : [x, y] as const;
  }));
}
