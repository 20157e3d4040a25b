import tseslint from 'typescript-eslint';

export default tseslint.config(
  {
    ignores: [
      '.cache/',
      'dist/',
      'coverage/',
      'test-results/',
      'node_modules/',
      'src/pure-globals.d.ts',
    ],
  },
  {
    files: ['**/*.ts', '**/*.tsx'],
    extends: [tseslint.configs.strictTypeChecked],
    languageOptions: {
      parserOptions: {
        // One program for nearly all: five, as the compiler has them, check the pure code five times.
        project: ['./tsconfig.lint.json', './tsconfig.worker.json'],
        tsconfigRootDir: import.meta.dirname,
      },
    },
    rules: {
      // Typed-array reads in kernels are in range by construction; a guard there would be noise.
      '@typescript-eslint/no-non-null-assertion': 'off',
      '@typescript-eslint/restrict-template-expressions': ['error', { allowNumber: true }],
      '@typescript-eslint/switch-exhaustiveness-check': 'error',
      '@typescript-eslint/consistent-type-imports': 'error',
      '@typescript-eslint/no-confusing-void-expression': ['error', { ignoreArrowShorthand: true }],
      eqeqeq: 'error',
      'no-console': 'error',
    },
  },
  // What a user starts ends in a message where it fails: `attempt` of src/ui/attempt.ts sees to it.
  {
    files: ['src/{app,ui,view}/**'],
    rules: { '@typescript-eslint/no-floating-promises': ['error', { ignoreVoid: false }] },
  },
  // A part that a deploy took away is a failure with a message.
  {
    files: ['src/**'],
    ignores: ['src/cli/**'],
    rules: {
      'no-restricted-syntax': [
        'error',
        {
          selector:
            'ImportExpression:not(CallExpression[callee.name="loadPart"] > ImportExpression)',
          message: 'load it by loadPart of src/core/failure.ts',
        },
      ],
    },
  },
  // Specs patch prototypes of the page on purpose.
  { files: ['e2e/**'], rules: { '@typescript-eslint/unbound-method': 'off' } },
  { files: ['src/cli/**', 'tools/**'], rules: { 'no-console': 'off' } },
);
