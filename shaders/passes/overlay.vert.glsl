// Draws straight pieces of lines, each with its own color and widths, as two triangles that are moved
// apart in the picture; and triangles, of which the strip draws one and an empty one.
in vec3 startPlace;
in vec3 endPlace;
// The third corner of a triangle.
in vec3 cornerPlace;
in vec4 pieceColor;
// At start and end, in CSS pixels; negative for a triangle.
in vec2 pieceWidths;

uniform mat4 clipFromScene;
uniform vec2 viewportSize;
// The picture's pixels per CSS pixel.
uniform float cssScale;

out vec4 lineColor;

void main() {
  lineColor = pieceColor;
  if (pieceWidths.x < 0.0) {
    vec3 place = gl_VertexID == 0 ? startPlace : gl_VertexID == 1 ? endPlace : cornerPlace;
    gl_Position = clipFromScene * vec4(place, 1.0);
    return;
  }
  vec4 start = clipFromScene * vec4(startPlace, 1.0);
  vec4 end = clipFromScene * vec4(endPlace, 1.0);
  vec2 along = (end.xy / end.w - start.xy / start.w) * viewportSize;
  float size = length(along);
  vec2 across = size > 0.0 ? vec2(-along.y, along.x) / size : vec2(0.0);
  bool isStart = (gl_VertexID & 2) == 0;
  vec4 here = isStart ? start : end;
  float width = isStart ? pieceWidths.x : pieceWidths.y;
  float side = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  here.xy += across * side * width * cssScale / viewportSize * here.w;
  gl_Position = here;
}
