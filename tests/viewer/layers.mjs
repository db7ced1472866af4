// SPDX-License-Identifier: MIT
// The layers of the viewer's sources: each imports its own layer and those before it, in no circle,
// and runs as data know neither three.js nor the document.
import fs from 'node:fs';
import path from 'node:path';

const kLayers = {
  data: ['bricks', 'cells', 'chart_path', 'colours', 'decision', 'devices', 'packed_data',
         'pose_difference', 'pose_run', 'runs', 'senses', 'shown_values', 'target',
         'target_place'],
  chosen: ['permalink', 'player', 'view_state'],
  drawn: ['body_shapes', 'cell_outline', 'coarse', 'cut', 'faces', 'floor', 'forces', 'lattice_view',
          'mark_lines', 'pick', 'pose_marks', 'pose_target', 'pose_view', 'scene_marks', 'stage', 'viewpoint'],
  page: ['brick_story', 'camera_picture', 'cut_panel', 'elements', 'key_actions', 'keys',
         'lattice_panel', 'live', 'live_bar', 'live_hand', 'live_link', 'live_run', 'local_states',
         'main', 'palette_select', 'plot', 'pose_panel',
         'refusal_part', 'robot_eyes', 'robot_pane', 'time_bar', 'viewer'],
};

const folder = process.argv[2];
const names = Object.keys(kLayers);
const layerOf = source => names.findIndex(name => kLayers[name].includes(source));
const problems = [];
const imports = new Map();

for (const file of fs.readdirSync(folder).filter(name => name.endsWith('.ts'))) {
  const source = file.slice(0, -3), text = fs.readFileSync(path.join(folder, file), 'utf8');
  const layer = layerOf(source);
  if (layer < 0) problems.push(`${file} is in no layer: tests/viewer/layers.mjs lists them`);
  imports.set(source, [...text.matchAll(/from '\.\/(\w+)\.js'/g)].map(([, name]) => name));
  for (const other of imports.get(source)) {
    if (layerOf(other) > layer) problems.push(`${file} imports ${other} of a later layer`);
  }
  const outside = /from 'three|\bdocument\.|\bwindow\./.exec(text);
  if (names[layer] === 'data' && outside) problems.push(`${file} is data, and has ${outside[0]}`);
}

/** Follows imports from a source; what is on the way already closes a circle. */
const done = new Set();
function follow(source, way) {
  if (way.includes(source)) problems.push(`a circle: ${[...way, source].join(' → ')}`);
  if (way.includes(source) || done.has(source)) return;
  for (const other of imports.get(source) ?? []) follow(other, [...way, source]);
  done.add(source);
}
for (const source of imports.keys()) follow(source, []);

for (const problem of problems) console.error(problem);
process.exit(problems.length > 0 ? 1 : 0);
