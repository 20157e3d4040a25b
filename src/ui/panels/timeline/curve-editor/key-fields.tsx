import { useEffect, useRef } from 'preact/hooks';
import { type CurveModel } from '../../../curve-editor/curve-model.ts';
import { keyCount, slopeText } from '../../../curve-editor/drag-texts.ts';
import { besideText, exactText, tangentText, unitNames } from '../../../curve-editor/key-text.ts';
import {
  type TypedKeys,
  typedKeysOf,
  typeTangent,
  typeTime,
  typeValue,
} from '../../../curve-editor/typed-keys.ts';
import type { Editor } from '../../../editor.ts';
import { TypedField } from './typed-field.tsx';

interface KeyFieldsProperties {
  readonly editor: Editor;
  readonly model: CurveModel;
}

/** The numbers of the selected keys, where a key was clicked. */
export function KeyFields({ editor, model }: KeyFieldsProperties) {
  const panel = useRef<HTMLDivElement>(null);
  const place = model.fieldsAt.value;
  const keys = place && typedKeysOf(editor);
  useEffect(() => {
    const element = panel.current;
    if (!element || !place) return;
    const { clientWidth, clientHeight } = element.offsetParent ?? element;
    // Beside the key, on the side that has more room, and within the plot.
    const isRight = place.x < clientWidth / 2;
    const left = isRight ? place.x + 16 : place.x - 16 - element.offsetWidth;
    const top = place.y - element.offsetHeight / 2;
    element.style.left = `${within(left, clientWidth - element.offsetWidth)}px`;
    element.style.top = `${within(top, clientHeight - element.offsetHeight)}px`;
  }, [place, keys === null]);
  if (!keys) return null;
  const close = (): void => void (model.fieldsAt.value = null);
  return (
    <div
      ref={panel}
      class="key-fields"
      role="group"
      aria-label="Numbers of the selected keys"
      onKeyDown={(event) => {
        if (event.key !== 'Escape') return;
        event.stopPropagation();
        close();
      }}
    >
      <strong>
        {keyCount(keys.count)}
        {keys.count > 1 && <small> each gets what is typed</small>}
      </strong>
      <button type="button" class="sign" aria-label="Close the numbers" onClick={close}>
        ×
      </button>
      <Fields editor={editor} keys={keys} />
    </div>
  );
}

/** Two rows of fields, each a name, a field, and what stands beside it. */
function Fields({ editor, keys }: { readonly editor: Editor; readonly keys: TypedKeys }) {
  const { time, value, unit, hasValues, tangents, slopes } = keys;
  const tangentField = (side: 'in' | 'out') => (
    <FieldOfTangent
      side={side}
      text={tangents[side] === null ? '' : tangentText(tangents[side])}
      beside={slopes ? slopeText(slopes[side], unit) : ''}
      onType={(text) => typeTangent(editor, side, text, unit)}
    />
  );
  return (
    <>
      <i>Time</i>
      <TypedField
        label="Time of the keys in seconds"
        value={time === null ? '' : exactText(time)}
        placeholder="several"
        onType={(text) => typeTime(editor, text)}
      />
      <span>s</span>
      {hasValues && (
        <>
          {tangentField('in')}
          <i>Value</i>
          <TypedField
            label="Value of the keys"
            value={value === null ? '' : exactText(value)}
            placeholder="+= *="
            onType={(text) => typeValue(editor, text, unit)}
          />
          <span>{value === null ? '' : besideText(value, unit) || unitNames[unit]}</span>
          {tangentField('out')}
        </>
      )}
    </>
  );
}

interface TangentProperties {
  readonly side: 'in' | 'out';
  readonly text: string;
  readonly beside: string;
  readonly onType: (text: string) => boolean;
}

function FieldOfTangent({ side, text, beside, onType }: TangentProperties) {
  return (
    <>
      <i>{side === 'in' ? 'In' : 'Out'}</i>
      <TypedField
        label={`Tangent ${side === 'in' ? 'into' : 'out of'} the keys`}
        value={text}
        placeholder="several"
        onType={onType}
      />
      <span>{beside}</span>
    </>
  );
}

function within(place: number, most: number): number {
  return Math.max(0, Math.min(place, most));
}
