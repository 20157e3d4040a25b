import { MMDParser } from 'mmd-parser';
import { OBJLoader } from 'three/examples/jsm/loaders/OBJLoader.js';

const decoder = new TextDecoder();

/** What people would pick instead, from the bytes of a file. */
export const peerReaders = {
  obj: (bytes) => new OBJLoader().parse(decoder.decode(bytes)),
  attach: (bytes) =>
    decoder
      .decode(bytes)
      .trim()
      .split('\n')
      .map((line) => line.trim().split(' ').map(parseFloat)),
  skin: (bytes) => decoder.decode(bytes).split(/\s+/).map(parseFloat),
  pmd: (bytes) => new MMDParser.Parser().parsePmd(bytes.buffer, false),
};
