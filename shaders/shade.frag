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
uniform vec2 radius_px;  // of the two rings

float log_z(ivec2 at) {
    float d = texelFetch(cloud_depth, at, 0).r;
    return log2(near_m * far_m / (far_m - d * (far_m - near_m)));
}

float darkening(ivec2 at, ivec2 size, float here, float radius) {
    const vec2 kAround[8] = vec2[8](vec2(1, 0), vec2(0.7071, 0.7071), vec2(0, 1),
                                    vec2(-0.7071, 0.7071), vec2(-1, 0), vec2(-0.7071, -0.7071),
                                    vec2(0, -1), vec2(0.7071, -0.7071));
    float sum = 0.0;
    for (int i = 0; i < 8; ++i) {
        ivec2 there = clamp(at + ivec2(round(kAround[i] * radius)), ivec2(0), size - 1);
        sum += max(0.0, here - log_z(there));
    }
    return sum / 8.0;
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    if (texelFetch(cloud_depth, at, 0).r >= 1.0) {
        pixel = vec4(mix(view_bottom, view_top, uv.y), 1.0);
        return;
    }
    vec3 colour = texelFetch(cloud_colour, at, 0).rgb;
    if (strength > 0.0) {
        ivec2 size = textureSize(cloud_depth, 0);
        float here = log_z(at);
        float dark = darkening(at, size, here, radius_px.x);
        if (rings > 1) dark = 0.6 * dark + 0.4 * darkening(at, size, here, radius_px.y);
        colour *= exp(-strength * dark);
    }
    pixel = vec4(colour, 1.0);
}
