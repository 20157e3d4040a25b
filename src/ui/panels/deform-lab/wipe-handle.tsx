import { withWipe } from '../../../document/comparison.ts';
import { comparedOf } from '../../deform-lab/compared.ts';
import type { Looking } from '../../editor.ts';

interface WipeHandleProperties {
  readonly editor: Looking;
  readonly index: number;
}

/** How far an arrow key moves a wipe, and with Shift, as parts of the view's width. */
const [keyStep, fineStep] = [0.02, 0.002];

/** The line between two methods, which is dragged or moved by arrow keys. */
export function WipeHandle({ editor, index }: WipeHandleProperties) {
  const { session } = editor;
  const comparison = session.comparison.value!;
  const place = comparison.wipes[index]!;
  const [left, right] = (comparedOf(editor)?.rows ?? [])
    .slice(index, index + 2)
    .map(({ kernel }) => kernel.label);
  const moveTo = (wanted: number): void => {
    const now = session.comparison.peek();
    if (now) session.comparison.value = withWipe(now, index, wanted);
  };
  const onKeyDown = (event: KeyboardEvent): void => {
    const step = event.shiftKey ? fineStep : keyStep;
    const goals: Readonly<Record<string, number>> = {
      ArrowLeft: place - step,
      ArrowDown: place - step,
      ArrowRight: place + step,
      ArrowUp: place + step,
      Home: 0,
      End: 1,
    };
    const goal = goals[event.key];
    if (goal === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    moveTo(goal);
  };
  return (
    <div
      class="wipe"
      style={{ left: `${place * 100}%` }}
      onPointerDown={(event) => dragWipe(event, moveTo)}
    >
      <div
        class="grip"
        role="slider"
        tabIndex={0}
        aria-label={`Wipe between ${left} and ${right}`}
        aria-orientation="horizontal"
        aria-valuemin={0}
        aria-valuemax={100}
        aria-valuenow={Math.round(place * 100)}
        aria-valuetext={`${Math.round(place * 100)} % from the left`}
        onKeyDown={onKeyDown}
      />
    </div>
  );
}

/** The wipe keeps its distance from the pointer. */
function dragWipe(event: PointerEvent, moveTo: (place: number) => void): void {
  if (event.button !== 0) return;
  const handle = event.currentTarget as HTMLElement;
  const view = handle.parentElement!.getBoundingClientRect();
  const box = handle.getBoundingClientRect();
  const held = event.clientX - (box.left + box.width / 2);
  handle.setPointerCapture(event.pointerId);
  handle.querySelector<HTMLElement>('.grip')?.focus({ preventScroll: true });
  event.preventDefault();
  const move = ({ clientX }: PointerEvent): void =>
    moveTo((clientX - held - view.left) / view.width);
  handle.addEventListener('pointermove', move);
  handle.addEventListener(
    'lostpointercapture',
    () => handle.removeEventListener('pointermove', move),
    { once: true },
  );
}
