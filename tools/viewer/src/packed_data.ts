// SPDX-License-Identifier: MIT
// The data of a page, as lib/view/page_data.cpp packs them: base64 of a zlib stream that holds the
// size of a JSON text as u32, the text, and the bytes that columns of numbers lie in. Integers
// are little-endian.

/** Where a column of whole numbers lies: `count` differences, each a zigzag varint. */
export interface ColumnPlace {
  at: number;
  count: number;
}

export interface PackedData {
  json: unknown;
  bytes: Uint8Array;
}

export function bytesOfBase64(text: string): Uint8Array<ArrayBuffer> {
  const binary = atob(text.trim());
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

export async function inflated(bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array> {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

export async function unpack(text: string): Promise<PackedData> {
  const all = await inflated(bytesOfBase64(text));
  const size = new DataView(all.buffer, all.byteOffset).getUint32(0, true);
  const json: unknown = JSON.parse(new TextDecoder().decode(all.subarray(4, 4 + size)));
  return {json, bytes: all.subarray(4 + size)};
}

/** The numbers of a column: sums of its differences. */
export function column(data: PackedData, place: ColumnPlace): Float64Array {
  const {bytes} = data;
  const out = new Float64Array(place.count);
  let at = place.at, value = 0;
  for (let i = 0; i < place.count; ++i) {
    // Seven bits a byte; beyond 31 bits only multiplication keeps them all.
    let difference = 0, scale = 1, byte = 0;
    do {
      byte = bytes[at++];
      difference += (byte & 127) * scale;
      scale *= 128;
    } while (byte > 127);
    value += difference % 2 === 0 ? difference / 2 : -(difference + 1) / 2;
    out[i] = value;
  }
  return out;
}

export function integers(data: PackedData, place: ColumnPlace): Int32Array {
  return new Int32Array(column(data, place));
}
