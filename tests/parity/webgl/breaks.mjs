// Mistakes that renderers make, put into the page on its way to the browser: the comparison has to see each.
export const breaks = {
    weight: ['shaders.js', 'follow(joints0[k], weights0[k])', 'if (k != 1) follow(joints0[k], weights0[k])'],
    light: ['shaders.js', 'max(dot(n, toLight), 0.0)', '0.0'],
    srgb: ['shaders.js', 'vec4 texel = texture(texels, at);',
        'vec4 texel = texture(texels, at); texel.rgb = pow(texel.rgb, vec3(2.2));'],
    premultiplied: ['glb.js', "premultiplyAlpha: 'none'", "premultiplyAlpha: 'premultiply'"],
    'atlas-row': ['shaders.js', 'ivec3(key, row % 1024', 'ivec3(key, (row + 1) % 1024'],
    shader: ['shaders.js', 'vec4 eye = modelViewMatrix', 'vec3 eye = modelViewMatrix'],
};

// What changes the text of a file of the page.
export function broken(name) {
    if (!name) return undefined;
    const [file, from, to] = breaks[name];
    return (asked, text) => {
        if (asked !== file) return text;
        if (text.split(from).length !== 2) throw new Error(`${file} does not have once what ${name} changes`);
        return text.replace(from, () => to);
    };
}
