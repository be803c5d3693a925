// The pictures of a result: colour, depth and ids from one draw into two targets.
import * as three from 'three';

const mostSide = 2048;

// The part of the picture that a tile shows, and `shift` pixels, put into clip space.
function tileOf(projection, { width, height }, { x, y, w, h }, shift) {
    const tile = new three.Matrix4().set(
        width / w, 0, 0, (width - 2 * (x - shift) - w) / w,
        0, height / h, 0, (height - 2 * (y - shift) - h) / h,
        0, 0, 1, 0,
        0, 0, 0, 1);
    return tile.multiply(projection);
}

function targetOf(w, h) {
    const target = new three.WebGLRenderTarget(w, h, {
        count: 2, minFilter: three.NearestFilter, magFilter: three.NearestFilter, generateMipmaps: false,
    });
    target.textures[1].type = three.FloatType;
    return target;
}

// `times`: how many times as large the picture is drawn in each direction. Of `times` x `times` pixels the one is kept
// whose centre is the centre of the small pixel; for even numbers the picture moves by half a large pixel, so that
// there is one. That makes a rasteriser which places vertices coarsely as many times finer.
export function drawPictures(renderer, crowd, times) {
    const { width, height, projection } = crowd.scene.json, pixels = width * height;
    const out = {
        colour: new Uint8Array(3 * pixels), depth: new Float32Array(pixels).fill(1),
        actor: new Uint32Array(pixels), zone: new Uint16Array(pixels),
    };
    const people = crowd.people(), camera = new three.Camera(), middle = Math.floor(times / 2);
    const eyeToClip = new three.Matrix4().set(...projection.flat());
    const side = Math.floor(mostSide / times), shift = times % 2 ? 0 : 0.5 / times;
    camera.matrixWorldAutoUpdate = false;
    for (let y = 0; y < height; y += side)
        for (let x = 0; x < width; x += side) {
            const w = Math.min(side, width - x), h = Math.min(side, height - y);
            const target = targetOf(w * times, h * times);
            camera.projectionMatrix.copy(tileOf(eyeToClip, crowd.scene.json, { x, y, w, h }, shift));
            renderer.setRenderTarget(target);
            renderer.render(people, camera);
            const colours = new Uint8Array(4 * w * times * h * times), facts = new Float32Array(colours.length);
            renderer.readRenderTargetPixels(target, 0, 0, w * times, h * times, colours, undefined, 0);
            renderer.readRenderTargetPixels(target, 0, 0, w * times, h * times, facts, undefined, 1);
            target.dispose();
            for (let row = 0; row < h; ++row)
                for (let column = 0; column < w; ++column) {
                    const from = 4 * ((row * times + middle) * w * times + column * times + middle);
                    const to = (height - 1 - (y + row)) * width + x + column;  // a result begins at the top
                    if (facts[from + 1] === 0) continue;
                    out.colour.set(colours.subarray(from, from + 3), 3 * to);
                    [out.depth[to], out.actor[to], out.zone[to]] = facts.subarray(from, from + 3);
                }
        }
    return out;
}
