// Textures of a scene: texels bit for bit, and numbers for shaders to fetch.
import * as three from 'three';

export const width = 2048;  // of textures that hold rows of numbers, and of the picture that vertices are written to
const wraps = { 10497: three.RepeatWrapping, 33071: three.ClampToEdgeWrapping, 33648: three.MirroredRepeatWrapping };

// Floats, four in each texel, row after row.
export function rowsOf(values) {
    const height = Math.max(1, Math.ceil(values.length / 4 / width)), data = new Float32Array(4 * width * height);
    data.set(values);
    const texture = new three.DataTexture(data, width, height, three.RGBAFormat, three.FloatType);
    texture.needsUpdate = true;
    return texture;
}

export function textureOf({ image, wrapS, wrapT }) {
    const texture = new three.Texture(image, three.UVMapping, wraps[wrapS], wraps[wrapT]);
    texture.minFilter = texture.magFilter = three.NearestFilter;
    texture.generateMipmaps = texture.flipY = texture.premultiplyAlpha = false;
    texture.needsUpdate = true;
    return texture;
}

// Each plate is a layer: plates below each other would soon be higher than a texture may be.
export function atlasOf(atlas) {
    const [plates, rows, columns] = atlas.shape;
    const texture = new three.DataArrayTexture(atlas, columns, rows, plates);
    texture.format = three.RGBFormat;
    texture.internalFormat = 'RGB8';
    texture.unpackAlignment = 1;
    texture.needsUpdate = true;
    return texture;
}
