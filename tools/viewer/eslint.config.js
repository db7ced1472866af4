// SPDX-License-Identifier: MIT
import tseslint from 'typescript-eslint';

export default tseslint.config(
    {ignores: ['node_modules', 'build']},
    {
      files: ['src/**/*.ts'],
      extends: [...tseslint.configs.strictTypeChecked, ...tseslint.configs.stylisticTypeChecked],
      languageOptions: {parserOptions: {projectService: true}},
      rules: {
        '@typescript-eslint/restrict-template-expressions': ['error', {allowNumber: true}],
        '@typescript-eslint/no-confusing-void-expression': 'off',
        '@typescript-eslint/prefer-for-of': 'off',
        'max-len': ['error', {code: 100}],
        'max-lines': ['error', 400],
        'max-lines-per-function': ['error', {max: 40}],
        'no-restricted-properties': ['error',
          {property: 'innerHTML', message: 'text of files must stay text'},
          {property: 'outerHTML', message: 'text of files must stay text'},
          {property: 'insertAdjacentHTML', message: 'text of files must stay text'}],
      },
    });
