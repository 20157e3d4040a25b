import { type mat4, vec3 } from 'gl-matrix';
import type { Camera } from '../../document/camera.ts';
import type { Evaluation } from '../../evaluation/evaluation.ts';
import { ownerOf } from '../../posing/pick-skin.ts';
import { axesOf, eyeOf } from '../camera.ts';
import type { Geometry } from './geometry.ts';

/** The point of a character's surface that a pixel shows. */
export interface SeenPoint {
  /** The index of the character among those that are shown. */
  readonly character: number;
  readonly triangle: number;
  /** The joint that owns the skin there, or null if none does. */
  readonly joint: number | null;
  /** The distance from the camera along its line of sight, in scene units. */
  readonly depth: number;
  /** The unit normal in camera space: x to the right, y up, z to the viewer. */
  readonly normal: vec3;
}

/** Beyond this, a normal that points away from the viewer is that of an inner side. */
const innerSide = -0.3;

/** Reads points of surfaces from the geometry of a picture. Its result is overwritten by the next. */
export class SurfaceReader {
  private readonly shown: readonly Evaluation[];
  private readonly camera: Camera;
  private readonly axes: ReturnType<typeof axesOf>;
  private readonly eye: vec3;
  private readonly floats = new Float32Array(2);
  private readonly bits = new Uint32Array(this.floats.buffer);
  private readonly weights = [0, 0, 0];
  private readonly position: vec3 = new Float64Array(3);
  private readonly view: vec3 = new Float64Array(3);
  private readonly point = {
    ...{ character: 0, triangle: 0, depth: 0 },
    joint: null as number | null,
    normal: new Float64Array(3) as vec3,
  };

  constructor(shown: readonly Evaluation[], camera: Camera) {
    this.shown = shown;
    this.camera = camera;
    this.axes = axesOf(camera);
    this.eye = eyeOf(camera);
  }

  /** @param at where the pixel begins in the geometry */
  at(geometry: Geometry, at: number): SeenPoint | null {
    const { point, bits, floats, weights, position, camera, view } = this;
    const character = geometry[at]! - 1;
    if (character < 0) return null;
    const evaluation = this.shown[character]!;
    const { mesh } = evaluation.state.character;
    const triangle = geometry[at + 1]!;
    bits[0] = geometry[at + 2]!;
    bits[1] = geometry[at + 3]!;
    weights[0] = 1 - floats[0]! - floats[1]!;
    weights[1] = floats[0]!;
    weights[2] = floats[1]!;
    point.character = character;
    point.triangle = triangle;
    point.joint = ownerOf(mesh, evaluation.skin, triangle, weights);
    const { positions, normals } = evaluation.vertices();
    const matrix: mat4 = evaluation.display.sceneFromCharacter;
    this.blend(position, positions, mesh.indices, triangle);
    vec3.transformMat4(position, position, matrix);
    const { right, up, look } = this.axes;
    vec3.subtract(view, position, camera.target);
    point.depth = vec3.dot(view, look) + camera.distance;
    vec3.normalize(view, vec3.subtract(view, this.eye, position));
    const isFaceted = evaluation.state.look.shading === 'faceted';
    if (isFaceted) faceNormal(point.normal, positions, mesh.indices, triangle);
    else this.blend(point.normal, normals, mesh.indices, triangle);
    turn(point.normal, matrix);
    // Faces have no side of their own; a smooth normal is that of the outer side.
    if (vec3.dot(point.normal, view) < (isFaceted ? 0 : innerSide)) {
      vec3.scale(point.normal, point.normal, -1);
    }
    const { normal } = point;
    vec3.set(normal, vec3.dot(normal, right), vec3.dot(normal, up), -vec3.dot(normal, look));
    return point;
  }

  /** Blends the values of a triangle's corners. */
  private blend(out: vec3, values: Float32Array, indices: Uint32Array, triangle: number): void {
    vec3.set(out, 0, 0, 0);
    for (let corner = 0; corner < 3; corner++) {
      const vertex = indices[triangle * 3 + corner]! * 3;
      const weight = this.weights[corner]!;
      for (let i = 0; i < 3; i++) out[i] = out[i]! + weight * values[vertex + i]!;
    }
  }
}

function faceNormal(
  out: vec3,
  positions: Float32Array,
  indices: Uint32Array,
  triangle: number,
): void {
  const corner = (index: number): vec3 => {
    const at = indices[triangle * 3 + index]! * 3;
    return [positions[at]!, positions[at + 1]!, positions[at + 2]!];
  };
  const first = corner(0);
  const [a, b] = [1, 2].map((index) => vec3.subtract(new Float64Array(3), corner(index), first));
  vec3.cross(out, a!, b!);
}

/** Turns a direction by a matrix that scales uniformly, and gives it unit length. */
function turn(out: vec3, m: mat4): void {
  const [x, y, z] = [out[0], out[1], out[2]];
  vec3.set(
    out,
    m[0] * x + m[4] * y + m[8] * z,
    m[1] * x + m[5] * y + m[9] * z,
    m[2] * x + m[6] * y + m[10] * z,
  );
  vec3.normalize(out, out);
}
