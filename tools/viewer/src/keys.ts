// SPDX-License-Identifier: MIT
// Keys for everything, and the sheet that lists them.
import {button, element} from './elements.js';

export interface KeyAction {
  /** As KeyboardEvent.key has it; several do the same. */
  keys: readonly string[];
  /** As the sheet shows them. */
  shown: string;
  does: string;
  run: (event: KeyboardEvent) => void;
}

/** Does an element take letters for itself? */
function takesText(target: EventTarget | null): boolean {
  return target instanceof HTMLInputElement && ['text', 'number'].includes(target.type) ||
      target instanceof HTMLSelectElement ||
      target instanceof HTMLElement && target.isContentEditable;
}

/** Keys of a slider or a button with the focus stay its own. */
function isItsOwn(event: KeyboardEvent): boolean {
  const {target, key} = event;
  if (takesText(target)) return true;
  if (target instanceof HTMLButtonElement) return key === ' ' || key === 'Enter';
  return target instanceof HTMLInputElement &&
      (target.type === 'range' ? key.startsWith('Arrow') || key === 'Home' || key === 'End'
                               : key === ' ');
}

/** Keys anywhere on the page, or within an element that is a part of it. */
export function listen(target: Document | HTMLElement, actions: readonly KeyAction[]): void {
  const byKey = new Map(actions.flatMap(action => action.keys.map(key => [key, action] as const)));
  target.addEventListener('keydown', given => {
    const event = given as KeyboardEvent;
    // A part of the page may have taken it.
    if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return;
    if (isItsOwn(event)) return;
    const action = byKey.get(event.key);
    if (!action) return;
    event.preventDefault();
    action.run(event);
  });
}

export function keySheet(actions: readonly KeyAction[], close: () => void): HTMLElement {
  const rows = actions.map(({shown, does}) => element(
      'tr', {}, element('td', {}, element('kbd', {text: shown})), element('td', {text: does})));
  rows.push(element('tr', {}, element('td', {text: 'drag, wheel'}),
                    element('td', {text: 'turn, zoom; with the right button: move'})));
  rows.push(element('tr', {}, element('td', {text: 'click'}),
                    element('td', {text: 'what is there, and where it comes from'})));
  const out = element('div', {class: 'sheet'}, element('h2', {text: 'Keys'}),
                      element('table', {}, element('tbody', {}, ...rows)),
                      button('Close', 'close (Escape)', close));
  out.setAttribute('role', 'dialog');
  out.setAttribute('aria-label', 'keys');
  return out;
}
