import { probe } from '../memory/probe.ts';
import { peerReaders } from './readers.mjs';

await probe(peerReaders);
