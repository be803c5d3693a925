// NumPy's format, version 1.0: the arrays of a scene and of a result.
const kinds = { '<f4': Float32Array, '<u4': Uint32Array, '<u2': Uint16Array, '|u1': Uint8Array };

// The values of a file, with its shape as a property.
export function readArray(buffer, name) {
    const head = new DataView(buffer).getUint16(8, true);
    const text = new TextDecoder('latin1').decode(new Uint8Array(buffer, 10, head));
    const descr = /'descr': *'([^']+)'/.exec(text)?.[1];
    if (!kinds[descr]) throw new Error(`${name} holds ${descr}, which a scene has nowhere`);
    const values = new kinds[descr](buffer.slice(10 + head));
    values.shape = /'shape': *\(([^)]*)\)/.exec(text)[1].split(',').filter((n) => n.trim()).map(Number);
    return values;
}

export function writeArray(values, shape) {
    const descr = Object.keys(kinds).find((key) => values instanceof kinds[key]);
    const dict = `{'descr': '${descr}', 'fortran_order': False, 'shape': (${shape.join(', ')},), }`;
    const head = 64 * Math.ceil((10 + dict.length + 1) / 64) - 10;
    const file = new Uint8Array(10 + head + values.byteLength);
    file.set([0x93, 0x4e, 0x55, 0x4d, 0x50, 0x59, 1, 0, head & 255, head >> 8]);
    file.set(new TextEncoder().encode(dict.padEnd(head - 1) + '\n'), 10);
    file.set(new Uint8Array(values.buffer, values.byteOffset, values.byteLength), 10 + head);
    return file;
}
