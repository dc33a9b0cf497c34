// A pixel on its texture: the parallelogram of its square, its ellipse, and the weights of texels under them.
import {encoded} from './colours';
import {fittedCanvas} from './element';
import type {Inspection, Shape, TextureWindow} from './filter_view';

type Rgb = [number, number, number];

function textureColour(window: TextureWindow, cell: number): Rgb {
    return [0, 1, 2].map((c) => encoded(window.colour[3 * cell + c])) as Rgb;
}

/// Orange for positive weights, blue for negative ones; black for none. By the root, so that small ones are seen.
function weightColour(weight: number, most: number): Rgb {
    const t = Math.sqrt(Math.abs(weight) / (most || 1));
    const full: Rgb = weight >= 0 ? [255, 176, 64] : [86, 180, 255];
    return full.map((c) => Math.round(14 + (c - 14) * t)) as Rgb;
}

export type Shown = 'texture' | 'read' | 'exact';

/// Texels to canvas.
class Placement {
    private readonly side: number;
    constructor(private readonly window: TextureWindow, width: number, height: number) {
        this.side = Math.min(width / window.width, height / window.height);
    }
    get cell(): number { return this.side; }
    x(u: number): number { return (u - this.window.column) / this.window.block * this.side; }
    y(v: number): number { return (v - this.window.row) / this.window.block * this.side; }
    length(texels: number): number { return texels / this.window.block * this.side; }
}

function fillCells(context: CanvasRenderingContext2D, window: TextureWindow, shown: Shown, place: Placement): void {
    const most = shown === 'texture' ? 0 : Math.max(...window[shown].map(Math.abs), 0);
    for (let row = 0; row < window.height; ++row)
        for (let column = 0; column < window.width; ++column) {
            const cell = row * window.width + column;
            const colour = shown === 'texture' ? textureColour(window, cell) : weightColour(window[shown][cell] ?? 0, most);
            context.fillStyle = `rgb(${colour.join(' ')})`;
            const left = Math.round(column * place.cell), top = Math.round(row * place.cell);
            context.fillRect(left, top, Math.round((column + 1) * place.cell) - left, Math.round((row + 1) * place.cell) - top);
        }
}

function strokeTwice(context: CanvasRenderingContext2D, scale: number, colour: string, path: () => void): void {
    for (const [style, wide] of [['rgb(0 0 0 / 75%)', 3.5], [colour, 1.5]] as const) {
        context.strokeStyle = style;
        context.lineWidth = wide * scale;
        context.beginPath();
        path();
        context.stroke();
    }
}

function dot(context: CanvasRenderingContext2D, place: Placement, at: (number | null)[], colour: string, radius: number): void {
    if (at[0] === null || at[1] === null) return;
    context.beginPath();
    context.arc(place.x(at[0]), place.y(at[1]), radius, 0, 2 * Math.PI);
    context.fillStyle = colour;
    context.strokeStyle = '#000000';
    context.lineWidth = 1;
    context.fill();
    context.stroke();
}

/// `shape`: of the weights that are shown; its centroid is a dot beside the pixel's.
export function drawFootprint(canvas: HTMLCanvasElement, one: Inspection, shown: Shown, shape: Shape | undefined): void {
    const {context, scale} = fittedCanvas(canvas), {window} = one;
    if (!window) return;
    const place = new Placement(window, canvas.width, canvas.height);
    fillCells(context, window, shown, place);
    strokeTwice(context, scale, '#ffffff', () => {
        one.corners.forEach(([u, v], i) => i ? context.lineTo(place.x(u), place.y(v)) : context.moveTo(place.x(u), place.y(v)));
        context.closePath();
    });
    strokeTwice(context, scale, '#42e4f0', () => context.ellipse(place.x(one.centre[0]), place.y(one.centre[1]),
        place.length(one.major / 2), place.length(one.minor / 2), Math.atan2(one.direction[1], one.direction[0]), 0, 2 * Math.PI));
    dot(context, place, one.centre, '#ffffff', 2.5 * scale);
    if (shape) dot(context, place, shape.centroid, '#ff5a36', 3 * scale);
    canvas.setAttribute('aria-label', `${shown} around texel ${one.centre.map(Math.floor).join(', ')}; a cell is ${window.block} × ${window.block} texels`);
}

/// Standard deviation along a unit direction, texels.
export function spreadAlong(shape: Shape, [u, v]: [number, number]): number {
    const [uu, uv, vv] = shape.covariance.map((c) => c ?? NaN);
    return Math.sqrt(Math.max(0, u * u * uu + 2 * u * v * uv + v * v * vv));
}
