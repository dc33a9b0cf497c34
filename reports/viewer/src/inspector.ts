// All that is known of the pixel under the crosshair.
import {cssOf, idColour} from './colours';
import {drawSurroundings} from './drawing';
import type {InverseDepthRange} from './drawing';
import {element, replaceChildren} from './element';
import {background, floatOf, hexBits, idText, numberOf, rounded, shortestFloat, ulpsBetween} from './numbers';
import type {Planes} from './planes';
import type {ClassStyle} from './run';
import {ratioOf} from './layers';
import type {PixelInspector} from './subject';
import {nameOf, shortNameOf} from './story';
import type {Candidate, Admissibility, Story} from './story';

type Answer = {who: string; id: number; depth: number | null; error: string};  // depth: bits

export class Inspector implements PixelInspector {
    readonly root = element('aside', {class: 'inspector', 'aria-label': 'pixel', 'aria-live': 'polite'});
    private shown = '';

    /// `about`: what holds for the view that is open.
    constructor(private readonly classes: ClassStyle[], private readonly about: () => HTMLElement | null,
                private readonly copy: (text: string, what: string) => void,
                private readonly linkHere: () => string, private readonly next: () => void) {}

    show(planes: Planes | null, x: number, y: number): void {
        const key = planes ? `${planes.header.scene}/${planes.header.view}/${x}/${y}` : '';
        if (!planes || x < 0) return this.showNothing();
        const pixel = y * planes.width + x, story = planes.story(pixel);
        const style = this.classes[planes.classes[pixel]];
        replaceChildren(this.root,
            element('h2', {}, `Pixel ${x}, ${y}`), badge(style), ' ',
            element('span', {class: style.passes ? 'quiet' : 'defective'}, style.passes ? 'admissible' : 'defect'),
            element('p', {class: 'why'}, story ? sentenceOf(story) : style.meaning),
            this.answersTable(planes, pixel), this.bound(planes, pixel, story),
            story ? this.storyOf(planes, story) : this.noStory(planes),
            this.command(planes, x, y), this.about());
        if (story) this.draw(planes, story);
        if (key !== this.shown) this.root.scrollTop = 0;
        this.shown = key;
    }

    copyLink(): void { this.copy(this.linkHere(), 'link'); }

    copyCommand(): void {
        const text = this.root.querySelector('.command code')?.textContent;
        if (text) this.copy(text, 'command');
    }

    private showNothing(): void {
        replaceChildren(this.root, element('h2', {}, 'Pixel'),
            element('p', {class: 'quiet'}, 'Click into a pane, or press ', element('kbd', {}, 'N'),
                ' for the worst defect.'), this.about());
    }

    private answersTable(planes: Planes, pixel: number): HTMLElement {
        const answers = answersAt(planes, pixel), ours = answers[0];
        const rows = answers.flatMap((answer) => {
            const name = shortNameOf(planes.ranges, answer.id);
            const ulps = ours.depth === null || answer.depth === null || ours.id === background || answer.id === background ? NaN : ulpsBetween(ours.depth, answer.depth);
            return [element('tr', {}, element('th', {colspan: 4}, answer.who, ' ',
                    element('span', {class: 'fine', title: nameOf(planes.ranges, answer.id)}, name))),
            element('tr', {},
                element('td', {}, swatch(answer.id), idText(answer.id)),
                element('td', {class: 'n', title: answer.depth === null ? '' : hexBits(answer.depth)},
                    answer.depth === null ? '–' : shortestFloat(floatOf(answer.depth))),
                element('td', {class: 'n'}, answer === ours || Number.isNaN(ulps) ? '–' : signed(ulps)),
                element('td', {class: 'n'}, answer.error))];
        });
        return element('table', {class: 'answers'},
            element('thead', {}, element('tr', {}, ...['triangle', 'depth', 'ULPs', 'error / bound'].map(
                (title, i) => element('th', {class: i > 0 ? 'n' : ''}, title)))),
            element('tbody', {}, ...rows));
    }

    private bound(planes: Planes, pixel: number, story: Story | undefined): HTMLElement | null {
        const row = planes.finding(pixel), f = planes.findings;
        const [low, truth, high] = story ? story.depth.map(numberOf) :
            row !== undefined && f ? [f.low[row], f.truth[row], f.high[row]] : [NaN, NaN, NaN];
        const eps = story ? story.eps : row !== undefined && f ? f.eps[row] : NaN;
        const lines: (HTMLElement | string)[] = [];
        if (!Number.isNaN(truth))
            lines.push(element('dt', {}, 'true depth'), element('dd', {}, String(truth)),
                       element('dt', {}, 'admissible'), element('dd', {}, `${low} to ${high}`));
        if (eps > 0)
            lines.push(element('dt', {}, 'judged within'),
                       element('dd', {}, `${rounded(eps)} px = ${rounded(256 * eps)}/256 px of the centre`));
        return lines.length ? element('dl', {class: 'bound'}, ...lines) : null;
    }

    private storyOf(planes: Planes, story: Story): HTMLElement {
        const picture = (name: string, caption: string) => element('figure', {},
            element('canvas', {class: 'surroundings', 'data-reach': name, role: 'img'}),
            element('figcaption', {}, caption));
        return element('div', {},
            element('div', {class: 'pair'},
                picture('pixel', 'The pixel (white) and its surroundings'),
                picture('eps', 'Around the square that it was judged in (dashed)')),
            element('h3', {}, 'Triangles within eps, nearest first'),
            story.candidates.length ? this.candidates(planes, story) : element('p', {class: 'quiet'}, 'None.'),
            element('p', {class: 'fine'}, 'Background here: ', admissibility(story.background)),
            element('details', {}, element('summary', {}, 'What ', element('code', {}, 'zproof explain'), ' prints'),
                element('pre', {class: 'story'}, story.text)));
    }

