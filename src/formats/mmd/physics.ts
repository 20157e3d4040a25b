import type { DiagnosticLog } from '../../core/diagnostics.ts';
import {
  type BodyJoint,
  bodyShapes,
  type MmdPhysics,
  type Numbers3,
  type RigidBody,
} from './mmd-parts.ts';
import type { BinaryReader } from '../binary/binary-reader.ts';
import type { BinaryRecord } from '../binary/binary-record.ts';
import { decodeName } from './decode-name.ts';
import { Findings } from './findings.ts';
import { mirrorAngles, mirrorPoint } from './mirror.ts';

const [bodySize, jointSize] = [83, 124];
const noBone = 0xffff;

/** Reads rigid bodies and the joints between them; entries that refer to nothing are left out. */
export function readPhysics(
  reader: BinaryReader,
  boneCount: number,
  log: DiagnosticLog,
): MmdPhysics | undefined {
  const bodies = reader.array(4, bodySize, 'rigid bodies');
  const joints = bodies && reader.array(4, jointSize, 'joints of rigid bodies');
  if (!joints) return undefined;
  const findings = new Findings();
  const number = (records: BinaryRecord, at: number): number => {
    const value = records.f32(at);
    if (Number.isFinite(value)) return value;
    findings.add(records.offset + at, `${value}`);
    return 0;
  };
  const physics = {
    bodies: Array.from({ length: bodies.count }, (_, index) => {
      return readBody(bodies.records, index, boneCount, number, findings);
    }),
    joints: Array.from({ length: joints.count }, (_, index) => {
      return readJoint(joints.records, index, bodies.count, number, findings);
    }).filter((joint) => joint !== undefined),
  };
  const expected = 'rigid bodies and joints by numbers, of bones and bodies that are there';
  findings.warn(log, 'pmd/index', expected, 'what is not is left out');
  return physics;
}

type ReadNumber = (records: BinaryRecord, at: number) => number;

function readBody(
  records: BinaryRecord,
  index: number,
  boneCount: number,
  number: ReadNumber,
  findings: Findings,
): RigidBody {
  const at = index * bodySize;
  const triple = tripleReader(records, at, number);
  return {
    name: decodeName(records.bytes(at, 20)),
    bone: boneOf(),
    group: records.u8(at + 22),
    mask: records.u16(at + 23),
    shape: shapeOf(),
    size: triple(26),
    position: mirrorPoint(triple(38)),
    rotation: mirrorAngles(triple(50)),
    mass: number(records, at + 62),
    linearDamping: number(records, at + 66),
    angularDamping: number(records, at + 70),
    restitution: number(records, at + 74),
    friction: number(records, at + 78),
    mode: records.u8(at + 82),
  };

  function boneOf(): number {
    const bone = records.u16(at + 20);
    if (bone < boneCount) return bone;
    if (bone !== noBone) findings.add(records.offset + at + 20, `bone ${bone}, body ${index}`);
    return -1;
  }

  function shapeOf(): RigidBody['shape'] {
    const shape = records.u8(at + 25);
    if (shape >= bodyShapes.length) findings.add(records.offset + at + 25, `shape ${shape}`);
    return bodyShapes[shape] ?? 'sphere';
  }
}

/** Returns nothing if one of its bodies does not exist. */
function readJoint(
  records: BinaryRecord,
  index: number,
  bodyCount: number,
  number: ReadNumber,
  findings: Findings,
): BodyJoint | undefined {
  const at = index * jointSize;
  const triple = tripleReader(records, at, number);
  const bodies = [records.u32(at + 20), records.u32(at + 24)] as const;
  const missing = bodies.find((body) => body >= bodyCount);
  if (missing !== undefined) {
    findings.add(records.offset + at + 20, `body ${missing}, joint ${index}`);
    return undefined;
  }
  const [positionMin, positionMax] = [mirrorPoint(triple(52)), mirrorPoint(triple(64))];
  const [rotationMin, rotationMax] = [mirrorAngles(triple(76)), mirrorAngles(triple(88))];
  return {
    name: decodeName(records.bytes(at, 20)),
    bodies,
    position: mirrorPoint(triple(28)),
    rotation: mirrorAngles(triple(40)),
    // Mirroring swaps lower and upper bounds.
    positionMin: [positionMin[0], positionMin[1], positionMax[2]],
    positionMax: [positionMax[0], positionMax[1], positionMin[2]],
    rotationMin: [rotationMax[0], rotationMax[1], rotationMin[2]],
    rotationMax: [rotationMin[0], rotationMin[1], rotationMax[2]],
    positionSpring: triple(100),
    rotationSpring: triple(112),
  };
}

function tripleReader(records: BinaryRecord, start: number, number: ReadNumber) {
  return (at: number): Numbers3 => [
    number(records, start + at),
    number(records, start + at + 4),
    number(records, start + at + 8),
  ];
}
