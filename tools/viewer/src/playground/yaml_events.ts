// SPDX-License-Identifier: MIT
// The events of a YAML text, as the program's own parser has them (lib/base/yaml_events.h): the
// tree and all that is said of it are made of these by the module, as in the program. Places are
// bytes.
import {Composer, CST, Parser} from 'yaml';

/** As YamlEvent::Kind numbers them. */
const enum Kind {
  document, null, alias, anchor, scalar, sequence, mapping, sequenceEnd, mappingEnd,
}

type Event = [Kind, number, ...(string | boolean)[]];

export interface YamlSaid {
  events: Event[];
  fault: Fault | null;
}

/** Deeper than the module takes; it says so itself. */
const kDeepest = 64;
const kNulls = new Set(['', '~', 'null', 'Null', 'NULL']);
/** Said of anchors, aliases and tags by the module, of keys too; warnings of the parser's. */
const kPassedOver = new Set(['TAG_RESOLVE_FAILED', 'DUPLICATE_KEY', 'KEY_OVER_1024_CHARS',
                             'BAD_DIRECTIVE', 'BAD_ALIAS', 'MULTIPLE_TAGS', 'MULTIPLE_ANCHORS']);

interface Fault {
  at: number;
  /** In the words of the program's parser, which the module knows. */
  reason: string;
}

/** What the program's parser calls the same mistake, and where it notices. */
function faultOf(text: string, code: string, message: string, [from, to]: [number, number]): Fault {
  const word = from + (/^[ \t]*/.exec(text.slice(from))?.[0].length ?? 0);
  if (code === 'TAB_AS_INDENT') {
    return {at: from, reason: 'illegal tab when looking for indentation'};
  }
  if (code === 'MULTILINE_IMPLICIT_KEY' || code === 'BLOCK_AS_IMPLICIT_KEY') {
    const colon = text.slice(to).search(/:(?=\s|$)/);
    return {at: colon < 0 ? text.length : to + colon, reason: 'illegal map value'};
  }
  if (message.startsWith('Sequence item without')) {
    return {at: word, reason: 'end of sequence not found'};
  }
  const flow = /^Flow (sequence|map)/.exec(message)?.[1];
  if (flow) {
    const reason = /[\]}]/.test(text.charAt(from)) ? 'illegal flow end'
        : flow === 'map' ? 'end of map flow not found' : 'end of sequence flow not found';
    return {at: from, reason};
  }
  if (/closing .?quote/i.test(message)) return {at: text.length, reason: 'illegal EOF in scalar'};
  return {at: word, reason: 'end of map not found'};
}

interface Properties {
  at: number | null;
  anchor: string | null;
  tag: string;
}

/** The anchor and the tag before a value. */
function propertiesOf(tokens: readonly CST.SourceToken[] | undefined): Properties {
  const out: Properties = {at: null, anchor: null, tag: '?'};
  for (const {type, offset, source} of tokens ?? []) {
    if (type !== 'anchor' && type !== 'tag') continue;
    out.at ??= offset;
    if (type === 'anchor') out.anchor = source.slice(1);
    else out.tag = source.startsWith('!!') ? `tag:yaml.org,2002:${source.slice(2)}` : source;
  }
  return out;
}

const kNone: Properties = {at: null, anchor: null, tag: '?'};

/** Walks what the parser has found. */
class Teller {
  readonly events: Event[] = [];
  private readonly anchors = new Set<string>();
  private depth = 0;
  /** Where the walk ended early, since something there is not as it should be. */
  fault: Fault | null = null;

  document(token: CST.Document): void {
    this.events.push([Kind.document, token.offset]);
    this.node(token.value, propertiesOf(token.start), token.offset);
  }

  private node(token: CST.Token | null | undefined, given: Properties, at: number): void {
    if (this.fault) return;
    if (!token) {
      this.named(given, at);
      // A tag or an anchor makes a text of nothing.
      if (given.tag !== '?') this.events.push([Kind.scalar, given.at ?? at, '', given.tag]);
      else this.events.push([Kind.null, at]);
      return;
    }
    const begins = given.at ?? startOf(token);
    switch (token.type) {
      case 'alias': {
        const name = token.source.slice(1);
        if (this.anchors.has(name)) this.events.push([Kind.alias, token.offset]);
        else this.fault = {at: token.offset, reason: 'the referenced anchor is not defined'};
        return;
      }
      case 'scalar':
      case 'single-quoted-scalar':
      case 'double-quoted-scalar':
      case 'block-scalar':
        this.named(given, begins);
        return this.scalar(token, given, begins);
      case 'block-map':
      case 'block-seq':
      case 'flow-collection':
        this.named(given, begins);
        return this.collection(token, given, begins);
      default:
        return;
    }
  }

  private named({anchor}: Properties, at: number): void {
    if (anchor === null) return;
    this.anchors.add(anchor);
    this.events.push([Kind.anchor, at, anchor]);
  }

  private scalar(token: CST.FlowScalar | CST.BlockScalar, given: Properties, at: number): void {
    const plain = token.type === 'scalar';
    const {value} = CST.resolveAsScalar(token, false, () => undefined);
    if (plain && given.tag === '?' && kNulls.has(value)) {
      this.events.push([Kind.null, at]);
      return;
    }
    const tag = given.tag === '?' && !plain ? '!' : given.tag;
    this.events.push([Kind.scalar, at, value, tag]);
  }

