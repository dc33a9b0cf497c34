// Findings that are one thing: a class that arises between one pair of triangles.
import type {Planes} from './planes';

export type Cluster = {
    class: number; candidate: number; reference: number; count: number; worst: number;  // error / bound, or NaN
    left: number; top: number; right: number; bottom: number;  // inclusive
    pixel: number;  // its worst, with a story where one of them has one
};

/// Severest class first, then the larger.
export function clustersOf(planes: Planes, match: Uint8Array | null): Cluster[] {
    const f = planes.findings, found = new Map<string, Cluster>();
    for (let i = 0; f && i < f.count; ++i) {
        const pixel = f.pixel[i], kind = planes.classes[pixel];
        if (match && !match[pixel]) continue;
        const low = Math.min(f.candidate[i], f.reference[i]), high = Math.max(f.candidate[i], f.reference[i]);
        const key = `${kind} ${low} ${high}`, x = pixel % planes.width, y = (pixel - x) / planes.width;
        const known = found.get(key);
        if (known) grow(known, planes, x, y, f.error[i]);
        else found.set(key, {class: kind, candidate: f.candidate[i], reference: f.reference[i], count: 1,
                             worst: f.error[i], left: x, right: x, top: y, bottom: y, pixel});
    }
    return [...found.values()].sort((a, b) => b.class - a.class || b.count - a.count || a.pixel - b.pixel);
}

function grow(cluster: Cluster, planes: Planes, x: number, y: number, error: number): void {
    const pixel = y * planes.width + x, told = planes.story(pixel) !== undefined;
    const isWorse = !(cluster.worst >= error), wasTold = planes.story(cluster.pixel) !== undefined;
    if (told !== wasTold ? told : isWorse) cluster.pixel = pixel;
    if (isWorse && !Number.isNaN(error)) cluster.worst = error;
    cluster.count += 1;
    cluster.left = Math.min(cluster.left, x);
    cluster.right = Math.max(cluster.right, x);
    cluster.top = Math.min(cluster.top, y);
    cluster.bottom = Math.max(cluster.bottom, y);
}
