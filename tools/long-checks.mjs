/**
 * The checks of `npm run test:long`, which take longer than `npm test` may. Each is a browser test
 * or a unit test, which `npm test` runs in its shortest form. Its options reach it as environment
 * variables, which the file `reads` reads.
 *
 * @typedef {{ variable: string, usual: string, form: RegExp, what: string }} LongOption
 * @typedef {{ name: string, what: string, kind: 'browser' | 'unit', tests: string, reads: string, options: Record<string, LongOption> }} LongCheck
 */

/** @type {readonly LongCheck[]} */
export const longChecks = [
  {
    name: 'soak',
    what: 'random use of the built page, one seed after the other',
    kind: 'browser',
    tests: 'e2e/soak.spec.ts',
    reads: 'e2e/soak.spec.ts',
    options: {
      seed: {
        variable: 'SOAK_SEEDS',
        usual: '1,2,3,4,5',
        form: /^\d+(,\d+)*$/,
        what: 'whole numbers with commas between them',
      },
      minutes: {
        variable: 'SOAK_MINUTES',
        usual: '10',
        form: /^\d+(\.\d+)?$/,
        what: 'how long each seed takes',
      },
    },
  },
  {
    name: 'garbage',
    what: 'good files of every format, changed at random and cut at every byte',
    kind: 'unit',
    tests: 'tests/formats/garbage',
    reads: 'tests/formats/garbage/garbage-of.ts',
    options: {
      ways: {
        variable: 'GARBAGE_WAYS',
        usual: '2000',
        form: /^\d+$/,
        what: 'in how many ways each kind of file is changed',
      },
    },
  },
  {
    name: 'ik',
    what: 'damped least squares for many targets within reach and limits',
    kind: 'unit',
    tests: 'tests/posing/ik/targets.test.ts',
    reads: 'tests/posing/ik/targets.test.ts',
    options: {
      targets: {
        variable: 'IK_TARGETS',
        usual: '200',
        form: /^\d+$/,
        what: 'how many for each of three set-ups',
      },
    },
  },
  {
    name: 'movie',
    what: 'a long movie in 1080p, the frames that wait in its encoder, and its memory',
    kind: 'browser',
    tests: 'e2e/movie.spec.ts',
    reads: 'e2e/movie.spec.ts',
    options: {
      frames: {
        variable: 'MOVIE_FRAMES',
        usual: '600',
        form: /^\d+$/,
        what: 'how many; up to 60 are made in a small picture',
      },
    },
  },
  {
    name: 'parity',
    what: 'every bundled character by every skinning method, on the GPU and on the CPU',
    kind: 'browser',
    tests: 'e2e/parity.spec.ts',
    reads: 'e2e/parity.spec.ts',
    options: {
      methods: {
        variable: 'PARITY_METHODS',
        usual: '99',
        form: /^\d+$/,
        what: 'how many a character; more than there are means all',
      },
    },
  },
  {
    name: 'jobs',
    what: 'what people come for, by pointer, by touch on a phone and by keyboard alone',
    kind: 'browser',
    tests: 'e2e/jobs.spec.ts',
    reads: 'e2e/jobs.spec.ts',
    options: {
      ways: {
        variable: 'JOBS_WAYS',
        usual: 'touch,keys',
        form: /^(pointer|touch|keys)(,(pointer|touch|keys))*$/,
        what: 'the ways beside the pointer',
      },
    },
  },
  {
    name: 'pictures',
    what: 'every picture of a scene, those too of which others show each part',
    kind: 'browser',
    tests: 'e2e/pictures.spec.ts',
    reads: 'e2e/pictures.spec.ts',
    options: {
      which: {
        variable: 'PICTURES',
        usual: 'all',
        form: /^(some|all)$/,
        what: 'some are those of npm test',
      },
    },
  },
  {
    name: 'million',
    what: 'a character of a million vertices in the built page, and its main thread meanwhile',
    kind: 'browser',
    tests: 'e2e/million.spec.ts',
    reads: 'e2e/million.spec.ts',
    options: {
      vertices: {
        variable: 'MILLION_VERTICES',
        usual: '1000000',
        form: /^\d+$/,
        what: 'how many; they must fill whole rings, as multiples of 1000 do',
      },
    },
  },
  {
    name: 'natural',
    what: 'elbows and knees of the human after inverse kinematics',
    kind: 'unit',
    tests: 'tests/posing/natural',
    reads: 'tests/support/natural-limbs.ts',
    options: {
      targets: {
        variable: 'NATURAL_TARGETS',
        usual: '300',
        form: /^\d+$/,
        what: 'how many a limb, from rest and in rows of twelve',
      },
    },
  },
  {
    name: 'natural-files',
    what: 'the same of Model1 and KAITO, where ../shared is',
    kind: 'unit',
    tests: 'tests/compat/natural-limbs.test.ts',
    reads: 'tests/support/natural-limbs.ts',
    options: {
      targets: {
        variable: 'NATURAL_TARGETS',
        usual: '300',
        form: /^\d+$/,
        what: 'how many a limb, from rest and in rows of twelve',
      },
    },
  },
];

/**
 * Returns the checks that are named on the command line, with the environment of each; all checks
 * if none is named. Throws an error with a message for the user if it does not understand a word.
 *
 * @param {readonly string[]} words such as `soak --seed 3 --minutes=2`
 * @returns {{ check: LongCheck, environment: Record<string, string> }[]}
 */
export function chosenChecks(words) {
  /** @type {string[]} */
  const names = [];
  /** @type {Map<string, string>} */
  const values = new Map();
  const split = words.flatMap((word) => /^(--\w+)=(.*)$/.exec(word)?.slice(1) ?? [word]);
  for (let i = 0; i < split.length; i++) {
    const word = split[i] ?? '';
    if (word.startsWith('--')) values.set(word.slice(2), split[++i] ?? '');
    else names.push(word);
  }
  const unknown = names.find((name) => longChecks.every((check) => check.name !== name));
  if (unknown !== undefined) throw new Error(`"${unknown}" is no long check.\n${usage()}`);
  const chosen = longChecks.filter(({ name }) => names.length === 0 || names.includes(name));
  for (const [name, value] of values) {
    const option = chosen.map(({ options }) => options[name]).find((each) => each !== undefined);
    if (!option?.form.test(value))
      throw new Error(`"--${name} ${value}" is not understood.\n${usage()}`);
  }
  return chosen.map((check) => ({
    check,
    environment: Object.fromEntries(
      Object.entries(check.options).map(([name, { variable, usual }]) => [
        variable,
        values.get(name) ?? usual,
      ]),
    ),
  }));
}

/** Describes what may follow `npm run test:long --`. */
export function usage() {
  const lines = longChecks.flatMap(({ name, what, options }) => [
    `  ${name}: ${what}`,
    ...Object.entries(options).map(
      ([option, { usual, what: meaning }]) => `    --${option} ${usual}  (${meaning})`,
    ),
  ]);
  return ['The long checks, with the values that their options have by themselves:', ...lines].join(
    '\n',
  );
}
