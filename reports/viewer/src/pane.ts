// One pane: a canvas that shows a layer as the shared look has it.
import {cssOf} from './colours';
import {element, fittedCanvas, replaceChildren} from './element';
import {chainOf, difference, selected} from './layers';
import type {ColourKey, Layer, Painted, Severity} from './layers';
import type {Look, Size} from './look';
import type {MaxChain} from './mips';
import type {Planes} from './planes';
import {fillNearest, fillWorst} from './raster';
import type {Frame, Selection} from './raster';

const gridFrom = 10, labelsFrom = 30, outlinesFrom = 4;

export type Wipe = {layer: Painted; at: number};  // the other layer right of this part of the pane, 0 to 1

export class Pane {
    readonly canvas = element('canvas', {tabindex: 0, role: 'img'});
    readonly choice = element('select', {'aria-label': 'layer of this pane'});
    private readonly value = element('output', {class: 'pane-value'});
    private readonly key = element('span', {class: 'colour-key'});
    private readonly note = element('div', {class: 'pane-note', hidden: true});
    readonly root = element('div', {class: 'pane'},
        element('div', {class: 'pane-head'}, this.choice, this.key, this.value), this.canvas, this.note);
    private painted: Painted | null = null;
    private planes: Planes | null = null;
    private chain: {of: Uint8Array; made: MaxChain} | null = null;
    private masked: {of: Uint8Array; match: Uint8Array; made: Severity} | null = null;
    private wanted = 0;
    layer: Layer | null = null;

    /// Shows the layer once its planes are decoded; the one that was asked for last wins.
    async show(layer: Layer, planes: Planes): Promise<void> {
        const ticket = ++this.wanted;
        this.layer = layer;
        this.choice.value = layer.id;
        this.choice.title = layer.title;
        this.canvas.setAttribute('aria-label', layer.title);
        this.tellColours(layer.key);
        await planes.load(layer.needs);
        if (ticket !== this.wanted) return;
        if (layer.needs.some((name) => !planes.has(name))) {
            this.planes = planes;
            this.painted = null;
            return this.say(`${layer.title} is not in this page, to keep it small. Drop this view's planes.zvp ` +
                            'here, or press O to open it.');
        }
        const painted = await layer.paint(planes);
        if (ticket !== this.wanted) return;
        this.say('');
        this.planes = planes;
        this.painted = painted;
    }

    private tellColours(key: ColourKey | undefined): void {
        replaceChildren(this.key, ...key ? [key.from,
            element('i', {style: `background:linear-gradient(to right, ${key.colours.map(cssOf).join(', ')})`}), key.to] : []);
    }

    private say(text: string): void {
        this.note.textContent = text;
        this.note.hidden = !text;
    }

    get current(): Painted | null { return this.painted; }
    get size(): Size { return {width: this.canvas.clientWidth || 1, height: this.canvas.clientHeight || 1}; }

    /// What another pane shows in place of the own layer, while it is asked for.
    draw(look: Look, selection: Selection | null, instead: Painted | null, wipe: Wipe | null): void {
        const painted = instead ?? this.painted, planes = this.planes;
        const {context, scale} = fittedCanvas(this.canvas);
        const width = this.canvas.width, height = this.canvas.height;
        if (!painted || !planes) {
            context.clearRect(0, 0, width, height);
            this.value.textContent = '';
            return;
        }
        const perPixel = look.zoom * scale;
        const frame = {width, height, left: look.x - width / 2 / perPixel, top: look.y - height / 2 / perPixel, perPixel};
        const image = context.createImageData(width, height), out = new Uint32Array(image.data.buffer);
        this.fill(out, frame, planes, painted, selection, scale);
        if (wipe) this.wipe(out, frame, planes, wipe, selection, scale);
        context.putImageData(image, 0, 0);
        this.overlay(context, frame, painted, look, wipe ? null : scale);
        if (wipe) drawDivider(context, Math.round(wipe.at * width), height);
        this.value.textContent = this.value.title = look.hasCross ? painted.text(look.cross) : '';
    }

    private fill(out: Uint32Array, frame: Frame, planes: Planes, painted: Painted, selection: Selection | null,
                 scale: number): void {
        if (!painted.severity || frame.perPixel >= 1) return fillNearest(out, frame, planes, painted, selection);
        const severity = selection ? this.maskedSeverity(painted.severity, selection) : painted.severity;
        fillWorst(out, frame, planes, severity, this.chainFor(severity, planes), scale);
    }

    private maskedSeverity(severity: Severity, selection: Selection): Severity {
        if (this.masked?.of !== severity.values || this.masked.match !== selection.match)
            this.masked = {of: severity.values, match: selection.match, made: selected(severity, selection.match)};
        return this.masked.made;
    }

    private chainFor(severity: Severity, planes: Planes): MaxChain {
        if (this.chain?.of !== severity.values)
            this.chain = {of: severity.values, made: chainOf(severity, planes)};
        return this.chain.made;
    }

    private wipe(out: Uint32Array, frame: Frame, planes: Planes, wipe: Wipe, selection: Selection | null,
                 scale: number): void {
        const other = new Uint32Array(out.length), from = Math.round(wipe.at * frame.width);
        this.fill(other, frame, planes, wipe.layer, selection, scale);
        for (let row = 0; row < out.length; row += frame.width)
            out.set(other.subarray(row + from, row + frame.width), row + from);
    }

