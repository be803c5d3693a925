// The shaders. Defines say what a mesh and its material need, so that one text serves all.
//
// OpenGL 1.1 limits light times colour to 1 at vertices, before it interpolates. Which zone's colour a pixel shows is
// known there only. So the vertex shader looks up the colours of all zones that its draw may show, and passes on each.

export const vertexText = `
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp sampler2DArray;
in vec3 position, normal;
in vec2 uv;
#ifdef COLOURS
in vec4 colour;
#endif
in uvec4 joints0;
in vec4 weights0;
#if SETS > 1
in uvec4 joints1;
in vec4 weights1;
#endif
uniform mat4 modelViewMatrix, projectionMatrix;
uniform mat3 normalMatrix;
uniform sampler2D palettes;  // three texels a joint: its rows
uniform int firstPalette;
#if TARGETS > 0
uniform sampler2D deltas;    // two texels a vertex: what a morph target adds to position and normal
uniform float morphWeights[TARGETS];
#endif
uniform vec3 sceneAmbient, emission;
#if LIGHTS > 0
uniform vec4 lightPosition[LIGHTS], lightCone[LIGHTS];
uniform float lightExponent[LIGHTS];
uniform vec3 lightAmbient[LIGHTS], lightDiffuse[LIGHTS], lightAttenuation[LIGHTS];
#endif
#ifdef VERTICES
uniform int firstVertex;
flat out vec3 skinnedPosition, skinnedNormal;
#else
uniform sampler2DArray atlas;
uniform int row;          // of the individual, in the atlas
uniform int keys[ZONES];  // that this draw shows
out vec3 front[ZONES];    // the colour of the vertex in each of these zones
#ifdef DOUBLE_SIDED
out vec3 behind[ZONES];
#endif
out vec2 at;
out float distanceToEye;
#endif

vec4 texelOf(sampler2D rows, int index) { return texelFetch(rows, ivec2(index % WIDTH, index / WIDTH), 0); }

vec4 rows[3];
vec3 normalRows[3];

void follow(uint joint, float weight)
{
    int first = 3 * (firstPalette + int(joint));
    vec4 r0 = texelOf(palettes, first), r1 = texelOf(palettes, first + 1), r2 = texelOf(palettes, first + 2);
    rows[0] += weight * r0, rows[1] += weight * r1, rows[2] += weight * r2;
#ifdef NORMALS_BY_INVERSE
    vec3 c0 = cross(r1.xyz, r2.xyz), c1 = cross(r2.xyz, r0.xyz), c2 = cross(r0.xyz, r1.xyz);  // cofactors
    float length = sqrt((dot(c0, c0) + dot(c1, c1) + dot(c2, c2)) / 3.0);
    float factor = length > 0.0 ? weight * (dot(r0.xyz, c0) < 0.0 ? -1.0 : 1.0) / length : 0.0;
    normalRows[0] += factor * c0, normalRows[1] += factor * c1, normalRows[2] += factor * c2;
#endif
}

void skin(out vec3 place, out vec3 n)
{
    place = position, n = normal;
#if TARGETS > 0
    for (int j = 0; j < TARGETS; ++j) {
        int first = 2 * (j * VERTEX_COUNT + gl_VertexID);
        place += morphWeights[j] * texelOf(deltas, first).xyz;
        n += morphWeights[j] * texelOf(deltas, first + 1).xyz;
    }
#endif
    rows[0] = rows[1] = rows[2] = vec4(0.0);
    normalRows[0] = normalRows[1] = normalRows[2] = vec3(0.0);
    for (int k = 0; k < 4; ++k) follow(joints0[k], weights0[k]);
#if SETS > 1
    for (int k = 0; k < 4; ++k) follow(joints1[k], weights1[k]);
#endif
    vec4 v = vec4(place, 1.0);
    place = vec3(dot(rows[0], v), dot(rows[1], v), dot(rows[2], v));
#ifndef NORMALS_BY_INVERSE
    for (int k = 0; k < 3; ++k) normalRows[k] = rows[k].xyz;
#endif
    n = vec3(dot(normalRows[0], n), dot(normalRows[1], n), dot(normalRows[2], n));
}

vec3 lightOf(vec3 n, vec3 eye)
{
#ifndef LIT
    return vec3(1.0);
#else
    vec3 sum = sceneAmbient;
#if LIGHTS > 0
    for (int i = 0; i < LIGHTS; ++i) {
        vec3 toLight = lightPosition[i].xyz;
        float strength = 1.0;
        if (lightPosition[i].w != 0.0) {
            toLight = toLight / lightPosition[i].w - eye;
            float d = length(toLight);
            strength = 1.0 / dot(lightAttenuation[i], vec3(1.0, d, d * d));
        }
        toLight = normalize(toLight);
        float s = -dot(toLight, lightCone[i].xyz);
        if (lightCone[i].w > -1.5) strength *= s < lightCone[i].w ? 0.0 : pow(max(s, 0.0), lightExponent[i]);
        sum += strength * (lightAmbient[i] + max(dot(n, toLight), 0.0) * lightDiffuse[i]);
    }
#endif
    return sum;
#endif
}

void main()
{
    vec3 place, n;
    skin(place, n);
#ifdef VERTICES
    int pixel = firstVertex + gl_VertexID;
    vec2 middle = vec2(pixel % WIDTH, pixel / WIDTH) + 0.5;
    gl_Position = vec4(2.0 * middle / vec2(WIDTH, HEIGHT) - 1.0, 0.0, 1.0);
    gl_PointSize = 1.0;
    skinnedPosition = place;
    skinnedNormal = n;
#else
    vec4 eye = modelViewMatrix * vec4(place, 1.0);
    gl_Position = projectionMatrix * eye;
    n = normalize(normalMatrix * n);
#ifdef COLOURS
    vec3 own = colour.rgb;
#else
    vec3 own = vec3(1.0);
#endif
    vec3 light = own * lightOf(n, eye.xyz), lightBehind = own * lightOf(-n, eye.xyz);
    for (int k = 0; k < ZONES; ++k) {
        vec3 zone = texelFetch(atlas, ivec3(keys[k], row % 1024, row / 1024), 0).rgb;
        front[k] = min(zone * light + emission, 1.0);
#ifdef DOUBLE_SIDED
        behind[k] = min(zone * lightBehind + emission, 1.0);
#endif
    }
    at = uv;
    distanceToEye = -eye.z;
#endif
}
`;

