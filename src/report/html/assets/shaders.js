// Programs of the view. A triangle's number is that of its first corner divided by three.

const CORNER = `#version 300 es
in vec3 position, carried;
in vec4 mark;
uniform mat4 camera;
uniform float slide, nearer;
out vec3 place, pattern, corner;
flat out vec4 tint;
flat out uint triangle;
void main() {
  int k = gl_VertexID % 3;
  corner = vec3(k == 0, k == 1, k == 2);
  triangle = uint(gl_VertexID / 3);
  place = mix(position, carried, slide);
  pattern = carried;
  tint = mark;
  gl_Position = camera * vec4(place, 1.0);
  gl_Position.z -= nearer * gl_Position.w;
}`;

const FILL = `#version 300 es
precision highp float;
in vec3 place, pattern, corner;
flat in vec4 tint;
uniform vec4 base, plane;
uniform vec3 eye;
uniform float checker, edges, chosen;
out vec4 colour;
void main() {
  float over = dot(plane.xyz, place) - plane.w;
  vec3 normal = normalize(cross(dFdx(place), dFdy(place)));
  vec3 width = fwidth(corner);
  float cut = fwidth(over);
  if (over > 0.0) discard;
  colour = base;
  if (checker > 0.0) {
    ivec3 c = ivec3(floor(pattern * checker));
    float light = ((c.x + c.y + c.z) & 1) == 0 ? 1.0 : 0.55;
    colour.rgb = light * (0.62 + 0.38 * clamp(pattern, -1.0, 1.0));
  }
  if (tint.a > 0.5) colour = vec4(tint.rgb, 1.0);
  if (chosen > 0.0) colour = vec4(0.5, 1.0, 0.25, 1.0);
  if (colour.a <= 0.0) discard;
  colour.rgb *= 0.5 + 0.5 * abs(dot(normal, normalize(eye - place)));
  vec3 near = corner / max(width, vec3(1e-9));
  float fine = 1.0 - smoothstep(0.1, 0.5, max(width.x, max(width.y, width.z)));
  float line = edges * fine * (1.0 - smoothstep(0.4, 1.3, min(near.x, min(near.y, near.z))));
  colour.rgb = mix(colour.rgb, vec3(0.08), 0.7 * line);
  if (cut > 0.0 && over > -2.0 * cut) colour = vec4(0.6 * base.rgb, 1.0);
}`;

const PICK = `#version 300 es
precision highp float;
precision highp int;
in vec3 place;
flat in vec4 tint;
flat in uint triangle;
uniform vec4 base, plane;
uniform uint surface;
out uvec4 answer;
void main() {
  if (dot(plane.xyz, place) > plane.w || (base.a <= 0.0 && tint.a < 0.5)) discard;
  answer = uvec4(triangle + 1u, surface, 0u, 0u);
}`;

const DOT = `#version 300 es
in vec3 position;
in vec4 mark;
uniform mat4 camera;
uniform float size;
out vec4 tint;
out vec3 place;
void main() {
  tint = mark;
  place = position;
  gl_Position = camera * vec4(position, 1.0);
  gl_Position.z -= 4e-4 * gl_Position.w;
  gl_PointSize = size;
}`;

const ROUND = `#version 300 es
precision highp float;
in vec4 tint;
in vec3 place;
uniform vec4 plane;
out vec4 colour;
void main() {
  float r = length(gl_PointCoord - 0.5);
  if (r > 0.5 || tint.a < 0.5 || dot(plane.xyz, place) > plane.w + 1e-6) discard;
  colour = vec4(r > 0.32 ? vec3(0.0) : tint.rgb, 1.0);
}`;
