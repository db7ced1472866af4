// SPDX-License-Identifier: MIT
// All that the page hands out as files: what was written, what was built, and why it is right.
import {bytesOfBase64} from '../packed_data.js';
import type {Answer, Question} from './answers.js';
import {save} from './files.js';
import type {Show} from './show.js';

interface Given {
  text: () => string;
  show: Show;
  /** The page itself, with the set as it is now. */
  page: () => string[];
  say: (words: string) => void;
  ask: (question: Question) => Promise<Answer>;
}

export class Saving {
  /** The last run's structure. */
  private structure = '';
  private certificate = '';
  /** Of the runs on show, in base64. */
  private traces: string[] = [];

  constructor(private readonly given: Given) {}

  ran({files}: Answer): void {
    if (!files) return;
    this.structure = files.json;
    this.traces = [files.stigt];
    // Of rules that may have changed since.
    this.certificate = '';
  }

  verified({traces, certificate}: Answer): void {
    if (traces && traces.length > 0) this.traces = traces.map(({stigt}) => stigt);
    this.certificate = certificate ?? '';
  }

  /** `what`: the ending of a file, or `second`: the other trace. */
  async save(what: string): Promise<void> {
    const name = /^name: *"?([\w.-]+)/m.exec(this.given.text())?.[1] ?? 'rules';
    if (what === 'yaml') save(`${name}.yaml`, [this.given.text()]);
    else if (what === 'html') save(`${name}.html`, this.given.page());
    else if (what === 'stigt') this.saveTrace(`${name}.stigt`, 0, 'there is no run yet');
    else if (what === 'second') this.saveTrace(`${name}-2.stigt`, 1, 'there is one run alone');
    else if (what === 'png') await this.savePicture(`${name}.png`);
    else if (what === 'cert') this.saveCertificate(`${name}.cert`);
    else await this.saveStructure(name, what);
  }

  private saveTrace(name: string, number: number, lacking: string): void {
    if (number >= this.traces.length) this.given.say(lacking);
    else save(name, [bytesOfBase64(this.traces[number])]);
  }

  private saveCertificate(name: string): void {
    if (this.certificate) save(name, [this.certificate]);
    else this.given.say('there is no certificate: nothing is proved yet');
  }

  private async savePicture(name: string): Promise<void> {
    const picture = await this.given.show.picture();
    if (picture) save(name, [picture]);
    else this.given.say('there is nothing to be seen yet');
  }

  private async saveStructure(name: string, ending: string): Promise<void> {
    if (!this.structure) {
      this.given.say('there is no run yet');
      return;
    }
    if (ending === 'json') {
      save(`${name}.json`, [this.structure]);
      return;
    }
    const target = {name: 'structure.json', text: this.structure};
    const text = this.given.text(), palette = this.given.show.viewer?.state.now.palette;
    try {
      const {file, problem} = await this.given.ask(
          {do: 'structure', target, ending, text, palette});
      if (file) save(`${name}.${ending}`, [bytesOfBase64(file)]);
      else this.given.say(problem ?? 'there is no such file of this structure');
    } catch (error) {
      this.given.say(String(error));
    }
  }
}
