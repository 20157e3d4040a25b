#include "passes/floor.vert.glsl"
