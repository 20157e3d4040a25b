import { readFileSync } from 'node:fs';
import { type Parsed, printable } from '../core/diagnostics.ts';
import type { IkSolution, IkSolver } from '../posing/ik/problem.ts';
import { existingPath } from './existing-path.ts';
import { printDiagnostics, unreadable, userPath } from './files.ts';
import { type IkProblemFile, type IkProblemsFile, readIkProblems } from './ik-problem-json.ts';

/** Solves every problem of a file and prints the answers, a list if the file has a list. */
export function solveProblems(
  [path]: readonly string[],
  solver: IkSolver,
  asJson: boolean,
): number {
  const { value, diagnostics } = readProblems(path!);
  printDiagnostics(diagnostics);
  if (!value) return 1;
  const answers = value.problems.map((each) => answerOf(each, solver.solve(each.problem)));
  if (asJson) console.log(JSON.stringify(value.isList ? answers : answers[0], null, 2));
  else answers.forEach((answer, index) => console.log(lineOf(answer, value.problems[index]!)));
  return 0;
}

function readProblems(path: string): Parsed<IkProblemsFile> {
  try {
    return readIkProblems(path, readFileSync(existingPath(userPath(path)), 'utf8'));
  } catch (error) {
    return { diagnostics: [unreadable(path, error)] };
  }
}

/** The answer in the form that is printed: angles in the order of the problem's dofs. */
function answerOf({ values }: IkProblemFile, { q, residuals, iterations, status }: IkSolution) {
  return { angles: values.map((value) => q[value]!), residuals, iterations, status };
}

function lineOf(
  { residuals, iterations, status }: ReturnType<typeof answerOf>,
  { name }: IkProblemFile,
): string {
  const distances = residuals.map((residual) => residual.toExponential(2)).join(', ');
  const what = name === null ? '' : `${printable(name)}: `;
  return `${what}${status}, residual ${distances}, ${iterations} iterations`;
}
