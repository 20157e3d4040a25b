import tseslint from 'typescript-eslint';

export default tseslint.config(
  {
    ignores: [
      '.cache/',
      'dist/',
      'build/',
      'coverage/',
      'test-results/',
      '**/node_modules/',
      'src/pure-globals.d.ts',
    ],
  },
  {
    files: ['**/*.ts', '**/*.tsx'],
    extends: [tseslint.configs.strictTypeChecked],
    languageOptions: {
      parserOptions: {
        // One program covers nearly all files. The compiler's five programs would check the pure code
        // five times.
        project: ['./tsconfig.lint.json', './tsconfig.worker.json'],
        tsconfigRootDir: import.meta.dirname,
      },
    },
    rules: {
      // Typed-array reads in kernels are in range by construction, so guards would only be noise.
      '@typescript-eslint/no-non-null-assertion': 'off',
      '@typescript-eslint/restrict-template-expressions': ['error', { allowNumber: true }],
      '@typescript-eslint/switch-exhaustiveness-check': 'error',
      '@typescript-eslint/consistent-type-imports': 'error',
      '@typescript-eslint/no-confusing-void-expression': ['error', { ignoreArrowShorthand: true }],
      eqeqeq: 'error',
      'no-console': 'error',
    },
  },
  // If an action of the user fails, `attempt` of src/ui/attempt.ts must show a message.
  {
    files: ['src/{app,ui,view}/**'],
    rules: { '@typescript-eslint/no-floating-promises': ['error', { ignoreVoid: false }] },
  },
  // loadPart reports a part that a deploy removed from the server as a failure with a message.
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
  // Specs patch prototypes of the page intentionally.
  { files: ['e2e/**'], rules: { '@typescript-eslint/unbound-method': 'off' } },
  { files: ['src/cli/**', 'tools/**', 'bench/**'], rules: { 'no-console': 'off' } },
);
