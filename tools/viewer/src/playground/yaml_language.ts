// SPDX-License-Identifier: MIT
// YAML for the editor. The parser's trees are built by recursion, and what is pasted may nest as
// deep as it likes: a text deeper than anybody writes stays without colours, so that the stack
// bears whatever comes.
import {yamlLanguage} from '@codemirror/lang-yaml';
import {Language, LanguageSupport} from '@codemirror/language';
import {NodeType, Parser, Tree, type Input, type PartialParse, type TreeFragment} from
  '@lezer/common';

const DEEPEST = 200;

/** An upper bound of how deep a text nests: open brackets, and columns before a line's own text. */
export function depthBound(text: string): number {
  let open = 0, deepest = 0, lead = 0, leading = true;
  for (let at = 0; at < text.length; ++at) {
    const letter = text.charAt(at);
    if (letter === '\n') {
      lead = 0;
      leading = true;
      continue;
    }
    leading &&= ' \t-?:'.includes(letter);
    if (leading) ++lead;
    if (letter === '[' || letter === '{') ++open;
    else if ((letter === ']' || letter === '}') && open > 0) --open;
    deepest = Math.max(deepest, open + lead);
  }
  return deepest;
}

/** A parse that is over at once, with a tree that has no nodes. */
function noParse(length: number): PartialParse {
  return {
    parsedPos: length,
    stoppedAt: null,
    stopAt: () => undefined,
    advance: () => new Tree(NodeType.none, [], [], length),
  };
}

class BoundedParser extends Parser {
  override createParse(
    input: Input, fragments: readonly TreeFragment[], ranges: readonly {from: number; to: number}[],
  ): PartialParse {
    if (depthBound(input.read(0, input.length)) > DEEPEST) return noParse(input.length);
    return yamlLanguage.parser.startParse(input, fragments, ranges);
  }
}

const bounded = new Language(yamlLanguage.data, new BoundedParser(), [], 'yaml');

export function yaml(): LanguageSupport {
  return new LanguageSupport(bounded);
}
