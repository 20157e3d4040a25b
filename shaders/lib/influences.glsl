// EACH_INFLUENCE(visit) calls visit(entry, weight) for every influence of a vertex, in the file's
// order. The influences come as INFLUENCE_PAIRS pairs of attributes (four influences a pair, padded
// with weight 0, which changes no sum that started at +0) or, if INFLUENCE_PAIRS is 0, as a run of
// texels (entry, weight).

#if INFLUENCE_PAIRS > 0

in uvec4 entries0;
in vec4 weights0;
#if INFLUENCE_PAIRS > 1
in uvec4 entries1;
in vec4 weights1;
#endif
#if INFLUENCE_PAIRS > 2
in uvec4 entries2;
in vec4 weights2;
#endif
#if INFLUENCE_PAIRS > 3
in uvec4 entries3;
in vec4 weights3;
#endif

#define EACH_LANE(visit, entries, weights) \
  visit(entries.x, weights.x); \
  visit(entries.y, weights.y); \
  visit(entries.z, weights.z); \
  visit(entries.w, weights.w);

#if INFLUENCE_PAIRS == 1
#define EACH_INFLUENCE(visit) EACH_LANE(visit, entries0, weights0)
#elif INFLUENCE_PAIRS == 2
#define EACH_INFLUENCE(visit) \
  EACH_LANE(visit, entries0, weights0) \
  EACH_LANE(visit, entries1, weights1)
#elif INFLUENCE_PAIRS == 3
#define EACH_INFLUENCE(visit) \
  EACH_LANE(visit, entries0, weights0) \
  EACH_LANE(visit, entries1, weights1) \
  EACH_LANE(visit, entries2, weights2)
#else
#define EACH_INFLUENCE(visit) \
  EACH_LANE(visit, entries0, weights0) \
  EACH_LANE(visit, entries1, weights1) \
  EACH_LANE(visit, entries2, weights2) \
  EACH_LANE(visit, entries3, weights3)
#endif

#else

// The first texel of the run, and one past the last.
in uvec2 influenceRange;
uniform sampler2D influenceTexture;

#define EACH_INFLUENCE(visit) \
  for (uint texel = influenceRange.x; texel < influenceRange.y; texel++) { \
    vec2 influence = texelFetch(influenceTexture, ivec2(texel & 1023u, texel >> 10), 0).xy; \
    visit(uint(influence.x), influence.y); \
  }

#endif
