// One pixel's story, as reports/planes/stories.cpp writes it.

export type Admissibility = {word: string; admissible: boolean; exact: boolean};
export type Affine = [number, number, number];  // value(x, y) = a x + b y + c, offsets from the centre in px
export type Image = [id: number, edges: [Affine, Affine, Affine], inverse_depth: Affine];
export type Candidate = {
    id: number; edges: (number | string)[]; depth: (number | string)[]; admissibility: Admissibility;
};
export type Story = {
    x: number; y: number; class: number; text: string; eps: number; reference_eps: number;
    depth: (number | string)[]; error: number | string; background: Admissibility; admissibility?: Admissibility;
    reference_admissibility?: Admissibility; candidates: Candidate[]; images: Image[];
};

export type TriangleRange = [first: number, count: number, node: string, mesh: string, primitive: number];

/// The range that holds an id, or none. Ranges are in triangle order.
export function rangeOf(ranges: TriangleRange[], id: number): TriangleRange | undefined {
    let low = 0, high = ranges.length;
    while (low < high) {
        const middle = (low + high) >> 1;
        if (ranges[middle][0] + ranges[middle][1] <= id) low = middle + 1;
        else high = middle;
    }
    const found = ranges[low];
    return found && id >= found[0] ? found : undefined;
}

/// "Wheel · Spokes · 0", for narrow places; empty for an id of no range.
export function shortNameOf(ranges: TriangleRange[], id: number): string {
    const range = rangeOf(ranges, id);
    return range ? `${range[2] || 'unnamed'} · ${range[3] || 'unnamed'} · ${range[4]}` : '';
}

/// "node Wheel, mesh Spokes, primitive 0"; empty for an id of no range.
export function nameOf(ranges: TriangleRange[], id: number): string {
    const range = rangeOf(ranges, id);
    if (!range) return '';
    return `node ${range[2] || 'unnamed'}, mesh ${range[3] || 'unnamed'}, primitive ${range[4]}`;
}
