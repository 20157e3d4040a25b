import type { Color, MaterialColors, MaterialParts } from '../../core/character-parts.ts';

const black: Color = [0, 0, 0];

/** A material as its lines fill it. */
export interface MaterialLines {
  name: string;
  texture?: string;
  diffuse?: Color;
  specular?: Color;
  ambient?: Color;
  shininess?: number;
  alpha?: number;
}

export function finishMaterial({ name, texture, ...rest }: MaterialLines): MaterialParts {
  const colors = colorsOf(rest);
  return { name, ...(texture === undefined ? {} : { texture }), ...(colors ? { colors } : {}) };
}

function colorsOf(draft: Omit<MaterialLines, 'name' | 'texture'>): MaterialColors | undefined {
  const { diffuse, specular = black, ambient = black, shininess = 0, alpha = 1 } = draft;
  return diffuse && { diffuse, alpha, specular, shininess, ambient, shown: diffuse };
}
