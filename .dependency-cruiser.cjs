/**
 * The table of docs/architecture.md, "Who may import whom", as rules. Each layer lists the only
 * folders it may import; what is not listed is forbidden.
 */
const layers = {
  core: [],
  gl: [],
  formats: ['core'],
  skinning: ['core'],
  posing: ['core'],
  modelling: ['core'],
  document: ['core', 'formats', 'skinning', 'posing', 'modelling'],
  evaluation: ['core', 'skinning', 'posing', 'modelling', 'document'],
  view: [...['core', 'formats', 'skinning', 'posing', 'modelling', 'document', 'evaluation'], 'gl'],
  ui: ['core', 'formats', 'skinning', 'posing', 'modelling', 'document', 'evaluation', 'view'],
  app: [
    ...['core', 'formats', 'skinning', 'posing', 'modelling', 'document', 'evaluation'],
    ...['gl', 'view', 'ui', 'workers'],
  ],
  workers: ['core', 'formats', 'skinning', 'posing', 'modelling'],
  cli: ['core', 'formats', 'skinning', 'posing', 'modelling', 'document', 'evaluation'],
};

const layerRules = Object.entries(layers).map(([layer, allowed]) => ({
  name: `${layer}-imports`,
  comment: `src/${layer} may import only: ${['itself', ...allowed].join(', ')}`,
  severity: 'error',
  from: { path: `^src/${layer}/` },
  to: { path: '^src/', pathNot: `^src/(${[layer, ...allowed].join('|')})/` },
}));

const pure = '^src/(core|formats|skinning|posing|modelling|document|evaluation)/';

module.exports = {
  forbidden: [
    ...layerRules,
    {
      name: 'core-libraries',
      comment: 'core knows gl-matrix only',
      severity: 'error',
      from: { path: '^src/core/' },
      to: { path: 'node_modules', pathNot: 'node_modules/gl-matrix/' },
    },
    {
      name: 'gl-libraries',
      comment: 'the GL layer knows no library',
      severity: 'error',
      from: { path: '^src/gl/' },
      to: { path: 'node_modules' },
    },
    {
      name: 'pure-without-page',
      comment: 'core to evaluation run in Node and in workers',
      severity: 'error',
      from: { path: pure },
      to: { path: 'node_modules/(preact|lil-gui|@preact/signals/)' },
    },
    {
      name: 'pure-without-node',
      comment: 'core to evaluation run in the page',
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
      from: { path: '^src/' },
      to: { path: '^(tests|e2e|bench|tools)/' },
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
