import type { BinaryWriter } from '../binary/binary-writer.ts';
import { encodeName } from './encode-name.ts';
import { mirrorAngles, mirrorPoint } from './mirror.ts';
import { type BodyJoint, bodyShapes, type MmdPhysics, type RigidBody } from './mmd-parts.ts';

const noBone = 0xffff;

/** Writes rigid bodies and the joints between them. */
export function writePhysics(out: BinaryWriter, { bodies, joints }: MmdPhysics): void {
  out.u32(bodies.length);
  for (const body of bodies) writeBody(out, body);
  out.u32(joints.length);
  for (const joint of joints) writeJoint(out, joint);
}

function writeBody(out: BinaryWriter, body: RigidBody): void {
  out.bytes(encodeName(body.name, 20));
  out.u16(body.bone === -1 ? noBone : body.bone);
  out.u8(body.group);
  out.u16(body.mask);
  out.u8(bodyShapes.indexOf(body.shape));
  out.f32(...body.size, ...mirrorPoint(body.position), ...mirrorAngles(body.rotation));
  out.f32(body.mass, body.linearDamping, body.angularDamping, body.restitution, body.friction);
  out.u8(body.mode);
}

function writeJoint(out: BinaryWriter, joint: BodyJoint): void {
  const { positionMin, positionMax, rotationMin, rotationMax } = joint;
  out.bytes(encodeName(joint.name, 20));
  out.u32(...joint.bodies);
  out.f32(...mirrorPoint(joint.position), ...mirrorAngles(joint.rotation));
  // Mirroring swaps lower and upper bounds.
  out.f32(...mirrorPoint([positionMin[0], positionMin[1], positionMax[2]]));
  out.f32(...mirrorPoint([positionMax[0], positionMax[1], positionMin[2]]));
  out.f32(...mirrorAngles([rotationMax[0], rotationMax[1], rotationMin[2]]));
  out.f32(...mirrorAngles([rotationMin[0], rotationMin[1], rotationMax[2]]));
  out.f32(...joint.positionSpring, ...joint.rotationSpring);
}