    /// `labels` is their scale; two layers side by side have none.
    private overlay(context: CanvasRenderingContext2D, frame: Frame, painted: Painted, look: Look,
                    labels: number | null): void {
        if (look.zoom >= gridFrom) drawGrid(context, frame, this.planes!, look.zoom);
        if (painted.outlines && look.zoom >= outlinesFrom) drawOutlines(context, frame, this.planes!, painted.outlines);
        const hasLabels = labels !== null && look.zoom >= labelsFrom, scale = frame.perPixel / look.zoom;
        if (hasLabels) drawLabels(context, frame, this.planes!, painted, labels);
        if (look.hasCross) drawCross(context, frame, look, scale, hasLabels ? 'square' : 'lines');
    }

    differenceFrom(other: Pane): Painted | null {
        return this.painted && other.painted ? difference(this.painted, other.painted) : null;
    }
}

type Shown = {left: number; top: number; right: number; bottom: number};

/// Pixels of the view that the frame shows.
function shown(frame: Frame, planes: Planes): Shown {
    return {
        left: Math.max(0, Math.floor(frame.left)), top: Math.max(0, Math.floor(frame.top)),
        right: Math.min(planes.width, Math.ceil(frame.left + frame.width / frame.perPixel)),
        bottom: Math.min(planes.height, Math.ceil(frame.top + frame.height / frame.perPixel)),
    };
}

function atX(frame: Frame, x: number): number { return Math.round((x - frame.left) * frame.perPixel); }
function atY(frame: Frame, y: number): number { return Math.round((y - frame.top) * frame.perPixel); }

function drawGrid(context: CanvasRenderingContext2D, frame: Frame, planes: Planes, zoom: number): void {
    const {left, top, right, bottom} = shown(frame, planes);
    context.fillStyle = `rgb(128 128 128 / ${Math.min(0.45, 0.12 + (zoom - gridFrom) / 100)})`;
    for (let x = left; x <= right; ++x)
        context.fillRect(atX(frame, x), atY(frame, top), 1, atY(frame, bottom) - atY(frame, top));
    for (let y = top; y <= bottom; ++y)
        context.fillRect(atX(frame, left), atY(frame, y), atX(frame, right) - atX(frame, left), 1);
}

function drawOutlines(context: CanvasRenderingContext2D, frame: Frame, planes: Planes, ids: Uint32Array): void {
    const {left, top, right, bottom} = shown(frame, planes), wide = Math.max(1, Math.round(frame.perPixel / 12));
    context.fillStyle = '#b8c4d0';
    for (let y = top; y < bottom; ++y)
        for (let x = left; x < right; ++x) {
            const p = y * planes.width + x;
            if (x + 1 < planes.width && ids[p] !== ids[p + 1])
                context.fillRect(atX(frame, x + 1), atY(frame, y), wide, Math.ceil(frame.perPixel));
            if (y + 1 < planes.height && ids[p] !== ids[p + planes.width])
                context.fillRect(atX(frame, x), atY(frame, y + 1), Math.ceil(frame.perPixel), wide);
        }
}

function isBright(colour: number): boolean {
    return 299 * (colour & 255) + 587 * (colour >>> 8 & 255) + 114 * (colour >>> 16 & 255) > 118_000;
}

function drawLabels(context: CanvasRenderingContext2D, frame: Frame, planes: Planes, painted: Painted,
                    scale: number): void {
    const {left, top, right, bottom} = shown(frame, planes);
    context.textAlign = 'center';
    context.textBaseline = 'middle';
    for (let y = top; y < bottom; ++y)
        for (let x = left; x < right; ++x) {
            const p = y * planes.width + x, text = painted.label(p);
            const size = Math.min(frame.perPixel * 0.36, 1.5 * frame.perPixel / text.length);
            if (!text || size < 6 * scale) continue;
            context.font = `${Math.min(size, 16 * scale)}px ui-monospace, "DejaVu Sans Mono", monospace`;
            context.fillStyle = isBright(painted.colour(p)) ? '#101216' : '#f2f4f6';
            context.fillText(text, (x + 0.5 - frame.left) * frame.perPixel, (y + 0.5 - frame.top) * frame.perPixel);
        }
}

/// 'square': without the lines, which would run through the pixels' numbers.
function drawCross(context: CanvasRenderingContext2D, frame: Frame, look: Look, scale: number, shape: 'square' | 'lines'): void {
    const side = Math.max(frame.perPixel, 7 * scale);
    const x = (look.crossX + 0.5 - frame.left) * frame.perPixel, y = (look.crossY + 0.5 - frame.top) * frame.perPixel;
    const half = side / 2 + scale;
    for (const [colour, wide] of [['rgb(0 0 0 / 70%)', 3 * scale], ['#ffffff', scale]] as const) {
        context.strokeStyle = colour;
        context.lineWidth = wide;
        context.strokeRect(x - half, y - half, 2 * half, 2 * half);
        if (shape === 'square') continue;
        context.beginPath();
        for (const [fromX, fromY, toX, toY] of [[x, 0, x, y - half], [x, y + half, x, frame.height],
                                                [0, y, x - half, y], [x + half, y, frame.width, y]]) {
            context.moveTo(fromX, fromY);
            context.lineTo(toX, toY);
        }
        context.globalAlpha = 0.45;
        context.stroke();
        context.globalAlpha = 1;
    }
}

function drawDivider(context: CanvasRenderingContext2D, x: number, height: number): void {
    context.fillStyle = cssOf(0xff42e4f0);
    context.fillRect(x - 1, 0, 2, height);
}
