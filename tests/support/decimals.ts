import fc from 'fast-check';

/** One of the characters of an ASCII text. */
export function characterOf(text: string): fc.Arbitrary<string> {
  return fc.nat(text.length - 1).map((index) => text.charAt(index));
}

const digit = characterOf('0123456789');
const sign = fc.constantFrom('', '', '-', '+');
const exponent = fc
  .tuple(fc.constantFrom('e', 'E'), sign, fc.oneof(fc.nat(25), fc.nat(420)))
  .map(([letter, plus, power]) => `${letter}${plus}${power}`);

function digits(fewest: number, most: number): fc.Arbitrary<string> {
  return fc.string({ unit: digit, minLength: fewest, maxLength: most });
}

const mantissa = fc.oneof(
  digits(1, 17),
  digits(1, 30),
  fc.tuple(digits(1, 20), digits(0, 30)).map(([whole, part]) => `${whole}.${part}`),
  digits(1, 25).map((part) => `.${part}`),
  digits(1, 8).map((part) => `0.000000000000000000000${part}`),
);

/** Decimal numbers of every kind: short, long, tiny, huge, with all signs and exponents. */
export const decimalText = fc.oneof(
  fc
    .tuple(sign, mantissa, fc.oneof(fc.constant(''), exponent))
    .map((parts) => parts.join(''))
    .filter((text) => text.length <= 64),
  fc.double({ noNaN: true, noDefaultInfinity: true }).map(String),
  fc.float({ noNaN: true, noDefaultInfinity: true }).map(String),
);
