#version 330 core
// Lines with soft edges and dashes; what lies behind the cloud is drawn weaker.
noperspective in vec2 along_across;
flat in float half_width;
flat in vec4 colour;
flat in float hidden_style;  // 0 faint, 1 dotted, 2 gone, 3 as in front
flat in vec4 dashes;
layout(location = 0) out vec4 pixel;

uniform sampler2D cloud_depth;
uniform float near_m;
uniform float far_m;
uniform float tolerance_m;  // a line on the surface is not hidden by it

float z_of(float d) {
    return near_m * far_m / (far_m - d * (far_m - near_m));
}

float dash_alpha(vec4 dash, float along) {
    float period = dash.x + dash.y + dash.z + dash.w;
    if (period <= 0.0) return 1.0;
    float s = mod(along, period);
    bool on = s < dash.x || (s >= dash.x + dash.y && s < dash.x + dash.y + dash.z);
    return on ? 1.0 : 0.0;
}

void main() {
    float alpha = clamp(half_width + 0.5 - abs(along_across.y), 0.0, 1.0) * colour.a;
    alpha *= dash_alpha(dashes, along_across.x);
    float in_front = texelFetch(cloud_depth, ivec2(gl_FragCoord.xy), 0).r;
    bool behind = in_front < 1.0 && z_of(gl_FragCoord.z) > z_of(in_front) + tolerance_m;
    if (behind && hidden_style < 2.5) {
        if (hidden_style < 0.5) {
            alpha *= 0.25;
        } else if (hidden_style < 1.5) {
            alpha *= 0.6 * dash_alpha(vec4(2.0, 5.0, 0.0, 0.0), along_across.x);
        } else {
            alpha = 0.0;
        }
    }
    if (alpha <= 0.0) discard;
    pixel = vec4(colour.rgb, alpha);
}
