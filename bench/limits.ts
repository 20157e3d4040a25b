const strictOrder =
  'every operation is rounded in a fixed order, so no multiplication joins an addition';
const fragments = 'SwiftShader shades each of 780,000 pixels on the CPU; vertices cost less';
const firstVisit =
  'a context, three files read by code that is still cold, and five programs that SwiftShader compiles take turns on two cores';

/** What limits a value where it misses its aim; by the ids of bench/goals.ts. */
export const limits: Readonly<Record<string, string>> = {
  'wasm-normals': strictOrder,
  'wasm-positions': strictOrder,
  'wasm-varied': strictOrder,
  'wasm-babylon': strictOrder,
  'strict-normals': 'JavaScript has no vectors of four, and rounds after each operation',
  'wasm-native': strictOrder,
  dense: 'the zeros are left out when the file is read; what remains are four influences',
  obj: 'the bytes are checked for encoding, and every number and face for its range',
  attach: 'all 17 numbers of a row are read, though most are zero',
  skin: 'numbers have up to nine digits, and blocks may be in any order',
  pmd: 'names are decoded from Shift-JIS, and every section is checked',
  kinematics: 'sines and cosines take most of the time, for both',
  'ik-frame': 'a matrix of 30 × 30 is filled and factorized in each of at most ten steps',
  'clip-edit': 'the 1,000 keys of the edited curve are copied, and its spans computed anew',
  'frame-posed-13k': fragments,
  'frame-posed-100k': fragments,
  'frame-camera-13k': fragments,
  'frame-camera-100k': fragments,
  'frame-still-13k': fragments,
  'frame-still-100k': fragments,
  info: 'Node loads and compiles the command line, then reads three files',
  'memory-obj': 'numbers are collected in arrays that grow',
  'memory-skin': 'numbers are collected in arrays that grow',
  'memory-pmd':
    'numbers of two bytes become four, and the engine reserves some megabytes for itself',
  'first-scripts': 'the viewer, the store and the reader of the first character',
  'first-frame': firstVisit,
  heap: 'numbers that functions return are boxed',
};