    private candidates(planes: Planes, story: Story): HTMLElement {
        const row = (c: Candidate) => element('tr', {},
            element('td', {}, swatch(c.id), String(c.id), 
                element('div', {class: 'fine', title: nameOf(planes.ranges, c.id)}, shortNameOf(planes.ranges, c.id))),
            element('td', {class: 'n'}, ...c.edges.map((d) => element('div', {}, edgeText(numberOf(d))))),
            element('td', {class: 'n', title: `${c.depth[0]} to ${c.depth[2]}`}, rounded9(numberOf(c.depth[1])),
                element('div', {class: 'fine'}, '± ' + rounded((numberOf(c.depth[2]) - numberOf(c.depth[0])) / 2))),
            element('td', {}, admissibility(c.admissibility)));
        return element('table', {class: 'candidates'},
            element('thead', {}, element('tr', {}, element('th', {}, 'triangle'),
                element('th', {class: 'n'}, 'edges, 1/256 px'), element('th', {class: 'n'}, 'depth'),
                element('th', {}, 'admissibility'))),
            element('tbody', {}, ...story.candidates.map(row)));
    }

    private noStory(planes: Planes): HTMLElement {
        return element('p', {class: 'fine'}, planes.stories.length
            ? 'The story of this pixel is not stored; the command tells it. '
            : 'No stories are stored for this view; the command tells one. ',
            planes.stories.length > 0 &&
                element('button', {type: 'button', onclick: () => this.next()}, 'Next pixel with a story'));
    }

    private command(planes: Planes, x: number, y: number): HTMLElement {
        const [before, after] = planes.judged.explain, command = `${before}${x} ${y}${after}`;
        return element('div', {class: 'command'}, element('code', {}, command),
            element('div', {},
                element('button', {type: 'button', onclick: () => this.copy(command, 'command')}, 'Copy command'), ' ',
                element('button', {type: 'button', onclick: () => this.copyLink()}, 'Copy link ', element('kbd', {}, 'C'))));
    }

    private draw(planes: Planes, story: Story): void {
        const [least, greatest] = planes.judged.inverse_depth;
        const range: InverseDepthRange = {least: least ?? -Infinity, greatest: greatest ?? Infinity};
        const eps = story.eps > 0 ? story.eps : 1 / 512;
        this.root.querySelectorAll<HTMLCanvasElement>('canvas.surroundings').forEach((canvas) =>
            drawSurroundings(canvas, story, range, canvas.dataset.reach === 'pixel' ? 0.95 : 4 * eps));
    }
}

/// The answers of candidate, reference and oracles, as far as planes are decoded or the finding is listed.
function answersAt(planes: Planes, pixel: number): Answer[] {
    const f = planes.findings, row = planes.finding(pixel), header = planes.judged;
    const word = (name: string): number | null => (planes.now(name) as Uint32Array | null)?.[pixel] ?? null;
    const code = (name: string): string => {  // a code stands for a quarter octave
        const found = (planes.now(name) as Uint8Array | null)?.[pixel];
        return !found ? '–' : found === 1 ? '0' : '≥ ' + rounded(ratioOf(found));
    };
    const answer = (who: string, plane: string, listed: [number, number] | null): Answer => ({
        who, id: word(plane + '.id') ?? listed?.[0] ?? background, depth: word(plane + '.depth') ?? listed?.[1] ?? null,
        error: code(plane + '.error'),
    });
    const listed = f && row !== undefined;
    const ours = answer(header.candidate, 'candidate', listed ? [f.candidate[row], f.candidateDepth[row]] : null);
    if (listed) ours.error = rounded(f.error[row]);
    const answers = [ours, answer(header.reference, 'reference', listed ? [f.reference[row], f.referenceDepth[row]] : null)];
    for (const name of header.oracles)
        if (planes.now(`oracle.${name}.id`)) answers.push(answer(name, `oracle.${name}`, null));
    return answers;
}

/// The verdict's sentence: the second line of what explain prints.
function sentenceOf(story: Story): string {
    const line = (story.text.split('\n')[1] ?? '').trim();
    return line ? line[0].toUpperCase() + line.slice(1) + '.' : '';
}

export function badge(style: Pick<ClassStyle, 'name' | 'glyph' | 'colour'>): HTMLElement {
    return element('span', {class: 'class'},
        element('i', {style: `background:${style.colour};color:${ink(style.colour)}`, 'aria-hidden': 'true'}, style.glyph),
        style.name);
}

function ink(colour: string): string {
    const n = parseInt(colour.slice(1), 16);
    return 299 * (n >> 16) + 587 * (n >> 8 & 255) + 114 * (n & 255) > 110_000 ? '#16181c' : '#ffffff';
}

function swatch(id: number): HTMLElement {
    return element('i', {class: 'swatch', style: `background:${cssOf(idColour(id))}`});
}

function admissibility(s: Admissibility): HTMLElement {
    return element('span', {class: s.admissible ? 'proven' : 'defective'},
        (s.admissible ? '✓ ' : '✗ ') + s.word, s.exact && ' (exact rationals)');
}

function edgeText(distance: number): string {
    return Number.isNaN(distance) ? 'edge-on' : signed(Number(distance.toPrecision(4)));
}

function signed(value: number): string { return (value > 0 ? '+' : '') + String(value).replace('-', '−'); }

function rounded9(value: number): string { return Number.isFinite(value) ? String(Number(value.toPrecision(9))) : '–'; }
