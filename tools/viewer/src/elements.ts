// SPDX-License-Identifier: MIT
// Making elements of the page. Text is only ever text: what files say cannot become markup.

type Given = Partial<{
  class: string;
  text: string;
  title: string;
  label: string;
  type: string;
  value: string;
  id: string;
}>;

export function element<K extends keyof HTMLElementTagNameMap>(
    tag: K, given: Given = {}, ...children: (Node | string)[]): HTMLElementTagNameMap[K] {
  const out = document.createElement(tag);
  if (given.class !== undefined) out.className = given.class;
  if (given.text !== undefined) out.textContent = given.text;
  if (given.title !== undefined) out.title = given.title;
  if (given.label !== undefined) out.setAttribute('aria-label', given.label);
  if (given.type !== undefined) out.setAttribute('type', given.type);
  if (given.value !== undefined) out.setAttribute('value', given.value);
  if (given.id !== undefined) out.id = given.id;
  out.append(...children);
  return out;
}

export function button(text: string, title: string, onClick: () => void): HTMLButtonElement {
  const out = element('button', {text, title, type: 'button'});
  // A sign needs words for those who do not see it; words speak for themselves.
  if (!/[a-z]/i.test(text)) out.setAttribute('aria-label', title);
  out.addEventListener('click', onClick);
  return out;
}

export interface Choice {
  value: string;
  text: string;
}

export function select(label: string, choices: readonly Choice[],
                       onChange: (value: string) => void): HTMLSelectElement {
  const out = element('select', {label, title: label});
  for (const {value, text} of choices) out.append(element('option', {value, text}));
  out.addEventListener('change', () => onChange(out.value));
  return out;
}

export function checkbox(text: string, title: string, onChange: (on: boolean) => void):
    {row: HTMLLabelElement; box: HTMLInputElement} {
  const box = element('input', {type: 'checkbox'});
  box.addEventListener('change', () => onChange(box.checked));
  return {row: element('label', {class: 'check', title}, box, text), box};
}

/** A part of the panel under a heading. */
export function section(name: string, title: string, ...children: Node[]): HTMLElement {
  return element('section', {class: name}, element('h2', {text: title}), ...children);
}

/** A square of a colour. */
export function swatch(colour: string): HTMLSpanElement {
  const out = element('span', {class: 'swatch'});
  out.style.background = colour;
  return out;
}
