import type { FileContents } from './files.ts';

/**
 * A leg with every property, touching braces, a locked axis, an unknown word and block, and
 * comments.
 */
export const legSkel = `balljoint hip{
  offset 0 1 0 // from the floor
  boxmin -0.1 -0.5 -0.1
  boxmax 0.1 0 0.1
  rotxlimit -1 2
  rotylimit 0 0
  pose 0.5 0 0.25
  mass 3 4 5
  joint end { offset 1 2 3 }
  balljoint knee {
    offset 0 -0.5 0
    rotzlimit -2 2
    pose 0 -0.25 0.75
    # a foot
    balljoint foot { offset 0 -0.5 0.1 }
  }
}
`;

/**
 * Bound with rotated and scaled frames, so that a transposed matrix or a computed binding is
 * detected.
 */
export const legSkin = `positions 4 {
  -0.1 1 0
  0.1 1 0
  0 0.5 0.1
  0 0 0.3
}
normals 4 {
  0 0 1
  0 0 2
  0 1 0
  0.6 0 0.8
}
texcoords 4 {
  0 0
  1 0
  1.07 1
  0 -0.5
}
skinweights 4 {
  1 0 1
  2 0 0.5 1 0.5
  3 0 0.25 1 0.5 2 0.25
  1 2 1
}
material skin { texture leg.bmp }
triangles 2 {
  0 1 2
  2 1 3
}
bindings 3 {
  matrix { 0 1 0  -1 0 0  0 0 1  0 1 0 }
  matrix { 1 0 0  0 0 1  0 -1 0  0 0.5 0 }
  matrix { 1 0.5 0  0 2 0  0 0 1  0 0 0.1 }
}
`;

export const legMorph = `positions 2 {
  2 0 0.5 0.4
  3 0 0 0.6
}
normals 1 { 2 0 0.6 0.8 }
`;

/**
 * The skeleton has fifteen values; this clip has twelve channels and uses every rule on both sides.
 */
export const legAnim = `animation {
  range 0 2
  numchannels 12
  channel { extrapolate constant linear keys 1 { 0 0.5 flat flat } }
  channel { extrapolate cycle cycle_offset keys 3 { -1 0 linear smooth 0 0.5 smooth smooth 1 0.25 smooth linear } }
  channel 2{ extrapolate bounce bounce keys 2 { 0 0 13.7 -0.22 1.5 1 flat flat } }
  channel 3{ extrapolate linear constant keys 1 { 1 0 flat flat } }
${'  channel { extrapolate constant constant keys 1 { 0 0.25 flat flat } }\n'.repeat(8)}}
`;

export const legRig = 'rig leg { skeleton leg.skel skin leg.skin morphs 1 { bent.morph } }\n';

export const leg: FileContents = {
  'leg.skel': legSkel,
  'leg.skin': legSkin,
  'leg1.morph': legMorph,
  'leg_walk.anim': legAnim,
};
