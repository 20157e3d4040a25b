/** The σ of the paper: how far two ratios of weights may be apart and still count as alike. */
const sigma = 0.1;

/** The grid divides weights from 0 to 1 into this many steps. */
const gridSteps = 64;
const nodesPerSide = gridSteps + 1;

/** Numbers per piece of surface: both weights, the mass, and the moment x, y, z. */
const pieceSize = 6;
/** Numbers per node of the grid: the mass, and the moment x, y, z. */
const nodeSize = 4;

/** What sums over the surface give: mass, and moments, which are mass × place. */
export type Sums = [mass: number, x: number, y: number, z: number];

/**
 * The pieces of a surface that follow two joints, with the weights of both. As the similarity of
 * two places depends on only these two weights (for this pair of joints), many pieces can be
 * clustered: they are divided among the four nearest nodes of a grid over the two weights, which
 * interpolates the similarity linearly. So a sum costs no more than a pass over that grid, however
 * many triangles there are.
 */
export class SharedSurface {
  /** Above this many pieces they are clustered. */
  private readonly limit: number;
  private pieces: number[] = [];
  private grid: Float64Array | null = null;
  private packed: Float64Array | null = null;

  constructor(limit: number) {
    this.limit = limit;
  }

  /** Adds a piece with its area and its centroid. */
  add(first: number, second: number, area: number, centroid: readonly number[]): void {
    const mass = area * first * second;
    const [x, y, z] = centroid.map((value) => value * mass) as [number, number, number];
    if (this.grid) addToGrid(this.grid, first, second, mass, x, y, z);
    else this.pieces.push(first, second, mass, x, y, z);
    if (this.pieces.length > this.limit * pieceSize) this.cluster();
  }

  /**
   * Adds to `sums` what this pair of joints contributes to a place with these two weights: the term
   * of the similarity s (equation 1 of the paper) for each piece, times its area.
   */
  addTo(sums: Sums, first: number, second: number): void {
    const pieces = (this.packed ??= this.pack());
    let [mass, x, y, z] = [0, 0, 0, 0];
    for (let at = 0; at < pieces.length; at += pieceSize) {
      const apart = first * pieces[at + 1]! - second * pieces[at]!;
      const alike = Math.exp((apart * apart) / (-sigma * sigma));
      mass += alike * pieces[at + 2]!;
      x += alike * pieces[at + 3]!;
      y += alike * pieces[at + 4]!;
      z += alike * pieces[at + 5]!;
    }
    const scale = first * second;
    sums[0] += scale * mass;
    sums[1] += scale * x;
    sums[2] += scale * y;
    sums[3] += scale * z;
  }

  private cluster(): void {
    const { pieces } = this;
    const grid = new Float64Array(nodesPerSide * nodesPerSide * nodeSize);
    for (let at = 0; at < pieces.length; at += pieceSize) {
      const [first, second, mass, x, y, z] = pieces.slice(at, at + pieceSize);
      addToGrid(grid, first!, second!, mass!, x!, y!, z!);
    }
    this.grid = grid;
    this.pieces = [];
  }

  /** The pieces, or else the nodes of the grid that have any mass, each as a piece. */
  private pack(): Float64Array {
    const { grid } = this;
    if (!grid) return Float64Array.from(this.pieces);
    const packed: number[] = [];
    for (let at = 0; at < grid.length; at += nodeSize) {
      if (grid[at] === 0) continue;
      const node = at / nodeSize;
      packed.push(Math.floor(node / nodesPerSide) / gridSteps, (node % nodesPerSide) / gridSteps);
      packed.push(...grid.subarray(at, at + nodeSize));
    }
    return Float64Array.from(packed);
  }
}

function addToGrid(
  grid: Float64Array,
  first: number,
  second: number,
  mass: number,
  x: number,
  y: number,
  z: number,
): void {
  const row = cellOf(first);
  const column = cellOf(second);
  const down = first * gridSteps - row;
  const along = second * gridSteps - column;
  for (let corner = 0; corner < 4; corner++) {
    const [below, beside] = [corner >> 1, corner & 1];
    const part = (below ? down : 1 - down) * (beside ? along : 1 - along);
    const at = ((row + below) * nodesPerSide + column + beside) * nodeSize;
    grid[at]! += part * mass;
    grid[at + 1]! += part * x;
    grid[at + 2]! += part * y;
    grid[at + 3]! += part * z;
  }
}

/** Weights above 1, which rows of a file may have, are extrapolated from the last cell. */
function cellOf(weight: number): number {
  return Math.min(gridSteps - 1, Math.floor(weight * gridSteps));
}
