// The skinned vertices, read back from the very shader that draws: each is a point on a pixel of its own.
import * as three from 'three';

const height = 512;

function targetOf(width) {
    return new three.WebGLRenderTarget(width, height, {
        count: 2, type: three.FloatType, minFilter: three.NearestFilter, magFilter: three.NearestFilter,
        generateMipmaps: false, depthBuffer: false,
    });
}

// Individuals whose vertices fit into one target, in groups.
function* groupsOf(individuals, most) {
    let group = [];
    for (const individual of individuals) {
        if (individual.vertex_count > most) throw new Error(`actor ${individual.actor} has over ${most} vertices`);
        const { first_vertex } = group[0] ?? individual;
        if (individual.first_vertex + individual.vertex_count - first_vertex > most) {
            yield group;
            group = [];
        }
        group.push(individual);
    }
    if (group.length) yield group;
}

export function readVertices(renderer, crowd) {
    const { width, scene } = crowd, target = targetOf(width), camera = new three.Camera();
    const out = [new Float32Array(3 * scene.json.vertices), new Float32Array(3 * scene.json.vertices)];
    const read = new Float32Array(4 * width * height);
    for (const group of groupsOf(scene.individuals, width * height)) {
        const first = group[0].first_vertex, last = group.at(-1), end = last.first_vertex + last.vertex_count;
        renderer.setRenderTarget(target);
        renderer.render(crowd.points(group, first, height), camera);
        out.forEach((values, which) => {
            renderer.readRenderTargetPixels(
                target, 0, 0, width, Math.ceil((end - first) / width), read, undefined, which);
            for (let v = first; v < end; ++v) values.set(read.subarray(4 * (v - first), 4 * (v - first) + 3), 3 * v);
        });
    }
    target.dispose();
    return { positions: out[0], normals: out[1] };
}
