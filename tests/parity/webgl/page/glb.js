// scene.glb: the part of glTF 2.0 that docs/parity.md promises. A general loader will not do: that of three.js drops
// JOINTS_1, makes the sum of four weights 1, and takes textures for sRGB.
const components = { 5121: Uint8Array, 5123: Uint16Array, 5125: Uint32Array, 5126: Float32Array };
const widths = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 };

class Glb {
    constructor(buffer) {
        const length = new DataView(buffer).getUint32(12, true);
        this.json = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 20, length)));
        this.bytes = buffer.slice(28 + length);
    }
    view(index) {
        const { byteOffset = 0, byteLength } = this.json.bufferViews[index];
        return this.bytes.slice(byteOffset, byteOffset + byteLength);
    }
    accessor(index) {
        const { bufferView, byteOffset = 0, componentType, type, count } = this.json.accessors[index];
        return new components[componentType](this.view(bufferView), byteOffset, widths[type] * count);
    }
    // A morph target's changes of some vertices, as changes of all.
    sparse(index, out, offset) {
        const { sparse } = this.json.accessors[index];
        if (!sparse) return;
        const vertices = new components[sparse.indices.componentType](this.view(sparse.indices.bufferView));
        const values = new Float32Array(this.view(sparse.values.bufferView));
        for (let i = 0; i < sparse.count; ++i) out.set(values.subarray(3 * i, 3 * i + 3), offset + 8 * vertices[i]);
    }
}

// Bits as they are: alpha is the key of a zone, and premultiplied colours would be lost where it is small.
const bits = { premultiplyAlpha: 'none', colorSpaceConversion: 'none', imageOrientation: 'none' };

async function textureOf(glb, { source, sampler }) {
    const png = new Blob([glb.view(glb.json.images[source].bufferView)], { type: 'image/png' });
    return { image: await createImageBitmap(png, bits), ...glb.json.samplers[sampler] };
}

// Zones whose colours one draw passes on. WebGL 2 has at least 15 varyings; both sides of a zone take two.
const mostZones = 6;

// What is drawn at once: primitives in their order, as long as they are of one material and show few zones. One that
// shows more is drawn several times, each time without the fragments of other zones.
function groupsOf(glb, primitives) {
    const groups = [];
    for (const { material, indices, extras } of primitives) {
        const list = glb.accessor(indices), zones = extras.zones ?? [extras.zone], last = groups.at(-1);
        const union = [...new Set([...last?.zones ?? [], ...zones])];
        if (last?.material === material && union.length <= mostZones) {
            last.zones = union;
            last.lists.push(list);
        } else for (let first = 0; first < zones.length; first += mostZones)
            groups.push({ material, zones: zones.slice(first, first + mostZones), lists: [list] });
    }
    return groups;
}

function meshOf(glb, { primitives, extras }) {
    const first = primitives[0], mesh = { attributes: {}, sets: 0, targets: 0 };
    for (const [name, index] of Object.entries(first.attributes)) mesh.attributes[name] = glb.accessor(index);
    while (mesh.attributes[`JOINTS_${mesh.sets}`]) ++mesh.sets;
    mesh.vertices = mesh.attributes.POSITION.length / 3;
    mesh.groups = groupsOf(glb, primitives);
    mesh.indices = Uint32Array.from(mesh.groups.flatMap((group) => group.lists.flatMap((list) => [...list])));
    mesh.targets = first.targets?.length ?? 0;
    mesh.weights = extras?.morph_weights ?? [];
    // Two texels of four floats for each vertex of each target: what it adds to the position and to the normal.
    mesh.deltas = new Float32Array(8 * mesh.vertices * mesh.targets);
    first.targets?.forEach((target, j) => {
        glb.sparse(target.POSITION, mesh.deltas, 8 * mesh.vertices * j);
        glb.sparse(target.NORMAL, mesh.deltas, 8 * mesh.vertices * j + 4);
    });
    return mesh;
}

export async function readGlb(buffer) {
    const glb = new Glb(buffer);
    return {
        textures: await Promise.all(glb.json.textures.map((texture) => textureOf(glb, texture))),
        materials: glb.json.materials.map((material) => ({
            texture: material.pbrMetallicRoughness.baseColorTexture.index,
            doubleSided: material.doubleSided ?? false,
            unlit: material.extensions?.KHR_materials_unlit !== undefined,
            emission: material.emissiveFactor ?? [0, 0, 0],
        })),
        meshes: glb.json.meshes.map((mesh) => meshOf(glb, mesh)),
    };
}
