/**
 * A row of the table in docs/performance.md: what is measured against what, and what is wanted. The
 * value of a row is found by its group in bench/groups.
 */
export interface Goal {
  readonly id: string;
  readonly group: GroupId;
  readonly contender: string;
  readonly against: string;
  /** Whether a good value is high (how many times as fast) or low (how many times as long). */
  readonly good: 'high' | 'low';
  readonly unit: '×' | 'ms' | 'KB' | 'bytes';
  readonly must: number;
  readonly aim: number;
}

export type GroupId =
  | 'skinning'
  | 'readers'
  | 'memory'
  | 'kinematics'
  | 'inverse-kinematics'
  | 'clip-edits'
  | 'frames'
  | 'command-line'
  | 'first-frame'
  | 'steady-state'
  | 'scaling';

type Faster = readonly [id: string, contender: string, against: string, must: number, aim: number];

export const goals: readonly Goal[] = [
  ...faster('skinning', [
    [
      'wasm-normals',
      'CPU skinning in WebAssembly, 4 influences, 100k vertices, positions and normals',
      'three.js `applyBoneTransform`, positions alone',
      15,
      22,
    ],
    ['wasm-positions', 'the same, positions alone', 'the same', 20, 26],
    [
      'wasm-varied',
      'any number of influences (3 on average), positions alone',
      'three.js with 4',
      14,
      22,
    ],
    ['wasm-babylon', 'positions and normals', 'Babylon `applySkeleton`', 15, 22],
    [
      'strict-normals',
      'strict TypeScript (the definition), positions and normals',
      'three.js, positions alone',
      1.5,
      2.5,
    ],
  ]),
  {
    ...{ id: 'wasm-native', group: 'skinning', contender: 'the WebAssembly kernel' },
    ...{ against: 'native C++ `-O3 -march=native`, the same algorithm' },
    ...{ good: 'low', unit: '×', must: 2, aim: 1.3 },
  },
  {
    ...{ id: 'wasm-dual', group: 'skinning', contender: 'dual quaternions in WebAssembly' },
    ...{ against: 'linear blend in WebAssembly, the same mesh', good: 'low', unit: '×' },
    ...{ must: 1.5, aim: 1.2 },
  },
  ...faster('skinning', [
    ['dense', 'a dense `.attach` row (17 columns)', 'gl-matrix loop', 10, 50],
  ]),
  ...faster('readers', [
    ['obj', 'OBJ, 100k vertices', 'three.js OBJLoader', 7, 12],
    ['attach', '`.attach` to sparse rows, 100k lines', '`split().map(parseFloat)`', 2.5, 4],
    ['skin', 'CSE169 `.skin`', '`split`', 2.5, 4],
    ['pmd', 'PMD (12k vertices)', 'mmd-parser', 3, 10],
  ]),
  ...faster('kinematics', [
    [
      'kinematics',
      'forward kinematics, 1,000 joints of three hinges',
      'three.js `updateMatrixWorld`',
      1.5,
      2.5,
    ],
  ]),
  {
    ...{ id: 'ik-frame', group: 'inverse-kinematics', unit: 'ms', good: 'low', must: 2, aim: 1 },
    ...{ contender: 'a frame of a drag, two hands, 30 degrees of freedom', against: 'the clock' },
  },
  {
    ...{ id: 'clip-edit', group: 'clip-edits', unit: 'ms', good: 'low', must: 4, aim: 1 },
    ...{ contender: 'an edit of a clip of 100 joints × 1,000 keys', against: 'the clock' },
  },
  ...faster('frames', [
    ['frame-posed-13k', 'a posed frame without a GPU, 13k vertices', 'three.js', 1.2, 2],
    ['frame-posed-100k', 'the same, 100k vertices', 'three.js', 1.2, 2],
    ['frame-camera-13k', 'the camera alone moves, 13k vertices', 'three.js, map kept', 1.2, 2],
    ['frame-camera-100k', 'the same, 100k vertices', 'three.js, map kept', 1.2, 2],
  ]),
  ...(['13k', '100k'] as const).map((size): Goal => ({
    ...{ id: `frame-still-${size}`, group: 'frames', unit: '×' },
    ...{ contender: `unchanged pose, drawn again, ${size} vertices` },
    ...{ against: 'own unskinned draw', good: 'low', must: 1.25, aim: 1.05 },
  })),
  {
    ...{ id: 'info', group: 'command-line', contender: 'the command line: `info` on a human' },
    ...{ against: '`node -e 0`', good: 'low', unit: '×', must: 4, aim: 2.5 },
  },
  ...(['obj', 'attach', 'skin', 'pmd'] as const).map((kind): Goal => ({
    ...{ id: `memory-${kind}`, group: 'memory', contender: `peak memory while reading .${kind}` },
    ...{ against: 'size of the file', good: 'low', unit: '×', must: 4, aim: 2 },
  })),
  {
    ...{ id: 'first-scripts', group: 'first-frame', unit: 'KB', good: 'low', must: 60, aim: 35 },
    ...{ contender: 'scripts before the first frame, gzipped', against: 'three.js minimal viewer' },
  },
  {
    ...{ id: 'first-frame', group: 'first-frame', unit: '×', good: 'low', must: 1, aim: 0.75 },
    ...{ contender: 'time to first frame, same model', against: 'three.js minimal viewer' },
  },
  {
    ...{ id: 'heap', group: 'steady-state', unit: 'bytes', good: 'low', must: 0, aim: 0 },
    ...{ contender: 'steady state: bytes of heap a frame, on the skinning path', against: 'heap' },
  },
];

function faster(group: GroupId, rows: readonly Faster[]): Goal[] {
  return rows.map(([id, contender, against, must, aim]) => ({
    ...{ id, group, contender, against, good: 'high', unit: '×', must, aim },
  }));
}
