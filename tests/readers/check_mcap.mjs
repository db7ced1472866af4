// SPDX-License-Identifier: MIT
// Has the reader @mcap/core read what stigc replay writes, in order and by its index, and compares
// with the table of poses, and the schemas with those that @foxglove/schemas publishes.
//
//   node check_mcap.mjs STIGC SCENE
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import os from 'node:os';
import published from '@foxglove/schemas/jsonschema.js';
import {McapIndexedReader, McapStreamReader} from '@mcap/core';
import {decompress} from 'fzstd';

const [stigc, scene] = process.argv.slice(2);
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'stig-mcap-'));
process.on('exit', () => fs.rmSync(folder, {recursive: true}));
const run = (...words) => execFileSync(stigc, [...words, '-q'], {cwd: folder});
run('simulate', scene, '--duration', '3', '--trace', 'run.stigp');
run('replay', 'run.stigp', '-o', 'run.mcap', '-o', 'run.csv', '-o', 'again.mcap');
const bytes = fs.readFileSync(path.join(folder, 'run.mcap'));
assert.ok(bytes.equals(fs.readFileSync(path.join(folder, 'again.mcap'))));

const decompressHandlers = {zstd: (data, size) => decompress(data, new Uint8Array(Number(size)))};

// In the order of the file: every CRC is checked.
const stream = new McapStreamReader({decompressHandlers, validateCrcs: true, includeChunks: true});
stream.append(new Uint8Array(bytes));
const kinds = {};
for (let record; (record = stream.nextRecord());) kinds[record.type] = (kinds[record.type] ?? 0) + 1;
assert.ok(stream.done());

// By the index.
const readable = {
  size: async () => BigInt(bytes.length),
  read: async (offset, length) => new Uint8Array(bytes.subarray(Number(offset), Number(offset + length))),
};
const reader = await McapIndexedReader.Initialize({readable, decompressHandlers});
const byTopic = {};
let last = 0n;
for await (const message of reader.readMessages()) {
  assert.ok(message.logTime >= last);
  last = message.logTime;
  const {topic} = reader.channelsById.get(message.channelId);
  (byTopic[topic] ??= []).push({time: message.logTime, ...JSON.parse(new TextDecoder().decode(message.data))});
}
const counts = Object.fromEntries([...reader.channelsById.values()].map(
    channel => [channel.topic, Number(reader.statistics.channelMessageCounts.get(channel.id))]));
assert.deepEqual(counts, Object.fromEntries(Object.entries(byTopic).map(([topic, list]) => [topic, list.length])));
assert.equal(kinds.Message, Number(reader.statistics.messageCount));
assert.equal(kinds.Chunk, reader.chunkIndexes.length);

// The poses are those of the table, which leaves out what is fixed to the world.
const at = new Map();
for (const {time, transforms} of byTopic['/tf']) {
  for (const one of transforms) {
    const {x, y, z} = one.translation;
    const q = one.rotation;
    at.set(`${Number(time) / 1e9} ${one.child_frame_id}`, [x, y, z, q.w, q.x, q.y, q.z]);
  }
}
const rows = fs.readFileSync(path.join(folder, 'run.csv'), 'utf8').trim().split('\n').slice(1);
for (const row of rows) {
  const [time, body, , ...numbers] = row.split(',');
  assert.deepEqual(at.get(`${Number(time)} ${body}`), numbers.slice(0, 7).map(Number), row);
}

// Schemas: those that are published, but for what they say in prose.
const bare = schema => JSON.parse(JSON.stringify(schema, (key, value) =>
    ['description', '$comment', '$id'].includes(key) && typeof value === 'string' ? undefined : value));
for (const {name, data, encoding} of reader.schemasById.values()) {
  assert.equal(encoding, 'jsonschema');
  assert.deepEqual(JSON.parse(new TextDecoder().decode(data)), bare(published[name.split('.')[1]]), name);
}

// Every message has the fields that its schema demands, of their types.
function conforms(value, schema, where) {
  if (schema.oneOf) return assert.ok(schema.oneOf.some(word => word.const === value), where);
  const type = Array.isArray(value) ? 'array' : Number.isInteger(value) && schema.type === 'integer'
      ? 'integer' : typeof value;
  assert.equal(type, schema.type, where);
  if (type === 'array') value.forEach((item, i) => conforms(item, schema.items, `${where}[${i}]`));
  if (type !== 'object') return;
  assert.deepEqual(Object.keys(value).sort(), Object.keys(schema.properties).sort(), where);
  for (const key of Object.keys(value)) conforms(value[key], schema.properties[key], `${where}.${key}`);
}
for (const channel of reader.channelsById.values()) {
  const schema = JSON.parse(new TextDecoder().decode(reader.schemasById.get(channel.schemaId).data));
  for (const {time, ...message} of byTopic[channel.topic]) conforms(message, schema, `${channel.topic} ${time}`);
}
const bodies = new Set(rows.map(row => row.split(',')[1]));
const entities = new Set(byTopic['/scene'].flatMap(scene => scene.entities.map(entity => entity.id)));
for (const body of bodies) assert.ok(entities.has(body), body);
console.log(`@mcap/core reads ${kinds.Message} messages in ${kinds.Chunk} chunks as they were written, ` +
            `${rows.length} poses as the table has them`);
