// The sections of a run of many views: those of the first ones stand in the page as markup, others are packed, and the
// page may lack the last ones (reports/html_packs.cpp).
import {replaceChildren} from './element';
import {unpack} from './packed';
import type {JudgedView, Run} from './run';

export class Sections {
    private readonly root = document.getElementById('sections')!;
    private readonly inMarkup = [...this.root.children] as HTMLElement[];
    private ticket = 0;

    /// `prepare`: what is done to a section that was packed.
    constructor(private readonly run: Run, private readonly prepare: (section: HTMLElement, view: JudgedView) => void) {}

    has(index: number): boolean { return index < this.inMarkup.length || document.getElementById(this.packOf(index)) !== null; }

    /// Shows these instead of those that are shown; of several calls the last one wins.
    async show(indices: number[]): Promise<void> {
        const ticket = ++this.ticket, packs = new Map<string, Promise<HTMLElement[]>>();
        for (const index of indices.filter((i) => i >= this.inMarkup.length)) {
            const pack = this.packOf(index);
            if (!packs.has(pack)) packs.set(pack, this.open(pack));
        }
        const sections = await Promise.all(indices.map(async (index) =>
            this.inMarkup[index] ?? (await packs.get(this.packOf(index))!)[(index - this.inMarkup.length) % this.run.inPack]));
        if (ticket !== this.ticket) return;
        indices.forEach((index, i) => {
            if (sections[i] && !this.inMarkup[index]) this.prepare(sections[i], this.run.views[index]);
        });
        replaceChildren(this.root, ...sections);
        this.root.dataset.shown = String(ticket);
    }

    private packOf(index: number): string { return `sections-${Math.floor((index - this.inMarkup.length) / this.run.inPack)}`; }

    /// The page's own markup, which is escaped where it was written; scripts in it would not run.
    private async open(pack: string): Promise<HTMLElement[]> {
        const template = document.createElement('template');
        template.innerHTML = await unpack(pack) ?? '';
        return [...template.content.children] as HTMLElement[];
    }
}
