/**
 * These rules enforce the table "Who may import whom" of docs/architecture.md. Each layer lists the
 * folders that it may import; all others are forbidden.
 */
const layers = {
  core: [],
  gl: [],
  formats: ['core'],
  skinning: ['core'],
  posing: ['core'],
  document: ['core', 'formats', 'skinning', 'posing'],
  evaluation: ['core', 'skinning', 'posing', 'document'],
  view: ['core', 'formats', 'skinning', 'posing', 'document', 'evaluation', 'gl'],
  ui: ['core', 'formats', 'skinning', 'posing', 'document', 'evaluation', 'view'],
  app: [
    ...['core', 'formats', 'skinning', 'posing', 'document', 'evaluation'],
    ...['gl', 'view', 'ui', 'workers'],
  ],
  workers: ['core', 'formats', 'skinning', 'posing', 'document', 'evaluation'],
  cli: ['core', 'formats', 'skinning', 'posing', 'document', 'evaluation'],
};

const layerRules = Object.entries(layers).map(([layer, allowed]) => ({
  name: `${layer}-imports`,
  comment: `src/${layer} may import only: ${['itself', ...allowed].join(', ')}`,
  severity: 'error',
  from: { path: `^src/${layer}/` },
  to: { path: '^src/', pathNot: `^src/(${[layer, ...allowed].join('|')})/` },
}));

const pure = '^src/(core|formats|skinning|posing|document|evaluation)/';

module.exports = {
  forbidden: [
    ...layerRules,
    {
      name: 'core-libraries',
      comment: 'core may import no library except gl-matrix',
      severity: 'error',
      from: { path: '^src/core/' },
      to: { path: 'node_modules', pathNot: 'node_modules/gl-matrix/' },
    },
    {
      name: 'gl-libraries',
      comment: 'gl may import no library',
      severity: 'error',
      from: { path: '^src/gl/' },
      to: { path: 'node_modules' },
    },
    {
      name: 'pure-without-page',
      comment: 'the layers from core to evaluation also run in Node and in workers',
      severity: 'error',
      from: { path: pure },
      to: { path: 'node_modules/(preact|lil-gui|@preact/signals/)' },
    },
    {
      name: 'pure-without-node',
      comment: 'the layers from core to evaluation also run in the page',
      severity: 'error',
      from: { path: pure },
      to: { dependencyTypes: ['core'] },
    },
    {
      name: 'no-circles',
      severity: 'error',
      from: {},
      to: { circular: true, viaOnly: { dependencyTypesNot: ['type-only'] } },
    },
    {
      name: 'product-without-tests',
      severity: 'error',
      // From its sources, the command line compiles the WebAssembly kernel by the tools' function.
      from: { path: '^src/', pathNot: '^src/cli/wasm-kernel\\.ts$' },
      to: { path: '^(tests|e2e|bench|tools)/' },
    },
    {
      name: 'peers-in-bench',
      comment: 'the programs that Sinew is measured against are installed for the bench alone',
      severity: 'error',
      from: { pathNot: '^bench/' },
      to: { path: '^bench/(peers|node_modules)/' },
    },
  ],
  options: {
    doNotFollow: { path: 'node_modules' },
    tsPreCompilationDeps: true,
    tsConfig: { fileName: 'tsconfig.page.json' },
    enhancedResolveOptions: {
      exportsFields: ['exports'],
      conditionNames: ['import', 'types', 'node'],
    },
  },
};
