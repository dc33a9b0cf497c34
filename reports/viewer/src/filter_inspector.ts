// All that is known of a pixel of a filter study.
import type {Channels} from './channels';
import {element, replaceChildren} from './element';
import {claimTable} from './filter_claim';
import type {Claim} from './filter_claim';
import {drawFootprint, spreadAlong} from './filter_drawing';
import type {Shown} from './filter_drawing';
import {signed} from './filter_layers';
import type {FilterChoice} from './filter_layers';
import {asFloats} from './filter_view';
import type {FilterView, Inspection, Shape} from './filter_view';
import {counted, grouped, rounded} from './numbers';
import type {Planes} from './planes';
import type {PixelInspector} from './subject';

/// Where its buttons lead.
export type FilterWays = {toStory(): void; toOutside(): void};

export class FilterInspector implements PixelInspector {
    readonly root = element('aside', {class: 'inspector', 'aria-label': 'pixel', 'aria-live': 'polite'});
    private shown = '';
    private place = '';  // method and pixel that were asked for last

    constructor(private readonly choice: FilterChoice, private readonly viewOf: (planes: Planes) => FilterView | null,
                private readonly copy: (text: string, what: string) => void,
                private readonly linkHere: () => string, private readonly walk: FilterWays) {}

    show(planes: Planes | null, x: number, y: number): void {
        const view = planes && this.viewOf(planes);
        if (!view || x < 0) return this.showNothing();
        const {method} = this.choice, claim = view.header.claims?.[method], read = claim?.method ?? method;
        this.askForRow(view, planes, read, x, y);
        const pixel = y * view.planes.width + x, own = view.inspection(pixel, method);
        const claimed = claim && view.inspection(pixel, read), one = claimed ?? own;
        replaceChildren(this.root, element('h2', {}, `Pixel ${x}, ${y}`),
            element('p', {class: 'fine regions'}, view.regionsAt(pixel).slice(1).join(' · ')),
            one && element('p', {class: 'why'}, claimed ? `${method} claims to be ${one.method}, which ${one.why}.` : `${method} ${one.why}.`),
            this.values(view, pixel), claim && this.permitted(view, claim, pixel), this.facts(view, pixel),
            one ? inspectionOf(one) : this.noInspection(view, read, x, y), this.command(view, x, y, read));
        if (one) draw(this.root, one);
        const key = `${view.header.scene}/${view.header.view}/${x}/${y}`;
        if (key !== this.shown) this.root.scrollTop = 0;
        this.shown = key;
    }

    /// Shows the pixel again once its row is there.
    private askForRow(view: FilterView, planes: Planes, method: string, x: number, y: number): void {
        const place = `${method}/${x}/${y}`;
        this.place = place;
        if (view.inspection(y * view.planes.width + x, method) || !view.hasRow(method, y)) return;
        void view.needRow(method, y).then(() => {
            if (this.place === place && view.inspection(y * view.planes.width + x, method)) this.show(planes, x, y);
        });
    }

    copyLink(): void { this.copy(this.linkHere(), 'link'); }

    copyCommand(): void {
        const text = this.root.querySelector('.command code')?.textContent;
        if (text) this.copy(text, 'command');
    }

    private showNothing(): void {
        replaceChildren(this.root, element('h2', {}, 'Pixel'), element('p', {class: 'quiet'}, 'Click into a pane, or press ',
            element('kbd', {}, 'N'), ' for the worst pixel.'));
    }

    private values(view: FilterView, pixel: number): HTMLElement {
        const truth = view.truth!, labels = [...new Set([this.choice.method, this.choice.other])];
        const row = (who: string, channels: Channels | null, isTruth: boolean) => element('tr', {}, element('th', {scope: 'row'}, who),
            ...[0, 1, 2].map((c) => element('td', {class: 'n'}, channels ? rounded(channels[c][pixel]) : '–',
                element('div', {class: 'fine'}, isTruth || !channels ? '' : signed(channels[c][pixel] - truth[c][pixel])))));
        return element('table', {class: 'values'},
            element('thead', {}, element('tr', {}, ...['linear light', 'r', 'g', 'b'].map((title, i) => element('th', {class: i ? 'n' : ''}, title)))),
            element('tbody', {}, row('truth', truth, true), ...labels.map((label) => row(label, view.picture(label), false))));
    }

