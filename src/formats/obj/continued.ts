/** Behind these stand numbers alone, so that a backslash at the end of such a line is no part of a name. */
export const continued: ReadonlySet<string> = new Set([
  ...['v', 'vt', 'vn', 'vp', 'f', 'fo', 'l', 'p', 'curv', 'curv2', 'surf'],
  ...['bmat', 'parm', 'trim', 'hole', 'scrv', 'sp', 'con'],
]);
