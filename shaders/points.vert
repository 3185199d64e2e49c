#version 330 core
// A cloud's points: projected, coloured by one number a point, shaded by their normal.
layout(location = 0) in vec3 p;
layout(location = 1) in vec4 n_i;     // normal, and image brightness 0 … 1
layout(location = 2) in float value;  // what the colour tells

uniform mat4 clip_from_cloud;
uniform mat4 view_from_cloud;  // camera: x right, y down, z forward
uniform float size_px;
uniform int colour_by;  // 0 map of `value`, 1 brightness, 2 normal, 3 one colour
uniform vec2 range;     // of the map
uniform float below_is_grey;  // 1: values under the range are shown as "too few"
uniform vec3 one_colour;
uniform vec3 grey;
uniform sampler2D map;

flat out vec3 colour;

vec3 from_map(float x) {
    if (below_is_grey > 0.5 && x < range.x) return grey;
    float t = clamp((x - range.x) / max(range.y - range.x, 1e-12), 0.0, 1.0);
    return textureLod(map, vec2((t * 255.0 + 0.5) / 256.0, 0.5), 0.0).rgb;
}

void main() {
    gl_Position = clip_from_cloud * vec4(p, 1.0);
    gl_PointSize = size_px;
    vec3 n = mat3(view_from_cloud) * n_i.xyz;
    if (colour_by == 0) {
        colour = from_map(value);
    } else if (colour_by == 1) {
        colour = vec3(n_i.w);
    } else if (colour_by == 2) {
        colour = n_i.xyz * 0.5 + 0.5;
    } else {
        colour = one_colour;
    }
    // Light from the upper left behind the viewer; points without a normal are lit fully.
    const vec3 to_light = vec3(-0.37139, -0.55709, -0.74278);
    float lit = dot(n, n) > 0.25 ? 0.60 + 0.40 * max(0.0, dot(n, to_light)) : 1.0;
    colour *= lit;
}
