// The triangles around a pixel's centre as they are seen there: a picture beside the story, which decided exactly.
import {cssOf, ground, idColour} from './colours';
import {fittedCanvas} from './element';
import {rounded} from './numbers';
import type {Affine, Image, Story} from './story';

export type InverseDepthRange = {least: number; greatest: number};  // at far and near

type Point = [x: number, y: number];

function at(f: Affine, x: number, y: number): number { return f[0] * x + f[1] * y + f[2]; }

/// Which triangle is nearest at an offset from the centre, px; -1 for background.
export function seenAt(images: Image[], range: InverseDepthRange, x: number, y: number): number {
    let seen = -1, nearest = -Infinity;
    for (let i = 0; i < images.length; ++i) {
        const [, edges, inverse_depth] = images[i], near = at(inverse_depth, x, y);
        if (near <= nearest || near < range.least || near > range.greatest) continue;
        if (at(edges[0], x, y) < 0 || at(edges[1], x, y) < 0 || at(edges[2], x, y) < 0) continue;
        seen = i;
        nearest = near;
    }
    return seen;
}

/// The triangle's part of the square |x|, |y| <= reach (Sutherland and Hodgman, 1974).
export function clipped(image: Image, reach: number): Point[] {
    let polygon: Point[] = [[-reach, -reach], [reach, -reach], [reach, reach], [-reach, reach]];
    for (const edge of image[1]) {
        const inside: Point[] = [];
        polygon.forEach((p, i) => {
            const q = polygon[(i + 1) % polygon.length], fp = at(edge, ...p), fq = at(edge, ...q);
            if (fp >= 0) inside.push(p);
            if (fp * fq < 0) inside.push([p[0] + fp / (fp - fq) * (q[0] - p[0]), p[1] + fp / (fp - fq) * (q[1] - p[1])]);
        });
        polygon = inside;
    }
    return polygon;
}

/// Sampled coarsely enough to be quick, and enlarged. Returns which images are seen somewhere.
function paintSeen(context: CanvasRenderingContext2D, images: Image[], range: InverseDepthRange, reach: number): Set<number> {
    const side = 180, sampled = document.createElement('canvas');
    sampled.width = sampled.height = side;
    const small = sampled.getContext('2d')!, memory = small.createImageData(side, side);
    const out = new Uint32Array(memory.data.buffer), colours = images.map((image) => idColour(image[0]));
    const anywhere = new Set<number>();
    for (let j = 0; j < side; ++j)
        for (let i = 0; i < side; ++i) {
            const seen = seenAt(images, range, ((i + 0.5) / side * 2 - 1) * reach, ((j + 0.5) / side * 2 - 1) * reach);
            out[j * side + i] = seen < 0 ? ground : colours[seen];
            anywhere.add(seen);
        }
    small.putImageData(memory, 0, 0);
    context.imageSmoothingEnabled = false;
    context.drawImage(sampled, 0, 0, context.canvas.width, context.canvas.height);
    return anywhere;
}

function strokeSquare(context: CanvasRenderingContext2D, middle: number, half: number, dash: number[]): void {
    for (const [colour, wide] of [['rgb(0 0 0 / 75%)', 4], ['#ffffff', 1.6]] as const) {
        context.strokeStyle = colour;
        context.lineWidth = wide;
        context.setLineDash(wide > 2 ? [] : dash);
        context.strokeRect(middle - half, middle - half, 2 * half, 2 * half);
    }
    context.setLineDash([]);
}

function drawEdges(context: CanvasRenderingContext2D, images: Image[], reach: number, wide: number): void {
    const middle = context.canvas.width / 2, scale = middle / reach;
    for (const image of images) {
        const polygon = clipped(image, reach);
        if (polygon.length < 2) continue;
        context.beginPath();
        polygon.forEach(([x, y], i) => i ? context.lineTo(middle + x * scale, middle + y * scale)
                                         : context.moveTo(middle + x * scale, middle + y * scale));
        context.closePath();
        context.strokeStyle = 'rgb(0 0 0 / 55%)';
        context.lineWidth = 2 * wide;
        context.stroke();
        context.strokeStyle = cssOf(idColour(image[0]));
        context.lineWidth = wide;
        context.stroke();
    }
}

function drawCentre(context: CanvasRenderingContext2D): void {
    const middle = context.canvas.width / 2, arm = context.canvas.width / 40;
    for (const [colour, wide] of [['#000000', 4], ['#ffffff', 1.6]] as const) {
        context.strokeStyle = colour;
        context.lineWidth = wide;
        context.beginPath();
        context.moveTo(middle - arm, middle);
        context.lineTo(middle + arm, middle);
        context.moveTo(middle, middle - arm);
        context.lineTo(middle, middle + arm);
        context.stroke();
    }
}

/// A length that is a power of two, about a third of the picture.
function scaleBar(context: CanvasRenderingContext2D, reach: number, scale: number): void {
    const length = 2 ** Math.floor(Math.log2(reach * 0.7)), px = length / reach * context.canvas.width / 2;
    const text = length >= 1 ? `${length} px` : `1/${Math.round(1 / length)} px`;
    const y = context.canvas.height - 9 * scale, x = 9 * scale;
    context.font = `${11 * scale}px system-ui, sans-serif`;
    context.fillStyle = 'rgb(0 0 0 / 65%)';
    context.fillRect(x - 5 * scale, y - 17 * scale, Math.max(px, context.measureText(text).width) + 10 * scale, 22 * scale);
    context.fillStyle = '#ffffff';
    context.fillRect(x, y - scale, px, 2 * scale);
    context.fillText(text, x, y - 5 * scale);
}

/// The square |x|, |y| <= reach px around the pixel's centre, with the square that the answer was judged in.
export function drawSurroundings(canvas: HTMLCanvasElement, story: Story, range: InverseDepthRange, reach: number): void {
    const {context, scale} = fittedCanvas(canvas), middle = canvas.width / 2;
    const seen = paintSeen(context, story.images, range, reach), near = new Set(story.candidates.map((c) => c.id));
    drawEdges(context, story.images.filter((image, i) => seen.has(i) || near.has(image[0])).reverse(), reach, 1.2 * scale);
    if (reach > 0.5) strokeSquare(context, middle, 0.5 / reach * middle, []);
    if (story.eps > 0 && story.eps / reach * middle > 3) strokeSquare(context, middle, story.eps / reach * middle, [5 * scale, 4 * scale]);
    drawCentre(context);
    scaleBar(context, reach, scale);
    canvas.setAttribute('aria-label', `triangles within ${rounded(reach)} px of the centre`);
}
