import type {
  DiagnosticArea,
  DiagnosticDetails,
  DiagnosticKind,
  DiagnosticLog,
  Place,
} from '../../core/diagnostics.ts';

/** A value and, where it was read from a text, how many code units stand before it and its key. */
export interface JsonNode {
  readonly value: unknown;
  readonly at?: number | undefined;
  readonly keyAt?: number | undefined;
  /** The values within it, by name or index. */
  readonly inner?: ReadonlyMap<string | number, JsonNode>;
}

/** What all values of a text share when they report. */
export interface JsonSource {
  readonly log: DiagnosticLog;
  readonly area: DiagnosticArea;
  /** What becomes of a value with an error. */
  readonly effect: string;
  /** The place of an offset of the text; scripts pass values that come from no text. */
  readonly placeOf?: (at: number) => Place;
}

/** A value of a JSON text, or one that a script passed: what is asked of it is checked and reported. */
export class JsonValue {
  readonly value: unknown;
  readonly source: JsonSource;
  private readonly node: JsonNode;
  private readonly path: string;

  constructor(node: JsonNode, source: JsonSource, path = '') {
    this.value = node.value;
    this.node = node;
    this.source = source;
    this.path = path;
  }

  /** The value of a name or index; one that is missing stands where this value does. */
  member(key: string | number): JsonValue {
    const { at, inner } = this.node;
    const value = (this.value as Record<string | number, unknown>)[key];
    const node = inner?.get(key) ?? { value, at };
    return new JsonValue(node, this.source, pathOf(this.path, key));
  }

  /** The values of an object by name. */
  record(expected: string): ReadonlyMap<string, JsonValue> | undefined {
    const { value } = this;
    if (typeof value === 'object' && value !== null && !Array.isArray(value)) {
      return new Map(Object.keys(value).map((key) => [key, this.member(key)]));
    }
    this.fail('json', expected);
    return undefined;
  }

  /** Finite numbers, as many as one of the counts; the place is that of the first that is none. */
  numbers(counts: readonly number[], expected: string): readonly number[] | undefined {
    const { value } = this;
    if (!Array.isArray(value) || !counts.includes(value.length)) {
      this.fail('json', expected);
      return undefined;
    }
    const wrong = value.findIndex((item) => !Number.isFinite(item));
    if (wrong < 0) return value as number[];
    this.member(wrong).fail('json', expected, display(value));
    return undefined;
  }

  text(expected: string): string | undefined {
    if (typeof this.value === 'string') return this.value;
    this.fail('json', expected);
    return undefined;
  }

  fail(kind: DiagnosticKind, expected: string, found = display(this.value)): void {
    this.report('error', this.node.at, kind, expected, found, this.source.effect);
  }

  /** An error about the name under which the value stands. */
  failName(kind: DiagnosticKind, expected: string, found: string): void {
    this.report('error', this.node.keyAt, kind, expected, found, this.source.effect);
  }

  warn(kind: DiagnosticKind, expected: string, found: string, effect: string): void {
    this.report('warn', this.node.at, kind, expected, found, effect);
  }

  private report(
    severity: 'error' | 'warn',
    at: number | undefined,
    kind: DiagnosticKind,
    expected: string,
    found: string,
    effect: string,
  ): void {
    const { log, area, placeOf } = this.source;
    const place = at === undefined ? undefined : placeOf?.(at);
    const path = this.path === '' ? undefined : { path: this.path };
    const details: DiagnosticDetails = {
      code: `${area}/${kind}`,
      ...place,
      ...path,
      expected,
      found,
      effect,
    };
    log[severity](details);
  }
}

/** Whether a record is of a version that this Sinew reads: 1, which needs not be written. */
export function checkVersion(record: ReadonlyMap<string, JsonValue>): boolean {
  const version = record.get('version');
  if (version?.value === undefined || version.value === 1) return true;
  const isNewer = typeof version.value === 'number' && version.value > 1;
  if (isNewer) version.fail('version', '"version" to be 1 (a newer Sinew wrote this)');
  else version.fail('json', '"version" to be 1');
  return false;
}

/** The path of a value within another: `joints."Left elbow"[1]`. */
export function pathOf(outer: string, key: string | number): string {
  if (typeof key === 'number') return `${outer}[${key}]`;
  return `${outer && `${outer}.`}${/^\w+$/.test(key) ? key : JSON.stringify(key)}`;
}

/** A value as a message shows it; scripts may pass what JSON has not. */
export function display(value: unknown): string {
  try {
    const text = JSON.stringify(value) as string | undefined;
    return text ?? typeof value;
  } catch {
    return typeof value;
  }
}
