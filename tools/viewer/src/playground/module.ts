// SPDX-License-Identifier: MIT
// The module made of the program's libraries (tools/playground): questions in, answers out. It asks
// for little; a clock, chance for nothing but hash tables' sake, and the events of YAML texts.
import type {YamlSaid} from './yaml_events.js';

interface Exports {
  memory: WebAssembly.Memory;
  _initialize: () => void;
  malloc: (size: number) => number;
  free: (at: number) => void;
  stig_answer: (question: number) => number;
}

export type Ask = (question: Record<string, unknown>) => Record<string, unknown>;

type Imported = Record<string, (...given: never[]) => unknown>;

const kGood = 0, kNoSuchFile = 8;

class Texts {
  constructor(readonly exports: Exports) {}

  write(text: string): number {
    const bytes = new TextEncoder().encode(text);
    const at = this.exports.malloc(bytes.length + 1);
    const memory = new Uint8Array(this.exports.memory.buffer);
    memory.set(bytes, at);
    memory[at + bytes.length] = 0;
    return at;
  }

  read(at: number): string {
    const memory = new Uint8Array(this.exports.memory.buffer);
    return new TextDecoder().decode(memory.subarray(at, memory.indexOf(0, at)));
  }
}

/** What the module may ask for, by the names that its standard library has for it. */
function imported(texts: () => Texts, yamlEvents: (text: string) => YamlSaid): Imported {
  const view = (): DataView => new DataView(texts().exports.memory.buffer);
  return {
    yaml_events: (at: number) => texts().write(JSON.stringify(yamlEvents(texts().read(at)))),
    emscripten_notify_memory_growth: () => undefined,
    clock_time_get: (_clock: number, _precision: bigint, at: number) => {
      view().setBigUint64(at, BigInt(Math.round(performance.now() * 1e6)), true);
      return kGood;
    },
    environ_sizes_get: (count: number, size: number) => {
      view().setUint32(count, 0, true);
      view().setUint32(size, 0, true);
      return kGood;
    },
    environ_get: () => kGood,
    fd_close: () => kNoSuchFile,
    fd_seek: () => kNoSuchFile,
    fd_write: () => kNoSuchFile,
    getentropy: (at: number, size: number) => {
      new Uint8Array(texts().exports.memory.buffer, at, size).fill(0);
      return kGood;
    },
    proc_exit: (code: number) => {
      throw new Error(`the module ended itself (${code})`);
    },
  };
}

export async function startModule(bytes: Uint8Array<ArrayBuffer>,
                                  yamlEvents: (text: string) => YamlSaid): Promise<Ask> {
  const module = await WebAssembly.compile(bytes);
  let texts: Texts | null = null;
  const all = imported(() => {
    if (!texts) throw new Error('the module has not begun');
    return texts;
  }, yamlEvents);
  const imports: Record<string, Record<string, WebAssembly.ImportValue>> = {};
  for (const {module: from, name} of WebAssembly.Module.imports(module)) {
    if (!(name in all)) throw new Error(`the module asks for '${name}', which is not there`);
    (imports[from] ??= {})[name] = all[name];
  }
  const instance = await WebAssembly.instantiate(module, imports);
  const exports = instance.exports as unknown as Exports;
  const begun = texts = new Texts(exports);
  exports._initialize();
  return question => {
    const asked = begun.write(JSON.stringify(question));
    const said = exports.stig_answer(asked);
    exports.free(asked);
    const text = begun.read(said);
    exports.free(said);
    return JSON.parse(text) as Record<string, unknown>;
  };
}
