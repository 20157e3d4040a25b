import { mat3 } from 'gl-matrix';
import { jointMatrices } from '../../core/forward-kinematics.ts';
import { applyRest } from '../../core/joint-transforms.ts';
import { noParent, type Skeleton } from '../../core/skeleton.ts';

/** An entry this near to a whole number is that number, so that signs alone change where they can. */
const whole = 1e-9;

/**
 * Returns the rotation that takes rotation vectors in the frame of one joint to those of the mirrored
 * rotations in the frame of another one; its negative takes offsets. The frames are those in which
 * the joints' own degrees of freedom move, with all joints above in the reference pose.
 *
 * A reflection S takes the rotation about a by θ to that about S a by -θ. With the frames F and F′ it
 * is therefore -F′ᵀ S F.
 *
 * @param reference (qCount)
 */
export function mirrorFrames(
  skeleton: Skeleton,
  reference: Float64Array,
): (from: number, to: number) => mat3 {
  const matrices = jointMatrices(skeleton, reference);
  const frameOf = (joint: number): mat3 => {
    const parent = skeleton.parents[joint]!;
    const frame = new Float64Array(16);
    if (parent === noParent) frame.set([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);
    else frame.set(matrices.subarray(parent * 16, parent * 16 + 16));
    applyRest(skeleton, joint, frame);
    return mat3.fromMat4(new Float64Array(9), frame);
  };
  return (from, to) => {
    // -S leaves x and turns the two others around.
    const mirrored = Float64Array.from(frameOf(from) as Float64Array, (value, i) =>
      i % 3 === 0 ? value : -value,
    );
    const back = mat3.transpose(new Float64Array(9), frameOf(to));
    const product = mat3.multiply(new Float64Array(9), back, mirrored);
    return Float64Array.from(product as Float64Array, (value) => {
      const nearest = Math.round(value) + 0;
      return Math.abs(value - nearest) < whole ? nearest : value;
    });
  };
}
