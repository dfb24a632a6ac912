// SPDX-License-Identifier: MIT
// Reads the PNG files that Plumbago writes, 8 bits a channel without interlace, as red, green, blue and alpha [PNG].
import zlib from 'node:zlib';

// Adds what the filter of a row took away: the byte to the left, above, both, or the nearest of three to left + above - above left.
function unfilter(kind, row, above, step) {
    for (let i = 0; i < row.length; i++) {
        const a = i >= step ? row[i - step] : 0, b = above[i], c = i >= step ? above[i - step] : 0;
        const p = Math.abs(b - c), q = Math.abs(a - c), r = Math.abs(a + b - 2 * c);
        row[i] += [0, a, b, (a + b) >> 1, p <= q && p <= r ? a : q <= r ? b : c][kind];
    }
}

export function readPng(file) {
    const parts = [];
    let width, height, channels;
    for (let at = 8; at < file.length; at += 12 + file.readUInt32BE(at)) {
        const kind = file.toString('latin1', at + 4, at + 8), data = file.subarray(at + 8, at + 8 + file.readUInt32BE(at));
        if (kind === 'IHDR') {
            [width, height] = [data.readUInt32BE(0), data.readUInt32BE(4)];
            channels = { 0: 1, 2: 3, 4: 2, 6: 4 }[data[9]];
            if (data[8] !== 8 || !channels || data[12])
                throw new Error('another kind of PNG');
        } else if (kind === 'IDAT')
            parts.push(data);
    }
    const rows = zlib.inflateSync(Buffer.concat(parts)), stride = width * channels;
    const pixels = new Uint8ClampedArray(width * height * 4);
    let above = new Uint8Array(stride);
    for (let y = 0; y < height; y++) {
        const start = y * (stride + 1), row = rows.subarray(start + 1, start + 1 + stride);
        unfilter(rows[start], row, above, channels);
        above = row;
        for (let x = 0; x < width; x++)
            for (let k = 0; k < 4; k++)
                pixels[(y * width + x) * 4 + k] = k === 3 ? (channels % 2 ? 255 : row[x * channels + channels - 1]) : row[x * channels + (channels < 3 ? 0 : k)];
    }
    return { width, height, pixels };
}
