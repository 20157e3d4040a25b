/**
 * These keywords are followed by numbers only, so a backslash at the end of their lines cannot be part of
 * a name.
 */
export const continued: ReadonlySet<string> = new Set([
  ...['v', 'vt', 'vn', 'vp', 'f', 'fo', 'l', 'p', 'curv', 'curv2', 'surf'],
  ...['bmat', 'parm', 'trim', 'hole', 'scrv', 'sp', 'con'],
]);
