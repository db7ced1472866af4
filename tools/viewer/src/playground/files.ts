// SPDX-License-Identifier: MIT
// What the page brings along, and what it hands out.

export interface NamedText {
  name: string;
  text: string;
}

/** Rule sets that ship, and the robot and the block that `compile` takes. */
export interface Shipped {
  sets: NamedText[];
  robot: NamedText;
  block: NamedText;
}

/** The text of an element of the page, which is then taken away. */
export function taken(id: string): string {
  const found = document.getElementById(id);
  if (!found) throw new Error(`the page has no '${id}'`);
  found.remove();
  return found.textContent;
}

export function save(name: string, parts: BlobPart[]): void {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob(parts));
  link.download = name;
  link.click();
  // After the browser has begun to read it.
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}
