import type { MoviePlan } from '../view/movie/movie-plan.ts';
import { movieSeconds } from '../view/movie/movie-plan.ts';

/** What a movie will be, such as "60 frames, 2.00 s, 1280 × 720 pixels, about 1.4 MB". */
export function movieText(plan: MoviePlan, bytes: number | undefined): string {
  const { count, size, isTrimmed } = plan;
  const frames = `${count.toLocaleString('en')} ${count === 1 ? 'frame' : 'frames'}`;
  const about = bytes === undefined ? '' : `, about ${sizeText(bytes)}`;
  const trimmed = isTrimmed ? ' (video has even sides)' : '';
  return `${frames}, ${movieSeconds(plan).toFixed(2)} s, ${size.width} × ${size.height} pixels${trimmed}${about}`;
}

function sizeText(bytes: number): string {
  const units = ['KB', 'MB', 'GB'];
  let [amount, unit] = [bytes / 1e3, 0];
  for (; amount >= 1000 && unit < units.length - 1; unit++) amount /= 1000;
  return `${amount < 10 && unit > 0 ? amount.toFixed(1) : Math.max(1, Math.round(amount))} ${units[unit]}`;
}
