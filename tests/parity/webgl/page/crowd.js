// The individuals of a scene as objects of three.js, one draw for each group of a mesh.
import * as three from 'three';
import { lightUniforms } from './light.js';
import { fogOf, fragmentText, vertexFragmentText, vertexText } from './shaders.js';
import { atlasOf, rowsOf, textureOf, width } from './textures.js';

function geometryOf(mesh) {
    const geometry = new three.BufferGeometry(), a = mesh.attributes;
    const set = (name, values, size, normalized = false) => {
        if (values) geometry.setAttribute(name, new three.BufferAttribute(values, size, normalized));
    };
    set('position', a.POSITION, 3);
    set('normal', a.NORMAL, 3);
    set('uv', a.TEXCOORD_0, 2);
    set('colour', a.COLOR_0, 4, true);
    for (let k = 0; k < mesh.sets; ++k) {
        set(`joints${k}`, new Uint32Array(a[`JOINTS_${k}`]), 4);
        set(`weights${k}`, a[`WEIGHTS_${k}`], 4);
    }
    return geometry;
}

function trianglesOf(mesh) {
    const geometry = geometryOf(mesh);
    geometry.setIndex(new three.BufferAttribute(mesh.indices, 1));
    let start = 0;
    mesh.groups.forEach(({ lists }, i) => {
        const count = lists.reduce((sum, list) => sum + list.length, 0);
        geometry.addGroup(start, count, i);
        start += count;
    });
    return geometry;
}

export class Crowd {
    constructor(scene) {
        const { lighting, fog } = scene.json, { atlas, palettes } = scene.arrays;
        this.scene = scene;
        this.width = width;
        this.textures = scene.textures.map(textureOf);
        this.shared = {
            palettes: { value: rowsOf(palettes) }, atlas: { value: atlasOf(atlas) }, ...lightUniforms(lighting),
            fogColour: { value: fog?.colour ?? [0, 0, 0] }, fogDensity: { value: fog?.density ?? 0 },
            fogStart: { value: fog?.start ?? 0 }, fogEnd: { value: fog?.end ?? 1 },
        };
        this.meshes = scene.meshes.map((mesh) => ({
            geometry: trianglesOf(mesh), deltas: mesh.targets ? rowsOf(mesh.deltas) : null,
        }));
    }

    // What all uses of a mesh share; `more` is what one use adds.
    material(index, more, uniforms, fragmentShader) {
        const mesh = this.scene.meshes[index], { lighting } = this.scene.json;
        const defines = {
            SETS: mesh.sets, TARGETS: mesh.targets, VERTEX_COUNT: mesh.vertices, WIDTH: width,
            LIGHTS: lighting.lights.length, ...more,
        };
        if (mesh.attributes.COLOR_0) defines.COLOURS = 1;
        if (mesh.inverse) defines.NORMALS_BY_INVERSE = 1;
        if (lighting.enabled && !more.UNLIT) defines.LIT = 1;
        return new three.RawShaderMaterial({
            glslVersion: three.GLSL3, vertexShader: vertexText, fragmentShader, defines,
            uniforms: {
                ...this.shared, deltas: { value: this.meshes[index].deltas }, firstPalette: { value: 0 },
                morphWeights: { value: [] }, ...uniforms,
            },
        });
    }

    // The materials of a mesh, one for each of its groups.
    materials(index) {
        this.meshes[index].materials ??= this.scene.meshes[index].groups.map((group) => {
            const { texture, doubleSided, unlit, emission } = this.scene.materials[group.material];
            const { fog, lighting } = this.scene.json;
            const more = { ZONES: group.zones.length };
            if (doubleSided) more.DOUBLE_SIDED = 1;
            if (unlit) more.UNLIT = 1;
            if (fog) more.FOG = fogOf[fog.mode];
            const material = this.material(index, more, {
                texels: { value: this.textures[texture] }, keys: { value: group.zones.map((zone) => zone + 1) },
                row: { value: 0 }, actor: { value: 0 }, emission: { value: lighting.enabled ? emission : [0, 0, 0] },
            }, fragmentText);
            material.side = doubleSided ? three.DoubleSide : three.FrontSide;
            return material;
        });
        return this.meshes[index].materials;
    }

    // The uniforms that are one individual's, set before each of its draws.
    follows(object, individual, values) {
        const { first_palette, first_weight, mesh } = individual, { morph_weights } = this.scene.arrays;
        const weights = this.scene.meshes[mesh].weights.map((at) => morph_weights[first_weight + at]);
        object.frustumCulled = object.matrixAutoUpdate = object.matrixWorldAutoUpdate = false;
        object.onBeforeRender = (renderer, all, camera, geometry, material) => {
            const own = { firstPalette: first_palette, morphWeights: weights, ...values };
            for (const [name, value] of Object.entries(own)) material.uniforms[name].value = value;
            material.uniformsNeedUpdate = true;
        };
        return object;
    }

    // All individuals, in the order of the draw list. three.js finds those that are mirrored by the determinant.
    people() {
        const { individuals, arrays } = this.scene, all = new three.Scene();
        for (const individual of individuals.toSorted((a, b) => a.draw_order - b.draw_order)) {
            const { actor, mesh, row } = individual;
            const person = new three.Mesh(this.meshes[mesh].geometry, this.materials(mesh));
            person.matrixWorld.set(...arrays.model_view.subarray(16 * row, 16 * row + 16));
            all.add(this.follows(person, individual, { row, actor }));
        }
        return all;
    }

    // The vertices of some individuals as points, each at a pixel of its own: `first` is that of the first vertex.
    points(individuals, first, height) {
        const all = new three.Scene();
        for (const individual of individuals) {
            const known = this.meshes[individual.mesh];
            known.points ??= geometryOf(this.scene.meshes[individual.mesh]);
            known.pointMaterial ??= this.material(
                individual.mesh, { VERTICES: 1, HEIGHT: height }, { firstVertex: { value: 0 } }, vertexFragmentText);
            const points = new three.Points(known.points, known.pointMaterial);
            all.add(this.follows(points, individual, { firstVertex: individual.first_vertex - first }));
        }
        return all;
    }
}