    /// What the picture's claim permits, and the way to the pixels outside.
    private permitted(view: FilterView, claim: Claim, pixel: number): HTMLElement {
        const found = view.picture(this.choice.method), permitted = view.permitted(this.choice.method);
        if (!found || !permitted) return element('p', {class: 'fine'}, `What ${claim.method} permits is not in this page.`);
        const count = view.outside(this.choice.method)!.reduce((sum, distance) => sum + (distance > 0 ? 1 : 0), 0);
        return element('div', {}, claimTable(claim, found, permitted, pixel),
            element('p', {class: 'fine'}, `${counted(count, 'pixel')} of ${grouped(view.planes.pixelCount)} outside. `,
                count > 0 && element('button', {type: 'button', onclick: () => this.walk.toOutside()}, 'Next pixel outside')));
    }

    /// Certainty, flip and footprint, as far as planes are decoded.
    private facts(view: FilterView, pixel: number): HTMLElement {
        const float = (name: string) => {
            const words = view.planes.now(name) as Uint32Array | null;
            return words ? asFloats(words)[pixel] : NaN;
        };
        const half = float('half_width'), error = view.errors(this.choice.method)?.[pixel] ?? NaN;
        const flip = (view.planes.now(`method.${this.choice.method}.flip`) as Uint8Array | null)?.[pixel];
        const fact = (name: string, text: string) => [element('dt', {}, name), element('dd', {}, text)];
        const major = float('major'), minor = float('minor');
        return element('dl', {class: 'bound'},
            ...fact('truth', half === 0 ? 'exact' : `± ${rounded(half)}; |error| / certainty ${rounded(error / half)}`),
            ...fact('FLIP', flip === undefined ? '–' : rounded(flip / 255)),
            ...fact('footprint', major > 0 ? `${rounded(major)} by ${rounded(minor)} texels, anisotropy ${rounded(major / minor)}, LOD ${rounded(float('lod'))}`
                : 'no texture'));
    }

    private noInspection(view: FilterView, method: string, x: number, y: number): HTMLElement {
        const some = view.inspections.some((one) => one.method === this.choice.method);
        return element('p', {class: 'fine'}, `What ${method} reads here is not stored; the command tells it. `,
            'A study with ', element('code', {}, `--inspect ${boxAbout(view.planes, x, y)}`), ' tells every pixel about this one. ',
            some && element('button', {type: 'button', onclick: () => this.walk.toStory()}, 'Next pixel with an inspection'));
    }

    private command(view: FilterView, x: number, y: number, method: string): HTMLElement {
        const command = `${view.header.explain} --pixel ${x},${y} --method ${quoted(method)}`;
        return element('div', {class: 'command'}, element('code', {}, command),
            element('div', {},
                element('button', {type: 'button', onclick: () => this.copy(command, 'command')}, 'Copy command'), ' ',
                element('button', {type: 'button', onclick: () => this.copyLink()}, 'Copy link ', element('kbd', {}, 'C'))));
    }
}

/// A box of at most 32 x 32 pixels, as --inspect takes it.
function boxAbout(planes: Planes, x: number, y: number): string {
    const width = Math.min(32, planes.width), height = Math.min(32, planes.height);
    const from = (at: number, side: number, size: number) => Math.min(Math.max(at - side / 2 | 0, 0), size - side);
    return [from(x, width, planes.width), from(y, height, planes.height), width, height].join();
}

