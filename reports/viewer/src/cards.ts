// The views as pictures. The first ones stand in the page as markup (reports/html_cards.cpp), others are made of what the
// page says of them.
import {element, replaceChildren} from './element';
import {grouped} from './numbers';
import {Packs} from './packs';
import {defects, outcomeInWords, outcomeMarks} from './run';
import type {JudgedView, Run} from './run';

export class Cards {
    private readonly root = document.getElementById('cards')!;
    private readonly inMarkup = [...this.root.children] as HTMLElement[];
    private readonly pictures: Packs<string>;
    private ticket = 0;

    constructor(private readonly run: Run) {
        this.pictures = new Packs('pictures', run, (text) => JSON.parse(text) as string[]);
    }

    /// Shows these instead of those that are shown; of several calls the last one wins.
    async show(indices: number[]): Promise<void> {
        const ticket = ++this.ticket;
        const cards = await Promise.all(indices.map(async (index) =>
            this.inMarkup[index] ?? this.card(this.run.views[index], await this.pictures.at(index))));
        if (ticket === this.ticket) replaceChildren(this.root, ...cards);
    }

    private card(view: JudgedView, picture?: string): HTMLElement {
        return element('a', {class: 'card', href: '#' + view.anchor},
            picture && element('img', {src: picture, alt: ''}),
            element('span', {class: 'name'}, view.scene + ' ', element('span', {class: 'view'}, view.view)),
            element('span', {class: 'outcome ' + view.outcome}, `${outcomeMarks[view.outcome]} ${outcomeInWords(view)}`),
            element('span', {class: 'fine'}, view.row ? this.differences(view) : view.message), view.cause && element('span', {}, view.cause));
    }

    /// How many pixels differ, class by class; where some are defects, those alone.
    private differences(view: JudgedView): string {
        const {classes} = this.run, fails = defects(view, classes) > 0;
        const found = classes.flatMap((style, i) =>
            i > 0 && view.counts[i] > 0 && !(fails && style.passes) ? [`${grouped(view.counts[i])} ${style.name}`] : []);
        return found.join(', ') || 'no difference';
    }
}
