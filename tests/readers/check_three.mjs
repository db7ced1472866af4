// SPDX-License-Identifier: MIT
// Has three.js's loaders read the samples, and compares.
//
//   node check_three.mjs FOLDER
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import * as THREE from 'three';
import {GLTFLoader} from 'three/examples/jsm/loaders/GLTFLoader.js';
import {PLYLoader} from 'three/examples/jsm/loaders/PLYLoader.js';
import {STLLoader} from 'three/examples/jsm/loaders/STLLoader.js';
import {VOXLoader} from 'three/examples/jsm/loaders/VOXLoader.js';

const folder = process.argv[2];
const manifest = JSON.parse(fs.readFileSync(path.join(folder, 'manifest.json')));

function bytes(name) {
  const buffer = fs.readFileSync(path.join(folder, name));
  return buffer.buffer.slice(buffer.byteOffset, buffer.byteOffset + buffer.length);
}

function near(got, expected, what, slack = 1e-4) {
  assert.equal(got.length, expected.length, what);
  got.forEach((g, i) => assert.ok(
      Math.abs(g - expected[i]) <= slack, `${what}: got ${got}, expected ${expected}`));
}

const triangles = geometry =>
    (geometry.index ? geometry.index.count : geometry.attributes.position.count) / 3;

function checkBox(box, expected, what, slack) {
  near(box.min.toArray(), expected.low, `${what}: lowest`, slack);
  near(box.max.toArray(), expected.high, `${what}: highest`, slack);
}

// Six times the volume is the sum of the triangles' determinants: right only when the
// surface is closed and every triangle turns outward.
function checkVolume(geometry, expected, what) {
  const plain = geometry.index ? geometry.toNonIndexed() : geometry;
  const at = plain.attributes.position;
  const [a, b, c] = [new THREE.Vector3(), new THREE.Vector3(), new THREE.Vector3()];
  let volume = 0;
  for (let i = 0; i < at.count; i += 3) {
    a.fromBufferAttribute(at, i);
    b.fromBufferAttribute(at, i + 1);
    c.fromBufferAttribute(at, i + 2);
    volume += a.dot(b.cross(c)) / 6;
  }
  near([volume], [expected.volume], `${what}: volume`, 1e-3 * expected.volume);
}

const upright = ({low, high}) =>
    ({low: [low[0], low[2], -high[1]], high: [high[0], high[2], -low[1]]});

// Loaders turn colours into linear light and back: a level of 255 may get lost.
function checkColours(got, expected, what) {
  const levels = name => [1, 3, 5].map(i => parseInt(name.slice(i, i + 2), 16));
  const alike = (a, b) => levels(a).every((level, i) => Math.abs(level - levels(b)[i]) <= 1);
  const missing = expected.filter(e => !got.some(g => alike(g, e)));
  const surplus = got.filter(g => !expected.some(e => alike(g, e)));
  assert.deepEqual([missing, surplus], [[], []], `${what}: colours missing and surplus`);
}

function colourNames(attribute) {
  const names = new Set();
  const colour = new THREE.Color();
  for (let i = 0; i < attribute.count; ++i) {
    colour.fromBufferAttribute(attribute, i);
    names.add(`#${colour.getHexString()}`);
  }
  return [...names];
}

function checkStl(name, expected) {
  const geometry = new STLLoader().parse(bytes(`${name}.stl`));
  assert.equal(triangles(geometry), expected.triangles);
  geometry.computeBoundingBox();
  checkBox(geometry.boundingBox, expected, `${name}.stl`);
  checkVolume(geometry, expected, `${name}.stl`);
}

function checkPly(name, expected) {
  const geometry = new PLYLoader().parse(bytes(`${name}.ply`));
  assert.equal(triangles(geometry), expected.merged_triangles);
  geometry.computeBoundingBox();
  checkBox(geometry.boundingBox, expected, `${name}.ply`);
  checkVolume(geometry, expected, `${name}.ply`);
  checkColours(colourNames(geometry.attributes.color), Object.keys(expected.colours), name);
}

async function checkGlb(name, expected) {
  const {scene, asset} = await new GLTFLoader().parseAsync(bytes(`${name}.glb`), '');
  assert.equal(asset.generator, 'stigc');
  const colours = [];
  let count = 0;
  scene.traverse(object => {
    if (!object.isMesh) return;
    count += triangles(object.geometry);
    colours.push(`#${object.material.color.getHexString()}`);
    assert.ok(object.material.name.length > 0);
  });
  assert.equal(count, expected.merged_triangles);
  assert.equal(colours.length, Object.keys(expected.colours).length);
  checkColours(colours, Object.keys(expected.colours), name);
  checkBox(new THREE.Box3().setFromObject(scene), upright(expected), `${name}.glb`);
}

// One brick every tenth of a second: half way through, half of them are there, and at the end the
// whole structure stands.
async function checkGrowth(name, expected) {
  const {scene, animations} = await new GLTFLoader().parseAsync(bytes(`${name}-growth.glb`), '');
  assert.equal(animations.length, 1);
  const mixer = new THREE.AnimationMixer(scene);
  const action = mixer.clipAction(animations[0]);
  action.setLoop(THREE.LoopOnce);
  action.clampWhenFinished = true;
  action.play();
  const present = () => scene.children.filter(node => node.scale.x === 1).length;
  const half = Math.floor((expected.bricks - 1) / 2);
  mixer.setTime(half / 10 + 0.05);
  // What is walled in when it comes has no node.
  const hidden = expected.bricks - scene.children.length;
  assert.ok(present() <= half + 1 && present() >= half + 1 - hidden, `${name}: half grown`);
  near([animations[0].duration], [(expected.bricks - 1) / 10], `${name}: duration`,
       0.1 * hidden + 1e-4);
  mixer.setTime(animations[0].duration);
  assert.equal(present(), scene.children.length);
  checkBox(new THREE.Box3().setFromObject(scene), upright(expected), `${name}-growth.glb`);
}

// Cells of a model in the whole: a model stands with the middle of its size, rounded
// down, where its node puts it; three's y is up.
function checkVox(name, expected) {
  const {chunks, scene} = new VOXLoader().parse(bytes(`${name}.vox`));
  const found = [];
  const nodes = scene.isMesh ? [scene] : scene.children;
  assert.equal(nodes.length, chunks.length);
  chunks.forEach((chunk, k) => {
    const {x, y, z} = nodes[k].position;
    const {size, data, palette} = chunk;
    for (let i = 0; i < data.length; i += 4) {
      const rgba = palette[data[i + 3]];
      const rgb = [rgba & 255, rgba >> 8 & 255, rgba >> 16 & 255]
                      .map(v => v.toString(16).padStart(2, '0')).join('');
      found.push([data[i] - Math.floor(size.x / 2) + x, data[i + 1] - Math.floor(size.y / 2) - z,
                  data[i + 2] - Math.floor(size.z / 2) + y, `#${rgb}`]);
    }
  });
  const order = list => list.map(cell => JSON.stringify(cell)).sort();
  assert.deepEqual(order(found), order(expected.cells));
}

for (const [name, expected] of Object.entries(manifest)) {
  checkStl(name, expected);
  checkPly(name, expected);
  await checkGlb(name, expected);
  await checkGrowth(name, expected);
  checkVox(name, expected);
  console.log(`three.js ${THREE.REVISION} reads ${name} as it was written`);
}
