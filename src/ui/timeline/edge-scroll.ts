/** How near to an edge a drag scrolls, and how far beyond it the speed no more grows, in CSS pixels. */
const [nearEdge, farthest] = [14, 120];
/** How many times its distance a drag scrolls in a second. */
const pace = 6;

/**
 * How fast a drag scrolls at a place of a view, in CSS pixels a second: 0 inside of it, less than 0
 * at its beginning, more at its end, and faster the farther the pointer goes.
 */
export function edgeSpeed(place: number, length: number): number {
  const before = nearEdge - place;
  const after = place - (length - nearEdge);
  if (before > 0 && before >= after) return -pace * Math.min(before, farthest);
  return after > 0 ? pace * Math.min(after, farthest) : 0;
}

/** What a drag that goes on at an edge of a view does. */
interface EdgeScrolled {
  /** The view's present size, in CSS pixels. */
  size(): { readonly width: number; readonly height: number };
  /** Shows what lies so many CSS pixels to the right and below. */
  scroll(across: number, down: number): void;
  /** Repeats the drag with the pointer where it was last. */
  again(): void;
}

/** Scrolls a view while a drag holds the pointer at one of its edges. */
export class EdgeScroll {
  private readonly view: EdgeScrolled;
  private frame = 0;
  private last = 0;
  private x = 0;
  private y = 0;

  constructor(view: EdgeScrolled) {
    this.view = view;
  }

  /** Tells where the pointer is, in CSS pixels from the view's upper left corner. */
  moveTo(x: number, y: number): void {
    [this.x, this.y] = [x, y];
    if (this.frame !== 0 || !this.isAtEdge) return;
    this.last = performance.now();
    this.frame = requestAnimationFrame(this.step);
  }

  end(): void {
    cancelAnimationFrame(this.frame);
    this.frame = 0;
  }

  private get speeds(): readonly [number, number] {
    const { width, height } = this.view.size();
    return [edgeSpeed(this.x, width), edgeSpeed(this.y, height)];
  }

  private get isAtEdge(): boolean {
    return this.speeds.some((speed) => speed !== 0);
  }

  private readonly step = (now: number): void => {
    this.frame = 0;
    if (!this.isAtEdge) return;
    // A page that was hidden for a while does not scroll far at once.
    const seconds = Math.min(Math.max(0, now - this.last) / 1000, 0.05);
    this.last = now;
    const [across, down] = this.speeds;
    this.view.scroll(across * seconds, down * seconds);
    this.frame = requestAnimationFrame(this.step);
    this.view.again();
  };
}
