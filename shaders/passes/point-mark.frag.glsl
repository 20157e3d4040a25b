uniform float opacity;

out vec4 color;

void main() {
  float radius = 2.0 * length(gl_PointCoord - 0.5);
  if (radius > 1.0) discard;
  // A white ring between two dark ones is seen on every color; the point itself is left free.
  float ring = smoothstep(0.52, 0.62, radius) * (1.0 - smoothstep(0.8, 0.9, radius));
  float band = smoothstep(0.3, 0.4, radius);
  color = vec4(vec3(ring), opacity * band);
}
