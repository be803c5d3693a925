// The lights of a scene, and how much light a vertex can get from them.

// The most that any normal gets in a channel. Lights in directions add most where the normal is the direction of the
// sum of those that it sees, so all subsets are tried; one at a place may stand in any direction.
function mostOf({ ambient, lights }, channel) {
    let always = ambient[channel];
    const directions = [];
    for (const light of lights) {
        const [x, y, z, w] = light.position_eye, length = Math.hypot(x, y, z);
        always += light.ambient[channel];
        if (w === 0) directions.push([x, y, z].map((c) => (c / length) * light.diffuse[channel]));
        else always += light.diffuse[channel];
    }
    let longest = 0;
    for (let set = 1; set < 1 << directions.length; ++set) {
        const sum = [0, 0, 0];
        directions.forEach((d, i) => { if (set >> i & 1) d.forEach((c, k) => { sum[k] += c; }); });
        longest = Math.max(longest, Math.hypot(...sum));
    }
    return always + longest;
}

// OpenGL 1.1 limits light times colour to 1 at vertices. Here the colour is known at pixels only, so the vertex shader
// passes on the light limited to each of a few values from 1 to the most there is, and the fragment shader interpolates
// between them. One value is enough where light never exceeds 1.
export function knotsOf(lighting) {
    const most = lighting.enabled ? Math.max(...[0, 1, 2].map((channel) => mostOf(lighting, channel))) : 1;
    const count = most > 1 ? 4 : 1;
    return { count, step: count > 1 ? (most - 1) / (count - 1) : 1 };
}

// A spot's direction and the cosine of its cutoff; -2 where there is none.
function coneOf(spot) {
    if (!spot) return [0, 0, 0, -2];
    const length = Math.hypot(...spot.direction_eye);
    return [...spot.direction_eye.map((c) => c / length), Math.cos(spot.cutoff_deg * Math.PI / 180)];
}

export function lightUniforms({ ambient, lights }) {
    const all = (name) => ({ value: lights.flatMap((light) => light[name]) });
    return {
        sceneAmbient: { value: ambient }, lightPosition: all('position_eye'), lightAmbient: all('ambient'),
        lightDiffuse: all('diffuse'), lightAttenuation: all('attenuation'),
        lightCone: { value: lights.flatMap(({ spot }) => coneOf(spot)) },
        lightExponent: { value: lights.map(({ spot }) => spot?.exponent ?? 0) },
    };
}
