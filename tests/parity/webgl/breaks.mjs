// Mistakes that renderers make, put into the page on its way to the browser: the comparison has to see each.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';

export const breaks = {
    weight: ['shaders.js', 'follow(joints0[k], weights0[k])', 'if (k != 1) follow(joints0[k], weights0[k])'],
    'second-set': ['shaders.js', 'follow(joints1[k], weights1[k]);', ';'],
    morphs: ['shaders.js', 'place += morphWeights[j] * texelOf(deltas, first).xyz;', ''],
    inverse: ['crowd.js', 'if (mesh.inverse) defines.NORMALS_BY_INVERSE = 1;', ''],
    'one-sided': ['crowd.js', 'doubleSided ? three.DoubleSide : three.FrontSide', 'three.FrontSide'],
    light: ['shaders.js', 'max(dot(n, toLight), 0.0)', '0.0'],
    spot: ['shaders.js', 'if (lightCone[i].w > -1.5)', 'if (false)'],
    limit: ['shaders.js', 'front[k] = min(zone * light, 1.0);', 'front[k] = zone * light;'],
    colours: ['shaders.js', 'vec3 own = colour.rgb;', 'vec3 own = vec3(1.0);'],
    srgb: ['shaders.js', 'vec4 texel = texture(texels, at);',
        'vec4 texel = texture(texels, at); texel.rgb = pow(texel.rgb, vec3(2.2));'],
    premultiplied: ['glb.js', "premultiplyAlpha: 'none'", "premultiplyAlpha: 'premultiply'"],
    'atlas-row': ['shaders.js', 'ivec3(keys[k], row % 1024', 'ivec3(keys[k], (row + 1) % 1024'],
    shader: ['shaders.js', 'vec4 eye = modelViewMatrix', 'vec3 eye = modelViewMatrix'],
};

// What changes the text of a file of the page in `folder`.
export function broken(name, folder) {
    if (!name) return undefined;
    const [file, from, to] = breaks[name];
    if (readFileSync(join(folder, file), 'utf8').split(from).length !== 2)
        throw new Error(`${file} does not have once what ${name} changes`);
    return (asked, text) => asked === file ? text.replace(from, () => to) : text;
}
