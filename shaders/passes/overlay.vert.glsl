// Draws straight pieces of lines, each with its own color and width, as two triangles that are moved
// apart in the picture.
in vec3 startPlace;
in vec3 endPlace;
in vec4 pieceColor;
// In CSS pixels.
in float pieceWidth;

uniform mat4 clipFromScene;
uniform vec2 viewportSize;
// The picture's pixels per CSS pixel.
uniform float cssScale;

out vec4 lineColor;

void main() {
  vec4 start = clipFromScene * vec4(startPlace, 1.0);
  vec4 end = clipFromScene * vec4(endPlace, 1.0);
  vec2 along = (end.xy / end.w - start.xy / start.w) * viewportSize;
  float size = length(along);
  vec2 across = size > 0.0 ? vec2(-along.y, along.x) / size : vec2(0.0);
  vec4 here = (gl_VertexID & 2) == 0 ? start : end;
  float side = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  here.xy += across * side * pieceWidth * cssScale / viewportSize * here.w;
  lineColor = pieceColor;
  gl_Position = here;
}
