#include "passes/backdrop.vert.glsl"