/// For a shell.
function quoted(word: string): string { return /^[\w.,:=+-]+$/.test(word) ? word : `'${word.replace(/'/g, `'\\''`)}'`; }

function inspectionOf(one: Inspection): HTMLElement {
    const picture = (shown: Shown, caption: string) => element('figure', {},
        element('canvas', {class: 'footprint', 'data-shown': shown, role: 'img'}), element('figcaption', {}, caption));
    return element('div', {},
        one.window && element('div', {class: 'triple'}, picture('texture', 'texture'), one.reading && picture('read', 'weights read'),
            one.exact && picture('exact', 'exact weights')),
        one.window && element('p', {class: 'fine'}, `White: the pixel's square on the texture; cyan: the ellipse in it; red: centroid of the weights, the largest of which is the brightest. `,
            one.window.block > 1 && `A cell is ${one.window.block} × ${one.window.block} texels.`),
        shapes(one), one.reading && images(one), one.reading && taps(one),
        element('details', {}, element('summary', {}, 'What ', element('code', {}, 'zproof filters explain'), ' prints'),
            element('pre', {class: 'story'}, one.text)));
}

/// Sum, centroid and spread of the weights that are read, of the exact ones, and of the footprint.
function shapes(one: Inspection): HTMLElement {
    const major = one.direction, minor: [number, number] = [-major[1], major[0]];
    const row = (who: string, sum: string, centroid: (number | null)[], along: number, across: number) => element('tr', {},
        element('th', {scope: 'row'}, who), element('td', {class: 'n'}, sum),
        element('td', {class: 'n'}, centroid.map((c) => c === null ? '–' : Number(c.toPrecision(5))).join(', ')),
        element('td', {class: 'n'}, rounded(along)), element('td', {class: 'n'}, rounded(across)));
    const of = (who: string, shape: Shape) => row(who, rounded(shape.sum ?? NaN), shape.centroid, spreadAlong(shape, major), spreadAlong(shape, minor));
    return element('table', {class: 'shapes'},
        element('thead', {}, element('tr', {}, ...['', 'sum', 'centroid', 'σ major', 'σ minor'].map((title, i) => element('th', {class: i ? 'n' : ''}, title)))),
        element('tbody', {}, one.reading && of('read', one.reading.shape), one.exact && of('exact', one.exact),
            row('J Jᵀ / 12', '1', one.centre, one.major / Math.sqrt(12), one.minor / Math.sqrt(12))));
}

function images(one: Inspection): HTMLElement {
    return element('table', {class: 'images'},
        element('thead', {}, element('tr', {}, ...['level', 'size', 'taps', 'weight'].map((title, i) => element('th', {class: i ? 'n' : ''}, title)))),
        element('tbody', {}, ...one.reading!.images.map((image) => element('tr', {},
            element('td', {}, image.level ? [...new Set(image.level)].map(rounded).join(' × ') : `image ${image.image}`),
            element('td', {class: 'n'}, `${image.width} × ${image.height}`), element('td', {class: 'n'}, String(image.taps)),
            element('td', {class: 'n'}, rounded(image.weight))))));
}

/// From taps to the result.
function taps(one: Inspection): HTMLElement {
    const {taps: listed, taps_in_all: all} = one.reading!;
    return element('details', {open: listed.length <= 16}, element('summary', {}, `${all} taps`),
        element('table', {class: 'taps'},
            element('thead', {}, element('tr', {}, ...['image', 'texel', 'weight', 'value r g b'].map((title, i) => element('th', {class: i ? 'n' : ''}, title)))),
            element('tbody', {}, ...listed.map(([image, column, row, weight, ...value]) => element('tr', {},
                element('td', {}, String(image)), element('td', {class: 'n'}, `${column}, ${row}`), element('td', {class: 'n'}, rounded(weight)),
                element('td', {class: 'n'}, value.map(rounded).join(' ')))))),
        all > listed.length && element('p', {class: 'fine'}, `The first ${listed.length} of ${all}; the command prints as many.`),
        element('p', {class: 'fine'}, `Result: factor ${one.factor.map(rounded).join(' ')} × sum of weight × value = ${one.result.map(rounded).join(' ')}`));
}

function draw(root: HTMLElement, one: Inspection): void {
    root.querySelectorAll<HTMLCanvasElement>('canvas.footprint').forEach((canvas) => {
        const shown = canvas.dataset.shown as Shown;
        drawFootprint(canvas, one, shown, shown === 'read' ? one.reading?.shape : shown === 'exact' ? one.exact : undefined);
    });
}
