#version 330 core
// The cloud's colours with eye-dome lighting, over the background: a point is darkened by how much
// nearer its neighbours in the picture are (C. Boucheny, 2009).
in vec2 uv;
layout(location = 0) out vec4 pixel;

uniform sampler2D cloud_colour;
uniform sampler2D cloud_depth;
uniform vec3 view_top;
uniform vec3 view_bottom;
uniform float near_m;
uniform float far_m;
uniform float strength;  // 0: no eye-dome lighting
uniform int rings;       // 1 while moving, 2 in a still picture
uniform int neighbours;  // on each ring
uniform vec2 turn;       // cosine and sine of the angle between two of them
uniform vec2 radius_px;  // of the two rings

// far - d (far - near), which is near * far / z: nearer is larger.
float inverse_z(ivec2 at) {
    return far_m - texelFetch(cloud_depth, at, 0).r * (far_m - near_m);
}

// Product over neighbours of z_here / z_there where that is more than 1: the sum of differences of
// log z, with one logarithm at the end. `count` is 0 over the background, where a software
// rasteriser would walk an unrolled loop all the same.
float nearer_neighbours(ivec2 at, ivec2 last, float here, float radius, int count) {
    float product = 1.0;
    vec2 around = vec2(radius, 0.0);
    for (int i = 0; i < count; ++i) {
        ivec2 there = clamp(at + ivec2(round(around)), ivec2(0), last);
        product *= max(1.0, inverse_z(there) / here);
        around = vec2(turn.x * around.x - turn.y * around.y,
                      turn.y * around.x + turn.x * around.y);
    }
    return product;
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec3 background = mix(view_bottom, view_top, uv.y);
    bool is_cloud = texelFetch(cloud_depth, at, 0).r < 1.0;
    int count = is_cloud && strength > 0.0 ? neighbours : 0;
    float share = 1.0 / float(neighbours);
    ivec2 last = textureSize(cloud_depth, 0) - 1;
    float here = inverse_z(at);
    float dark = log2(nearer_neighbours(at, last, here, radius_px.x, count)) * share;
    if (rings > 1) {
        float outer = log2(nearer_neighbours(at, last, here, radius_px.y, count)) * share;
        dark = 0.6 * dark + 0.4 * outer;
    }
    vec3 colour = texelFetch(cloud_colour, at, 0).rgb * exp(-strength * dark);
    pixel = vec4(is_cloud ? colour : background, 1.0);
}
