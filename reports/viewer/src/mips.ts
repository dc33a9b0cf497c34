// Minification that never loses the worst: each level holds the maxima of 2 x 2 blocks of the one below.

export class MaxChain {
    private readonly levels: {values: Uint8Array; width: number; height: number}[];

    constructor(values: Uint8Array, width: number, height: number) {
        this.levels = [{values, width, height}];
        while (width > 1 || height > 1) {
            const below = this.levels[this.levels.length - 1];
            width = (below.width + 1) >> 1;
            height = (below.height + 1) >> 1;
            this.levels.push({values: halved(below.values, below.width, below.height), width, height});
        }
    }

    /// The maximum over the pixels [left, right) x [top, bottom), at least one; from the level whose blocks are no
    /// larger than `size`, so that it may take in up to one block beyond the edge.
    most(left: number, top: number, right: number, bottom: number, size: number): number {
        const shift = Math.min(this.levels.length - 1, Math.max(0, Math.floor(Math.log2(size))));
        const {values, width, height} = this.levels[shift];
        const endX = Math.min(width, ((right - 1) >> shift) + 1), endY = Math.min(height, ((bottom - 1) >> shift) + 1);
        let most = 0;
        for (let y = top >> shift; y < endY; ++y)
            for (let x = left >> shift, row = y * width; x < endX; ++x) {
                const value = values[row + x];
                if (value > most) most = value;
            }
        return most;
    }
}

function halved(values: Uint8Array, width: number, height: number): Uint8Array {
    const w = (width + 1) >> 1, h = (height + 1) >> 1, out = new Uint8Array(w * h);
    for (let y = 0; y < h; ++y) {
        const upper = 2 * y * width, lower = 2 * y + 1 < height ? upper + width : upper;
        for (let x = 0; x < w; ++x) {
            const left = 2 * x, right = left + 1 < width ? left + 1 : left;
            out[y * w + x] = Math.max(values[upper + left], values[upper + right], values[lower + left],
                                      values[lower + right]);
        }
    }
    return out;
}
