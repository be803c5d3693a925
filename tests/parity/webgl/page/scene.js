// A folder that `claque parity export` wrote.
import { readArray } from './arrays.js';
import { readGlb } from './glb.js';

async function bytesOf(name) {
    const answer = await fetch(`scene/${name}`);
    if (!answer.ok) throw new Error(`${name}: ${answer.status} ${answer.statusText}`);
    return answer.arrayBuffer();
}

// Rows of actors.npy as objects with the names of its columns.
function individualsOf(table, columns) {
    const individuals = [];
    for (let first = 0; first < table.length; first += columns.length) {
        const individual = { row: individuals.length };
        columns.forEach((name, column) => { individual[name] = table[first + column]; });
        individuals.push(individual);
    }
    return individuals;
}

export async function readScene() {
    const json = JSON.parse(new TextDecoder().decode(await bytesOf('capture.json')));
    if (json.format !== 'claque-parity' || json.version !== 1 || json.kind !== 'scene')
        throw new Error('the folder holds no parity scene of version 1');
    const arrays = {};
    const names = ['actors', 'model_view', 'palettes', 'morph_weights', 'atlas'];
    await Promise.all(names.map(async (name) => {
        arrays[name] = readArray(await bytesOf(`${name}.npy`), name);
    }));
    const { textures, materials, meshes } = await readGlb(await bytesOf('scene.glb'));
    return {
        json, arrays, textures, materials,
        meshes: json.meshes.map(({ mesh, normals }) => ({ ...meshes[mesh], inverse: normals === 'inverse' })),
        individuals: individualsOf(arrays.actors, json.actor_columns),
    };
}
