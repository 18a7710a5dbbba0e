// The rules for JavaScript, as .clang-tidy has those for C++: tools/lint puts this file beside eslint's packages.
import js from '@eslint/js';
import globals from 'globals';

export default [
  {
    ...js.configs.recommended,
    linterOptions: { reportUnusedDisableDirectives: 'error' },
    rules: {
      ...js.configs.recommended.rules,
      'eqeqeq': ['error', 'smart'],
      'no-else-return': 'error',
      'no-shadow': 'error',
      'no-var': 'error',
      'prefer-const': 'error',
    },
  },
  { files: ['**/*.mjs'], languageOptions: { globals: globals.node } },
  // The page, and what runs pieces of itself in it.
  { files: ['web/report/src/*.js', 'tests/report/*.mjs', 'bench/*.mjs'], languageOptions: { globals: globals.browser } },
];
