import type { growFloat32, growUint16, growUint32 } from '../text/growable.ts';
import type { PlainNumbers } from '../text/plain-numbers.ts';

/** Rows of more influences are left to the careful reader; these fit the bits of `unwhole`. */
const mostInfluences = 15;
/** The bits of the joints, which take turns with their weights. */
const jointBits = 0x55555555;

/** The growing rows of weights: their ends, lines, joints and weights. */
interface WeightRows {
  readonly start: ReturnType<typeof growUint32>;
  readonly lines: ReturnType<typeof growUint32>;
  readonly joints: ReturnType<typeof growUint16>;
  readonly weights: ReturnType<typeof growFloat32>;
}

/** Reads the plain rows of `skinweights`, which are nearly all rows of most files. */
export class PlainWeights {
  private readonly influenceCount = new Int32Array(1);
  /** Joint, weight, joint, weight, … */
  private readonly influences = new Float64Array(mostInfluences * 2);
  private readonly mostJoints: number;
  private readonly largest: number;
  private readonly rows: WeightRows;

  constructor(mostJoints: number, largest: number, rows: WeightRows) {
    this.mostJoints = mostJoints;
    this.largest = largest;
    this.rows = rows;
  }

  /**
   * Reads `k joint weight …`. Returns false, without effect, if something else comes, if a number is
   * too large, or if a joint occurs twice.
   */
  readRow(numbers: PlainNumbers): boolean {
    const { influenceCount, influences } = this;
    numbers.skipBlanks();
    const { at, line } = numbers;
    if (numbers.indices(influenceCount, 1) === 1) {
      const count = influenceCount[0]!;
      const isPlain =
        count <= Math.min(mostInfluences, this.mostJoints) &&
        numbers.numbers(influences, count * 2) === count * 2 &&
        (numbers.unwhole & jointBits) === 0;
      if (isPlain && this.add(count)) {
        this.rows.start.push(this.rows.weights.length);
        this.rows.lines.push(line);
        return true;
      }
    }
    numbers.at = at;
    numbers.line = line;
    return false;
  }

  private add(count: number): boolean {
    const { influences, mostJoints, largest } = this;
    const { joints, weights } = this.rows;
    const [ofJoints, ofWeights] = [joints.reserve(count), weights.reserve(count)];
    const first = joints.length;
    for (let i = 0; i < count; i++) {
      const joint = influences[i * 2]!;
      const weight = influences[i * 2 + 1]!;
      if (!(joint >= 0 && joint < mostJoints && weight <= largest && weight >= -largest))
        return false;
      for (let other = first; other < first + i; other++) {
        if (ofJoints[other] === joint) return false;
      }
      ofJoints[first + i] = joint;
      ofWeights[first + i] = weight;
    }
    joints.length = first + count;
    weights.length = first + count;
    return true;
  }
}
