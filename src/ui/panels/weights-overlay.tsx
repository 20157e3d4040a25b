import '../styles/weights.css';
import { printable } from '../../core/diagnostics.ts';
import { influencesOf, noJoint } from '../../core/skin.ts';
import { byStrength } from '../../core/strongest-influences.ts';
import type { Evaluation } from '../../evaluation/evaluation.ts';
import { truncationOf } from '../../evaluation/truncation.ts';
import { jointColorsOf } from '../../skinning/weights/joint-colors.ts';
import { rowCount, rowSum, weightViews } from '../../skinning/weights/views.ts';
import { cssColor } from '../css-color.ts';
import type { Editor } from '../editor.ts';
import { type WeightLegend, weightLegends } from '../weight-legend.ts';
import { Icon } from './icon.tsx';

/** The influences that are listed at the pointer, and in the card of the marked vertex. */
const [fewRows, manyRows] = [8, 16];

/** Over the view while weights are shown: the legend, and the influences of one vertex or two. */
export function WeightsOverlay({ editor }: { readonly editor: Editor }) {
  const { showWeights, hoveredPoint, hoverPlace, markedPoint } = editor.session;
  const shown = editor.evaluations.selected();
  if (!showWeights.value || !shown) return null;
  const [hovered, place, marked] = [hoveredPoint.value, hoverPlace.value, markedPoint.value];
  return (
    <>
      <div class="weights-card">
        {marked !== null && (
          <section aria-label="Marked vertex" aria-live="polite">
            <button
              type="button"
              class="unmark"
              aria-label="Unmark the vertex"
              title="Unmark the vertex"
              onClick={() => (markedPoint.value = null)}
            >
              <Icon id="close" />
            </button>
            <Influences shown={shown} point={marked} most={manyRows} />
          </section>
        )}
        <Legend editor={editor} shown={shown} />
      </div>
      {hovered !== null && place && (
        <div class="weights-pointer" style={placeBeside(place)}>
          <Influences shown={shown} point={hovered} most={fewRows} />
        </div>
      )}
    </>
  );
}

/** Right below the pointer, as far as a table has room there. */
function placeBeside([x, y]: readonly [number, number]) {
  return { left: `min(${x + 14}px, 100% - 236px)`, top: `min(${y + 14}px, 100% - 230px)` };
}

interface InfluencesProperties {
  readonly shown: Evaluation;
  readonly point: number;
  readonly most: number;
}

/** The influences of a vertex, the largest first. */
function Influences({ shown: { skin, state }, point, most }: InfluencesProperties) {
  const { skeleton, mesh } = state.character;
  if (point >= mesh.pointCount) return null;
  const rows = byStrength(influencesOf(skin, point));
  const { bytes } = jointColorsOf(skeleton);
  const jointOf = (entry: number): number => skin.paletteJoint[entry]!;
  return (
    <table>
      <caption>Vertex #{point}</caption>
      <tbody>
        {rows.slice(0, most).map(({ entry, weight }, index) => {
          const joint = jointOf(entry);
          const isNone = joint === noJoint;
          const color = isNone ? 'transparent' : cssColor(bytes.subarray(joint * 3));
          return (
            <tr key={index}>
              <th scope="row">
                <span class="swatch" aria-hidden="true" style={{ background: color }} />
                {isNone ? 'no joint' : printable(skeleton.names[joint]!, 40)}
              </th>
              <td>{weight.toFixed(4)}</td>
            </tr>
          );
        })}
      </tbody>
      <tfoot>
        <tr>
          <th scope="row">
            {rowCount(skin, point)} influences
            {rows.length > most && `, ${rows.length - most} not shown`}
          </th>
          <td>Σ {rowSum(skin, point).toFixed(4)}</td>
        </tr>
      </tfoot>
    </table>
  );
}

interface LegendProperties {
  readonly editor: Editor;
  readonly shown: Evaluation;
}

function Legend({ editor: { session }, shown }: LegendProperties) {
  const view = session.weightView.value;
  const { swatches, scale, note } = legendOf(session, shown);
  return (
    <section class="weights-legend" aria-label="Legend of the weights">
      <h2>{weightViews.find(({ id }) => id === view)!.label}</h2>
      <p>{note}</p>
      {scale && (
        <>
          <div class="scale" aria-hidden="true" style={{ background: scale.gradient }} />
          <div class="ticks">
            {scale.texts.map((text) => (
              <span key={text}>{text}</span>
            ))}
          </div>
        </>
      )}
      {swatches.length > 0 && (
        <ul>
          {swatches.map(({ color, text }) => (
            <li key={text}>
              <span class="swatch" aria-hidden="true" style={{ background: color }} />
              {text}
            </li>
          ))}
        </ul>
      )}
    </section>
  );
}

function legendOf(session: Editor['session'], shown: Evaluation): WeightLegend {
  const { skeleton } = shown.state.character;
  const view = session.weightView.value;
  const joint =
    view === 'joint'
      ? (session.selectedJoint.value ?? session.hoveredLimb.value?.joint ?? null)
      : null;
  const truncation = view === 'error' ? truncationOf(shown) : null;
  return weightLegends[view]({
    skin: shown.skin,
    colors: jointColorsOf(skeleton),
    joint,
    jointName: joint === null ? null : printable(skeleton.names[joint] ?? '', 40),
    errors: truncation?.errors ?? null,
    largestError: truncation?.largest ?? 0,
    truncation,
  });
}