export const fragmentText = `
precision highp float;
precision highp int;
uniform sampler2D texels;
uniform int keys[ZONES];
uniform float actor;
uniform vec3 fogColour;
uniform float fogDensity, fogStart, fogEnd;
in vec3 front[ZONES];
#ifdef DOUBLE_SIDED
in vec3 behind[ZONES];
#endif
in vec2 at;
in float distanceToEye;
layout(location = 0) out vec4 pixel;
layout(location = 1) out vec4 facts;  // depth, actor, zone + 1

void main()
{
    vec4 texel = texture(texels, at);
    int key = int(texel.a * 255.0 + 0.5);
    vec3 colour = vec3(-1.0);
    for (int k = 0; k < ZONES; ++k)
#ifdef DOUBLE_SIDED
        if (key == keys[k]) colour = gl_FrontFacing ? front[k] : behind[k];
#else
        if (key == keys[k]) colour = front[k];
#endif
    if (colour.r < 0.0) discard;  // a hole, whose key is 0, or a zone of another draw
    colour *= texel.rgb;
#ifdef FOG
    colour = mix(fogColour, colour, clamp(FOG, 0.0, 1.0));
#endif
    pixel = vec4(colour, 1.0);
    facts = vec4(gl_FragCoord.z, actor, float(key), 1.0);
}
`;

export const vertexFragmentText = `
precision highp float;
flat in vec3 skinnedPosition, skinnedNormal;
layout(location = 0) out vec4 position;
layout(location = 1) out vec4 normal;

void main()
{
    position = vec4(skinnedPosition, 0.0);
    normal = vec4(skinnedNormal, 0.0);
}
`;

// OpenGL's formulas of the distance.
export const fogOf = {
    linear: '(fogEnd - distanceToEye) / (fogEnd - fogStart)',
    exp: 'exp(-fogDensity * distanceToEye)',
    exp2: 'exp(-fogDensity * fogDensity * distanceToEye * distanceToEye)',
};
