import '../styles/movie.css';
import { useEffect, useState } from 'preact/hooks';
import type {
  MovieFormatId,
  MovieRangeId,
  MovieSettings,
  MovieSizeId,
} from '../../view/movie/movie-settings.ts';
import { usualRates } from '../../view/movie/movie-settings.ts';
import { attempt } from '../attempt.ts';
import type { Editor, MovieChoice } from '../editor.ts';
import { moviePlan, movieSituation } from '../movie-request.ts';
import { movieText } from '../movie-text.ts';
import { NumberRow, SelectRow, TickRow } from './setting-rows.tsx';

const sizes: Readonly<Record<MovieSizeId, string>> = {
  view: 'As the view',
  '360p': '640 × 360',
  '720p': '1280 × 720',
  '1080p': '1920 × 1080',
  '4k': '3840 × 2160',
  square: '1080 × 1080',
  free: 'Width × height',
};
const samples: Readonly<Record<string, string>> = {
  1: 'As the view',
  2: '2 × 2',
  3: '3 × 3',
  4: '4 × 4',
};

/** Asks how a movie is to be saved, and begins it. */
export function MovieDialog({ editor }: { readonly editor: Editor }) {
  const settings = editor.movie.value;
  const set = (changed: Partial<MovieSettings>): void => {
    editor.movie.value = { ...editor.movie.value, ...changed };
  };
  const situation = movieSituation(editor);
  const plan = moviePlan(editor);
  const choices = useChoices(editor, JSON.stringify(plan));
  const chosen = choices.find(({ id }) => id === settings.format);
  const ranges: Record<string, string> = {
    ...(situation.clip && { clip: 'The clip' }),
    ...(situation.workRange && { work: 'The work range' }),
    typed: 'From … to …',
  };
  const range = settings.range in ranges ? settings.range : Object.keys(ranges)[0]!;
  const hasClip = situation.clip !== null;
  const choose = (format: MovieFormatId): void => {
    // A GIF of the usual size of videos would be very large; a size of the user's choice stays.
    const isUsual = settings.size === '720p';
    set({ format, ...(format === 'gif' && isUsual && { size: '360p' }) });
  };
  const save = (event: Event): void => {
    event.preventDefault();
    editor.dialog.value = null;
    attempt(editor, editor.saveMovie());
  };
  return (
    <form class="movie" onSubmit={save}>
      <Formats choices={choices} chosen={settings.format} onChange={choose} />
      <div class="rows">
        <SelectRow
          label="Size"
          value={settings.size}
          options={sizes}
          onChange={(size) => set({ size: size as MovieSizeId })}
        />
        {settings.size === 'free' && (
          <>
            <NumberRow
              label="Width"
              unit="pixels"
              {...{ value: settings.width, min: 16, max: 16_384, step: 1 }}
              onChange={(width) => set({ width })}
            />
            <NumberRow
              label="Height"
              unit="pixels"
              {...{ value: settings.height, min: 16, max: 16_384, step: 1 }}
              onChange={(height) => set({ height })}
            />
          </>
        )}
        <NumberRow
          label="Rate"
          unit="frames a second"
          {...{ value: settings.rate, min: 1, max: 240, step: 'any', usual: usualRates }}
          onChange={(rate) => set({ rate })}
        />
        <TickRow
          label="The clip plays"
          isOn={settings.plays && hasClip}
          isEnabled={hasClip}
          onChange={(plays) => set({ plays })}
        />
        <TickRow
          label="The camera turns once around"
          isOn={settings.turns}
          onChange={(turns) => set({ turns })}
        />
        {settings.turns && (
          <NumberRow
            label="Turn"
            unit="seconds"
            {...{ value: settings.turnSeconds, min: 0.1, max: 600, step: 'any' }}
            onChange={(turnSeconds) => set({ turnSeconds })}
          />
        )}
        {!settings.turns && (
          <SelectRow
            label="Range"
            value={range}
            options={ranges}
            onChange={(value) => set({ range: value as MovieRangeId })}
          />
        )}
        {!settings.turns && range === 'typed' && (
          <>
            <NumberRow
              label="From"
              unit="seconds"
              {...{ value: settings.from, min: -3600, max: 3600, step: 'any' }}
              onChange={(from) => set({ from })}
            />
            <NumberRow
              label="To"
              unit="seconds"
              {...{ value: settings.to, min: -3600, max: 3600, step: 'any' }}
              onChange={(to) => set({ to })}
            />
          </>
        )}
        <SelectRow
          label="Samples a pixel"
          value={String(settings.samples)}
          options={samples}
          onChange={(value) => set({ samples: Number(value) })}
        />
        <TickRow
          label="Background"
          isOn={settings.background || chosen?.isTransparent === false}
          isEnabled={chosen?.isTransparent !== false}
          onChange={(background) => set({ background })}
        />
      </div>
      <output>{movieText(plan, chosen?.bytes)}</output>
      <div class="buttons">
        <button type="submit" class="primary" disabled={!chosen || chosen.whyNot !== null}>
          Save
        </button>
      </div>
    </form>
  );
}

interface FormatsProperties {
  readonly choices: readonly MovieChoice[];
  readonly chosen: MovieFormatId;
  readonly onChange: (id: MovieFormatId) => void;
}

/** What can't be saved here is shown with the reason. */
function Formats({ choices, chosen, onChange }: FormatsProperties) {
  return (
    <fieldset>
      <legend>Format</legend>
      {choices.map(({ id, label, whyNot }) => (
        <label key={id}>
          <input
            type="radio"
            name="movie-format"
            value={id}
            checked={id === chosen}
            disabled={whyNot !== null}
            onChange={() => onChange(id)}
          />
          <span>{label}</span>
          {whyNot !== null && <small>{whyNot}</small>}
        </label>
      ))}
    </fieldset>
  );
}

/** The choices for the plan; those of the last plan until they are known. */
function useChoices(editor: Editor, plan: string): readonly MovieChoice[] {
  const [choices, setChoices] = useState<readonly MovieChoice[]>([]);
  useEffect(() => {
    let isWanted = true;
    attempt(
      editor,
      editor.movieChoices(moviePlan(editor)).then((found) => isWanted && setChoices(found)),
    );
    return () => {
      isWanted = false;
    };
  }, [editor, plan]);
  return choices;
}
