import {
  type Diagnostic,
  formatDiagnostic,
  formatPlace,
  printable,
} from '../../core/diagnostics.ts';
import { attempt } from '../attempt.ts';
import { copyText } from '../copy-text.ts';
import type { Looking, Telling } from '../editor.ts';

/** Lists all problems of the last files, errors first. */
export function ProblemsPanel({ editor }: { readonly editor: Looking & Telling }) {
  const problems = editor.session.problems.value;
  const errors = problems.filter(({ severity }) => severity === 'error');
  const sorted = [...errors, ...problems.filter((problem) => !errors.includes(problem))];
  return (
    <section class="problems" aria-labelledby="problems-title">
      <h2 id="problems-title">Problems ({problems.length})</h2>
      <div role={errors.length > 0 ? 'alert' : 'status'}>
        <ol>
          {sorted.map((problem, index) => (
            <Problem key={index} problem={problem} />
          ))}
        </ol>
      </div>
      <div class="buttons">
        <button type="button" onClick={() => attempt(editor, copyReport(editor, sorted))}>
          Copy
        </button>
        <button type="button" onClick={() => (editor.session.problems.value = [])}>
          Dismiss
        </button>
      </div>
    </section>
  );
}

function Problem({ problem }: { readonly problem: Diagnostic }) {
  const { severity, source, expected, found, effect } = problem;
  return (
    <li class={severity}>
      <strong>{formatPlace(problem, 80)}</strong>
      {source !== undefined && source !== '' && <code>{printable(source, 120)}</code>}
      <dl>
        <dt>expected</dt>
        <dd>{printable(expected, 400)}</dd>
        <dt>found</dt>
        <dd>{printable(found)}</dd>
        <dt>so</dt>
        <dd>{effect}</dd>
      </dl>
    </li>
  );
}

async function copyReport(
  editor: Looking & Telling,
  problems: readonly Diagnostic[],
): Promise<void> {
  const lines = problems.map((problem) => {
    const { severity, code, effect } = problem;
    return `${severity}: ${formatDiagnostic(problem)}; ${effect} [${code}]`;
  });
  editor.notice.value = (await copyText(lines.join('\n')))
    ? 'Problems copied'
    : 'The browser did not let the text be copied';
}