  private collection(token: CST.BlockMap | CST.BlockSequence | CST.FlowCollection,
                     given: Properties, at: number): void {
    if (++this.depth > kDeepest) return;
    const flow = token.type === 'flow-collection';
    const list = token.type === 'block-seq' ||
        token.type === 'flow-collection' && token.start.type === 'flow-seq-start';
    this.events.push([list ? Kind.sequence : Kind.mapping, at, '', given.tag, flow]);
    for (const item of token.items) {
      // What is behind the last comma, and lines of remarks, are entries of nothing.
      const written = item.key ?? item.sep ?? item.value ??
          item.start.find(one => one.type === 'explicit-key-ind' || one.type === 'seq-item-ind');
      if (!written && propertiesOf(item.start).at === null) continue;
      if (list) this.entry(item, flow);
      else this.pair(item);
    }
    if (!this.fault) this.events.push([list ? Kind.sequenceEnd : Kind.mappingEnd, at]);
    --this.depth;
  }

  /** An entry of a list, which may be a pair by itself in brackets. */
  private entry(item: CST.CollectionItem, flow: boolean): void {
    const at = item.start[0]?.offset ?? (item.value ? startOf(item.value) : 0);
    if (!flow || !item.sep) {
      this.node(item.value ?? item.key, propertiesOf(item.start), at);
      return;
    }
    this.events.push([Kind.mapping, item.key ? startOf(item.key) : at, '', '?', true]);
    this.pair(item);
    if (!this.fault) this.events.push([Kind.mappingEnd, at]);
  }

  private pair({start, key, sep, value}: CST.CollectionItem): void {
    const from = start[0]?.offset ?? (key ? startOf(key) : sep?.[0]?.offset ?? 0);
    this.node(key, start.length > 0 ? propertiesOf(start) : kNone, from);
    const colon = sep?.find(one => one.type === 'map-value-ind');
    this.node(value, propertiesOf(sep), colon ? colon.offset + 1 : from);
  }
}

/** Where a token begins: a block's first key or dash, with what stands before it. */
function startOf(token: CST.Token): number {
  if (token.type === 'block-map' || token.type === 'block-seq') {
    const first = token.items.at(0);
    const mark = first?.start.find(one => one.type !== 'space' && one.type !== 'newline' &&
                                          one.type !== 'comment');
    if (mark) return mark.offset;
    const key = first && 'key' in first ? first.key : null;
    if (key) return startOf(key);
  }
  if (token.type === 'block-scalar') {
    return token.props.find(one => one.type === 'block-scalar-header')?.offset ?? token.offset;
  }
  return token.offset;
}

/** What comes behind a value that is complete: a second document to the program's parser. */
const kFollows = 'follows';

/** The first mistake that a strict reader finds in the documents. */
function firstMistake(text: string, tokens: readonly CST.Token[]): Fault | null {
  const composer = new Composer({uniqueKeys: false, schema: 'failsafe', strict: true});
  let first: Fault | null = null, last = -1;
  for (const document of composer.compose(tokens)) {
    for (const {code, pos, message} of document.errors) {
      // Of several mistakes in one place the first says most.
      if (kPassedOver.has(code) || pos[0] === last) continue;
      last = pos[0];
      const found = message.includes('at node end') ? {at: pos[0], reason: kFollows}
                                                : faultOf(text, code, message, pos);
      if (first === null || found.at < first.at) first = found;
    }
  }
  return first;
}

/** From places in a text to places in its UTF-8 bytes; places come in rising order, or nearly. */
function bytePlaces(text: string): (place: number) => number {
  let at = 0, bytes = 0;
  const size = (code: number): number =>
    code < 0x80 ? 1 : code < 0x800 ? 2 : code >= 0xd800 && code < 0xe000 ? 2 : 3;
  return place => {
    while (at > place) bytes -= size(text.charCodeAt(--at));
    while (at < place && at < text.length) bytes += size(text.charCodeAt(at++));
    return bytes;
  };
}

/** Events before a place; what is open there stays so. */
function eventsBefore(events: Event[], place: number): Event[] {
  const cut = events.findIndex(([, at]) => at >= place);
  const out = cut < 0 ? [...events] : events.slice(0, cut);
  while ((out.at(-1)?.[0] ?? Kind.document) >= Kind.sequenceEnd) out.pop();
  return out;
}

function told(text: string): YamlSaid {
  const tokens = [...new Parser().parse(text)];
  const teller = new Teller();
  for (const token of tokens) if (token.type === 'document') teller.document(token);
  const {events, fault} = teller;
  // Of what is too deep the module says so; a reader of trees would run out of stack.
  const mistake = tooDeep(events) ? null : firstMistake(text, tokens);
  if (!mistake || fault && fault.at <= mistake.at) return {events, fault};
  if (mistake.reason !== kFollows) {
    return {events: eventsBefore(events, mistake.at), fault: mistake};
  }
  const before = events.filter(([, at]) => at < mistake.at);
  return {events: [...before, [Kind.document, mistake.at]], fault: null};
}

function tooDeep(events: readonly Event[]): boolean {
  let depth = 0;
  for (const [kind] of events) {
    if (kind === Kind.sequence || kind === Kind.mapping) ++depth;
    if (kind >= Kind.sequenceEnd) --depth;
    if (depth > kDeepest) return true;
  }
  return false;
}

export function yamlEvents(text: string): YamlSaid {
  const said = told(text);
  const place = bytePlaces(text);
  for (const event of said.events) event[1] = place(event[1]);
  if (said.fault) said.fault.at = place(said.fault.at);
  return said;
}
