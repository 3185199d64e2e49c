#version 330 core
// Pieces of lines, already laid out in pixels.
layout(location = 0) in vec3 at;      // x, y from the upper left corner in px, depth 0 … 1
layout(location = 1) in vec3 piece;   // along, across, half width, in px
layout(location = 2) in vec4 rgba;
layout(location = 3) in float hidden;
layout(location = 4) in vec4 dash;

uniform vec2 size_px;

noperspective out vec2 along_across;
flat out float half_width;
flat out vec4 colour;
flat out float hidden_style;
flat out vec4 dashes;

void main() {
    vec2 ndc = vec2(2.0 * at.x / size_px.x - 1.0, 1.0 - 2.0 * at.y / size_px.y);
    gl_Position = vec4(ndc, 2.0 * at.z - 1.0, 1.0);
    along_across = piece.xy;
    half_width = piece.z;
    colour = rgba;
    hidden_style = hidden;
    dashes = dash;
}
