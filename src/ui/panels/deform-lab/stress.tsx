import '../../styles/stress.css';
import { mostMethods } from '../../../document/comparison.ts';
import { menuName, methods } from '../../../skinning/registry.ts';
import { fewestMethods, stressLabOf } from '../../deform-lab/stress-lab.ts';
import type { Editor } from '../../editor.ts';
import { CommandButton } from '../command-button.tsx';
import { NumberRow } from '../setting-rows.tsx';
import { Measuring } from './measuring.tsx';

/** How many poses may get pictures. */
const counts = [6, 12, 24, 48];

/** How far joints may be set to turn, in degrees. */
const turns = { min: 1, max: 180, step: 'any' } as const;

/** What the stress suite is to measure and draw; its table is below the view. */
export function Stress({ editor }: { readonly editor: Editor }) {
  const lab = stressLabOf(editor);
  const [chosen, base, progress] = [lab.chosen.value, lab.base.value, lab.progress.value];
  return (
    <>
      <p class="hint">
        Turns each joint that deforms the skin to the ends of its range, one at a time, and compares
        methods there.
      </p>
      <fieldset class="methods">
        <legend>
          Methods, {fewestMethods} to {mostMethods}
        </legend>
        {methods.map((method) => {
          const isChosen = chosen.includes(method.id);
          const count = chosen.length + (isChosen ? -1 : 1);
          return (
            <label key={method.id}>
              <input
                type="checkbox"
                checked={isChosen}
                disabled={count < fewestMethods || count > mostMethods}
                onChange={() => lab.toggleMethod(method.id)}
              />
              {menuName(method)}
            </label>
          );
        })}
      </fieldset>
      <div class="choices">
        <label>
          <span>Differences from</span>
          <select
            value={base}
            onChange={({ currentTarget }) => lab.chooseBase(chosen[currentTarget.selectedIndex]!)}
          >
            {chosen.map((id) => (
              <option key={id} value={id}>
                {methods.find((method) => method.id === id)!.label}
              </option>
            ))}
          </select>
        </label>
        <label>
          <span>Joints turn from</span>
          <select
            value={lab.fromShown.value ? 'shown' : 'rest'}
            onChange={({ currentTarget }) =>
              (lab.fromShown.value = currentTarget.value === 'shown')
            }
          >
            <option value="rest">the file’s pose</option>
            <option value="shown">the pose that is shown</option>
          </select>
        </label>
        <NumberRow
          {...{ label: 'Bends up to', unit: '°', ...turns }}
          value={lab.bend.value}
          onChange={(value) => (lab.bend.value = value)}
        />
        <NumberRow
          {...{ label: 'Twists up to', unit: '°', ...turns }}
          value={lab.twist.value}
          onChange={(value) => (lab.twist.value = value)}
        />
        <label>
          <span>Pictures of</span>
          <select
            value={lab.pictureCount.value}
            onChange={({ currentTarget }) => (lab.pictureCount.value = Number(currentTarget.value))}
          >
            {counts.map((count) => (
              <option key={count} value={count}>
                the {count} worst poses
              </option>
            ))}
          </select>
        </label>
      </div>
      {progress ? (
        <Measuring progress={progress} cancel={() => lab.cancel()} />
      ) : (
        <div class="buttons">
          <CommandButton editor={editor} command="stress-suite" />
        </div>
      )}
      <p class="hint">
        Hinges with limits turn to these. Other joints bend about two axes across the bone and twist
        about it, each way as far as is set; the joints of a body no farther than such joints do.
      </p>
    </>
  );
}
