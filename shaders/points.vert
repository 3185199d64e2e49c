#version 330 core
// A cloud's points: projected, coloured by one number a point, shaded by their normal.
layout(location = 0) in vec3 p;
layout(location = 1) in vec3 n;
layout(location = 2) in float value;
layout(location = 3) in float brightness;  // of the image, 0 … 1

uniform mat4 clip_from_cloud;
uniform mat4 view_from_cloud;
uniform vec4 depth_from_cloud;  // row: distance along the stereo camera's z
uniform float size_px;
uniform int colour_by;        // 0 map of value, 1 brightness, 2 normal, 3 one colour, 4 map of depth
uniform float map_from;       // value at the beginning of the map
uniform float map_per_value;  // 1 / (value at its end − value at its beginning)
uniform float under_is_grey;  // 1: values before the beginning are "too few"
uniform vec3 one_colour;
uniform vec3 grey;
uniform mat4 world_from_cloud;
uniform vec3 keep_min;
uniform vec3 keep_max;
uniform int keep;  // 0 all, 1 what is inside the box, 2 what is outside; the rest is grey
uniform sampler2D map;

flat out vec3 colour;

vec3 from_map(float x) {
    if (x < 0.0) return grey;  // unknown
    float t = (x - map_from) * map_per_value;
    if (under_is_grey > 0.5 && t < 0.0) return grey;
    return textureLod(map, vec2((clamp(t, 0.0, 1.0) * 255.0 + 0.5) / 256.0, 0.5), 0.0).rgb;
}

void main() {
    gl_Position = clip_from_cloud * vec4(p, 1.0);
    gl_PointSize = size_px;
    if (colour_by == 0) {
        colour = from_map(value);
    } else if (colour_by == 1) {
        colour = vec3(brightness);
    } else if (colour_by == 2) {
        colour = n * 0.5 + 0.5;
    } else if (colour_by == 3) {
        colour = one_colour;
    } else {
        colour = from_map(dot(depth_from_cloud, vec4(p, 1.0)));
    }
    if (keep != 0) {
        vec3 q = (world_from_cloud * vec4(p, 1.0)).xyz;
        bool inside = all(greaterThanEqual(q, keep_min)) && all(lessThanEqual(q, keep_max));
        if (inside == (keep == 2)) colour = grey;
    }
    // Light from the upper left behind the viewer; points without a normal are lit fully.
    const vec3 to_light = vec3(-0.37139, -0.55709, -0.74278);
    vec3 in_view = mat3(view_from_cloud) * n;
    colour *= dot(n, n) > 0.25 ? 0.60 + 0.40 * max(0.0, dot(in_view, to_light)) : 1.0;
}
