// From one telling pixel to the next.
import type {Planes} from './planes';

export type Step = {pixel: number; wrapped: boolean} | null;

/// In raster order, the next pixel (direction 1) or the one before (-1) whose class is at least `from`.
export function nextPixel(planes: Planes, from: number, start: number, direction: 1 | -1,
                          match: Uint8Array | null): Step {
    const classes = planes.classes, count = classes.length;
    let at = start < 0 ? (direction > 0 ? -1 : count) : start;
    for (let i = 0; i < count; ++i) {
        at += direction;
        if (at < 0) at = count - 1;
        if (at >= count) at = 0;
        if (classes[at] >= from && (!match || match[at]))
            return {pixel: at, wrapped: start >= 0 && (direction > 0 ? at <= start : at >= start)};
    }
    return null;
}

/// Pixels in order of severity: class, then error / bound, then raster order.
export function bySeverity(planes: Planes): number[] {
    const f = planes.findings;
    if (!f) return [];
    const error = (row: number) => Number.isNaN(f.error[row]) ? -1 : f.error[row];
    return Array.from({length: f.count}, (_, row) => row)
        .sort((a, b) => planes.classes[f.pixel[b]] - planes.classes[f.pixel[a]] || error(b) - error(a) || f.pixel[a] - f.pixel[b])
        .map((row) => f.pixel[row]);
}
