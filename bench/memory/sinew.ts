import { sinewReaders } from '../readers/sinew.ts';
import { probe } from './probe.ts';

await probe(sinewReaders);
