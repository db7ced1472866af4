// SPDX-License-Identifier: MIT
// The controls of the plane that cuts.
import {element, section, select} from './elements.js';
import {kCuts, type Cut, type ViewState} from './view_state.js';

const kText: Record<Cut, string> = {
  none: 'nothing is cut', '+x': 'from the right (+x)', '-x': 'from the left (−x)',
  '+y': 'from the back (+y)', '-y': 'from the front (−y)', '+z': 'from above (+z)',
  '-z': 'from below (−z)',
};

export function cutPanel(state: ViewState): {part: HTMLElement; show: () => void} {
  const from = select('cut', kCuts.map(value => ({value, text: kText[value]})),
                      value => state.set({cut: kCuts.find(cut => cut === value) ?? 'none'}));
  const share = element('input', {type: 'range', label: 'how far the cut goes'});
  share.min = '0';
  share.max = '1';
  share.step = '0.01';
  share.addEventListener('input', () => state.set({cutAt: Number(share.value)}));
  const show = (): void => {
    from.value = state.now.cut;
    share.value = String(state.now.cutAt);
    share.disabled = state.now.cut === 'none';
  };
  show();
  return {part: section('cut', 'Cut', from, element('label', {}, 'so far ', share)), show};
}
