// Reads a scene, draws it with three.js, and sends back a complete result (docs/parity.md).
// ?times=N draws the picture N times as large in each direction and keeps the middle pixels.
import * as three from 'three';
import { writeArray } from './arrays.js';
import { Crowd } from './crowd.js';
import { drawPictures } from './pictures.js';
import { readScene } from './scene.js';
import { readVertices } from './vertices.js';

async function send(name, body) {
    const answer = await fetch(`result/${name}`, { method: 'POST', body });
    if (!answer.ok) throw new Error(`${name}: ${await answer.text()}`);
}

function rendererOf() {
    three.ColorManagement.enabled = false;  // numbers are multiplied as they stand
    const renderer = new three.WebGLRenderer({ antialias: false, alpha: true });
    renderer.outputColorSpace = three.LinearSRGBColorSpace;
    renderer.sortObjects = false;  // the draw list has an order
    renderer.setClearColor(0x000000, 0);
    const gl = renderer.getContext();
    if (!gl.getExtension('EXT_color_buffer_float')) throw new Error('this WebGL cannot draw floats');
    const names = gl.getExtension('WEBGL_debug_renderer_info');
    return { renderer, name: gl.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : gl.RENDERER) };
}

async function sendResult(scene, name, pictures, vertices) {
    const { width, height } = scene.json;
    await send('colour.npy', writeArray(pictures.colour, [height, width, 3]));
    for (const picture of ['depth', 'actor', 'zone'])
        await send(`${picture}.npy`, writeArray(pictures[picture], [height, width]));
    for (const array of ['positions', 'normals'])
        await send(`${array}.npy`, writeArray(vertices[array], [vertices[array].length / 3, 3]));
    for (const copied of ['actors', 'sizes', 'model_view'])
        await send(`${copied}.npy`, await (await fetch(`scene/${copied}.npy`)).arrayBuffer());
    const { palette_rows, morph_weights, lighting, fog, ...both } = scene.json;  // the first four are the scene's own
    const result = { ...both, kind: 'result', renderer: `three.js ${three.REVISION}, WebGL 2; ${name}` };
    await send('capture.json', JSON.stringify(result, null, 2) + '\n');
    await send('complete', '');
}

const times = Number(new URLSearchParams(location.search).get('times') ?? 1);
const scene = await readScene();
const { renderer, name } = rendererOf();
const crowd = new Crowd(scene);
await sendResult(scene, name, drawPictures(renderer, crowd, times), readVertices(renderer, crowd));
document.querySelector('#says').textContent = 'The result is complete.';
