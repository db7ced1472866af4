// SPDX-License-Identifier: MIT
// The page as one file, with a set of its own in it: what it is handed on as.
import {taken} from './files.js';

const kSet = '<script id="stig-set" type="text/plain">';

/** Made before anything of the page is taken away or put in. */
export class OwnPage {
  /** As behind '#' in an address (share.ts); empty in the page that is built. */
  readonly set: string;
  private readonly before: string;
  private readonly behind: string;

  constructor() {
    // It is read alone: no text of a file becomes markup.
    // eslint-disable-next-line no-restricted-properties
    const whole = document.documentElement.outerHTML;
    const begin = whole.indexOf(kSet) + kSet.length;
    const head = '<!DOCTYPE html>\n<!-- SPDX-License-Identifier: MIT -->\n';
    this.before = head + whole.slice(0, begin);
    this.behind = whole.slice(whole.indexOf('</script>', begin));
    this.set = taken('stig-set');
  }

  /** `set` in place of what it has. */
  with(set: string): string[] {
    return [this.before, set, this.behind];
  }
}
