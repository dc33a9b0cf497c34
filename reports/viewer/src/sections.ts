// The sections of a run's views: those of the first ones stand in the page as markup, others are packed, and the page may
// lack the last ones.
import {element, replaceChildren} from './element';
import {Packs} from './packs';
import type {JudgedView, Run} from './run';

export class Sections {
    private readonly root = document.getElementById('sections')!;
    private readonly inMarkup = [...this.root.children] as HTMLElement[];
    private readonly packs: Packs<HTMLElement>;
    private readonly prepared = new Set<HTMLElement>();
    private ticket = 0;

    /// `prepare`: what is done to a section that was packed.
    constructor(private readonly run: Run, private readonly prepare: (section: HTMLElement, view: JudgedView) => void) {
        this.packs = new Packs('sections', run, elementsOf);
    }

    has(index: number): boolean { return index < this.inMarkup.length || this.packs.has(index); }

    /// Shows these instead of those that are shown; of several calls the last one wins.
    async show(indices: number[]): Promise<void> {
        const ticket = ++this.ticket;
        const sections = await Promise.all(indices.map((index) => this.inMarkup[index] ?? this.packs.at(index)));
        if (ticket !== this.ticket) return;
        sections.forEach((section, i) => {
            if (!section || this.inMarkup[indices[i]] || this.prepared.has(section)) return;
            this.prepare(section, this.run.views[indices[i]]);
            this.prepared.add(section);
        });
        replaceChildren(this.root, ...sections);
        this.root.dataset.shown = String(ticket);
    }
}

/// Unfolds the section; where it has no picture of its own it shows that of the view's card.
export function unfold(section: HTMLElement | null): void {
    const details = section?.querySelector('details'), place = section?.querySelector('figure.of-card');
    const picture = document.querySelector<HTMLImageElement>(`a.card[href="#${section?.id}"] img`);
    if (details) details.open = true;
    if (place && picture && !place.firstChild) place.append(element('img', {src: picture.src, alt: picture.alt}));
}

/// The page's own markup, which is escaped where it was written; scripts in it would not run.
function elementsOf(text: string): HTMLElement[] {
    const template = document.createElement('template');
    template.innerHTML = text;
    return [...template.content.children] as HTMLElement[];
}
