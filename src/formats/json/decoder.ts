import type {
  DiagnosticArea,
  DiagnosticDetails,
  DiagnosticKind,
  DiagnosticLog,
  Place,
  Severity,
} from '../../core/diagnostics.ts';

/** A value and, if it was read from a text, the offsets of it and of its key in code units. */
export interface JsonNode {
  readonly value: unknown;
  readonly at?: number | undefined;
  readonly keyAt?: number | undefined;
  /** The values within it: those of an object by name, those of a list in order. */
  readonly inner?: ReadonlyMap<string, JsonNode> | readonly JsonNode[] | undefined;
}

/** Information that all values of a text share, for messages. */
export interface JsonSource {
  readonly log: DiagnosticLog;
  readonly area: DiagnosticArea;
  /** The consequence of an error in a value. */
  readonly effect: string;
  /** 'warning' where a default takes the place of a wrong value; an error if absent. */
  readonly severity?: Severity;
  /** Converts an offset in the text to a place; absent for values that scripts pass. */
  readonly placeOf?: (at: number) => Place;
}

function innerAt(inner: JsonNode['inner'], key: string | number): JsonNode | undefined {
  if (!inner || 'get' in inner) return inner?.get(String(key));
  return inner[Number(key)];
}

/** Where a value stands in its text. It is asked for only by messages. */
interface Origin {
  node(): Omit<JsonNode, 'value'>;
  path(): string;
}

/** The place of a value within another. */
class Inner implements Origin {
  private readonly outer: Origin;
  private readonly key: string | number;

  constructor(outer: Origin, key: string | number) {
    this.outer = outer;
    this.key = key;
  }

  node(): Omit<JsonNode, 'value'> {
    const { at, inner } = this.outer.node();
    return innerAt(inner, this.key) ?? { at };
  }

  path(): string {
    return pathOf(this.outer.path(), this.key);
  }
}

/**
 * A value of a JSON text, or one that a script passed. Its accessors check the value and report
 * errors.
 */
export class JsonValue {
  readonly value: unknown;
  readonly source: JsonSource;
  private readonly origin: Origin;

  /** @param origin is the node of the value itself, if absent */
  constructor(
    node: JsonNode,
    source: JsonSource,
    origin: Origin = { node: () => node, path: () => '' },
  ) {
    this.value = node.value;
    this.source = source;
    this.origin = origin;
  }

  /** The value at a name or index; a missing one has the place of this value. */
  member(key: string | number): JsonValue {
    const value = (this.value as Record<string | number, unknown>)[key];
    return new JsonValue({ value }, this.source, new Inner(this.origin, key));
  }

  /** The same value, whose errors are reported in another way. */
  reporting(change: Partial<Pick<JsonSource, 'log' | 'effect' | 'severity'>>): JsonValue {
    return new JsonValue(this, { ...this.source, ...change }, this.origin);
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

  /**
   * Returns a list of finite numbers whose length is one of `counts`. An error has the place of the
   * first invalid number.
   */
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

  /** The values of a list of at most `longest` items. */
  list(longest: number, expected: string): readonly JsonValue[] | undefined {
    const { value } = this;
    if (Array.isArray(value) && value.length <= longest) {
      return value.map((_, index) => this.member(index));
    }
    this.fail('json', expected);
    return undefined;
  }

  text(expected: string): string | undefined {
    if (typeof this.value === 'string') return this.value;
    this.fail('json', expected);
    return undefined;
  }

  fail(kind: DiagnosticKind, expected: string, found = display(this.value)): void {
    const { severity = 'error', effect } = this.source;
    this.report(severity, this.origin.node().at, kind, expected, found, effect);
  }

  /** Reports an error about the name of this value. */
  failName(kind: DiagnosticKind, expected: string, found: string): void {
    this.report('error', this.origin.node().keyAt, kind, expected, found, this.source.effect);
  }

  warn(kind: DiagnosticKind, expected: string, found: string, effect: string): void {
    this.report('warning', this.origin.node().at, kind, expected, found, effect);
  }

  /** Where the value is in its text, as far as that is known. */
  get place(): Place {
    return this.placeOf(this.origin.node().at);
  }

  private placeOf(at: number | undefined): Place {
    const place = at === undefined ? undefined : this.source.placeOf?.(at);
    const path = this.origin.path();
    return { ...place, ...(path !== '' && { path }) };
  }

  private report(
    severity: Severity,
    at: number | undefined,
    kind: DiagnosticKind,
    expected: string,
    found: string,
    effect: string,
  ): void {
    const { log, area } = this.source;
    const code = `${area}/${kind}` as const;
    const details: DiagnosticDetails = { code, ...this.placeOf(at), expected, found, effect };
    if (severity === 'error') log.error(details);
    else log.warn(details);
  }
}

/** Whether this version of Sinew can read a record: its version is 1 or absent. */
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

/** Formats a value for a message; scripts may pass values that JSON does not have. */
export function display(value: unknown): string {
  if (typeof value === 'number') return String(value);
  try {
    const text = JSON.stringify(value) as string | undefined;
    return text ?? typeof value;
  } catch {
    return typeof value;
  }
}
