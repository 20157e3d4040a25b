#include "passes/mesh.vert.glsl"
