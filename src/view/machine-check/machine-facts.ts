/** What a browser says about the machine and its GPU. */
export interface MachineFacts {
  readonly browser: string;
  readonly processors: number;
  /** Device pixels in a pixel of the page. */
  readonly pixelRatio: number;
  readonly renderer: string;
  readonly vendor: string;
  readonly limits: Readonly<Record<string, number>>;
  readonly extensions: readonly string[];
}

/** The limits of WebGL2 that decide how a character is stored and drawn. */
const limitNames = [
  'MAX_TEXTURE_SIZE',
  'MAX_SAMPLES',
  'MAX_UNIFORM_BLOCK_SIZE',
  'MAX_VERTEX_UNIFORM_VECTORS',
  'MAX_VERTEX_ATTRIBS',
  'MAX_VERTEX_TEXTURE_IMAGE_UNITS',
] as const;

export function machineFacts(gl: WebGL2RenderingContext): MachineFacts {
  const unmasked = gl.getExtension('WEBGL_debug_renderer_info');
  const text = (name: number): string => String(gl.getParameter(name));
  return {
    browser: navigator.userAgent,
    processors: navigator.hardwareConcurrency,
    pixelRatio: devicePixelRatio,
    renderer: text(unmasked?.UNMASKED_RENDERER_WEBGL ?? gl.RENDERER),
    vendor: text(unmasked?.UNMASKED_VENDOR_WEBGL ?? gl.VENDOR),
    limits: Object.fromEntries(
      limitNames.map((name) => [name, gl.getParameter(gl[name]) as number]),
    ),
    extensions: gl.getSupportedExtensions() ?? [],
  };
}
