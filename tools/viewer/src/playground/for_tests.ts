// SPDX-License-Identifier: MIT
// What tests without a browser ask for.
export {completionsAt} from './completion.js';
export {startModule} from './module.js';
export {hashOfShared, sharedOfHash} from './share.js';
export {yamlEvents} from './yaml_events.js';
