import { defaultLimits } from '../../core/limits.ts';
import { type JsonNode, type JsonSource, JsonValue, pathOf } from './decoder.ts';
import { plainJson } from './plain-json.ts';
import { JsonFault, JsonScanner } from './json-scanner.ts';
import { TextPlaces } from './text-places.ts';

/**
 * Parses a JSON text (RFC 8259). The value equals that of `JSON.parse` and includes the place of
 * each value and name. If the text is not JSON, returns no value and an error with the place. A
 * byte order mark is skipped. If an object has a name twice, the last value counts, with a warning.
 */
export function parseJson(
  text: string,
  source: Omit<JsonSource, 'placeOf'>,
  depth = defaultLimits.depth,
): JsonValue | undefined {
  const content = text.replace(/^\uFEFF/, '');
  const places = new TextPlaces(content);
  const placed = { ...source, placeOf: (at: number) => places.place(at) };
  const plain = content.length < long ? undefined : plainJson(content, depth);
  if (plain) {
    const document = (): JsonNode => new JsonParser(content, placed, depth).document();
    return new JsonValue(new LaterNode(plain.value, document), placed);
  }
  const parser = new JsonParser(content, placed, depth);
  try {
    return new JsonValue(parser.document(), placed);
  } catch (fault) {
    if (!(fault instanceof JsonFault)) throw fault;
    const { at, kind, expected, found } = fault;
    placedAt({ value: undefined, at }, placed, parser.path).fail(kind, expected, found);
    return undefined;
  }
}

/** In code units. The places in a longer text are found when a message needs the first one. */
const long = 100_000;

/** The node of a document whose places are not known yet. */
class LaterNode implements JsonNode {
  readonly value: unknown;
  private readonly find: () => JsonNode;
  private found: JsonNode | undefined;

  constructor(value: unknown, find: () => JsonNode) {
    this.value = value;
    this.find = find;
  }

  get at(): number | undefined {
    return this.node.at;
  }

  get inner(): JsonNode['inner'] {
    return this.node.inner;
  }

  private get node(): JsonNode {
    return (this.found ??= this.find());
  }
}

class JsonParser {
  /** The names and indices that lead to the value that is being read. */
  private readonly keys: (string | number)[] = [];
  private readonly scanner: JsonScanner;
  private readonly source: JsonSource;
  private readonly depth: number;
  private level = 0;

  constructor(text: string, source: JsonSource, depth: number) {
    this.scanner = new JsonScanner(text);
    this.source = source;
    this.depth = depth;
  }

  /** The path of the value that is being read. */
  get path(): string {
    return this.keys.reduce<string>((path, key) => pathOf(path, key), '');
  }

  document(): JsonNode {
    const { scanner } = this;
    const node = this.value(scanner.skipBlanks());
    if (scanner.skipBlanks() < scanner.text.length) scanner.fail('the end of the text');
    return node;
  }

  private value(keyAt: number): JsonNode {
    const { scanner } = this;
    const at = scanner.skipBlanks();
    const first = scanner.text[at];
    if (first === '{') return this.nested(() => this.object(at, keyAt));
    if (first === '[') return this.nested(() => this.array(at, keyAt));
    return { value: first === '"' ? scanner.string() : scanner.word(), at, keyAt };
  }

  /** All nested values go through here, so that no text can exhaust the stack. */
  private nested(read: () => JsonNode): JsonNode {
    const { scanner } = this;
    if (++this.level > this.depth)
      scanner.fail(`at most ${this.depth} values in one another`, 'depth');
    scanner.at++;
    const node = read();
    this.level--;
    return node;
  }

  private object(at: number, keyAt: number): JsonNode {
    const { scanner } = this;
    const inner = new Map<string, JsonNode>();
    let expected = 'a name in quotes or "}"';
    if (!scanner.takes('}')) {
      do {
        const nameAt = scanner.skipBlanks();
        if (scanner.text[nameAt] !== '"') scanner.fail(expected);
        const name = scanner.string();
        if (inner.has(name)) this.warnOfDuplicate(name, nameAt);
        if (!scanner.takes(':')) scanner.fail('":"');
        inner.set(name, this.within(name, nameAt));
        expected = 'a name in quotes';
      } while (scanner.takes(','));
      if (!scanner.takes('}')) scanner.fail('"," or "}"');
    }
    // Built from entries, because "__proto__" is a valid name.
    const value = Object.fromEntries([...inner].map(([name, node]) => [name, node.value]));
    return { value, at, keyAt, inner };
  }

  private array(at: number, keyAt: number): JsonNode {
    const { scanner } = this;
    const inner: JsonNode[] = [];
    if (!scanner.takes(']')) {
      do inner.push(this.within(inner.length, scanner.skipBlanks()));
      while (scanner.takes(','));
      if (!scanner.takes(']')) scanner.fail('"," or "]"');
    }
    return { value: inner.map((node) => node.value), at, keyAt, inner };
  }

  private within(key: string | number, keyAt: number): JsonNode {
    // After a fault the keys stay, so that they lead to its place.
    this.keys.push(key);
    const node = this.value(keyAt);
    this.keys.pop();
    return node;
  }

  private warnOfDuplicate(name: string, keyAt: number): void {
    const node = { value: name, at: keyAt };
    placedAt(node, this.source, pathOf(this.path, name)).warn(
      'duplicate',
      'each name once in an object',
      name,
      'the last of its values counts',
    );
  }
}

/** A value by the path that leads to it. */
function placedAt(node: JsonNode, source: JsonSource, path: string): JsonValue {
  return new JsonValue(node, source, { node: () => node, path: () => path });
}
