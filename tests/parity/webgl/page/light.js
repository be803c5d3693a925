// The lights of a scene as uniforms.

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
