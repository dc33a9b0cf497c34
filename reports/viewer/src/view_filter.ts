// Which views of a run are shown, and as what: the reader's choice, kept in the address.
import {element} from './element';
import {defects, outcomeInWords} from './run';
import type {JudgedView, Run} from './run';

export const orders = ['failed first', 'name', 'most defects'] as const;

export type Choice = {
    show: 'pictures' | 'table'; search: string; verdict: string; cause: string; scene: string; class: string; sort: string};

const none: Choice = {show: 'pictures', search: '', verdict: '', cause: '', scene: '', class: '', sort: orders[0]};

/// The choice that an address holds; null where it names something else.
export function readChoice(hash: string): Choice | null {
    const words = new URLSearchParams(hash.replace(/^#/, ''));
    const known = [...words.keys()].filter((key) => key in none);
    if (words.has('view') || known.length === 0) return null;
    return {...none, ...Object.fromEntries(known.map((key) => [key, words.get(key)!]))};
}

export function hashOfChoice(choice: Choice): string {
    const changed = Object.entries(choice).filter(([key, value]) => value !== none[key as keyof Choice]);
    return '#' + new URLSearchParams(changed).toString();
}

/// What each list offers, by the key of the choice.
function offered(run: Run): Partial<Record<keyof Choice, string[]>> {
    const different = (words: (view: JudgedView) => string) => [...new Set(run.views.map(words))].filter(Boolean);
    return {
        verdict: different(outcomeInWords), cause: different((view) => view.cause), scene: different((view) => view.scene).sort(),
        class: run.classes.filter((_, i) => run.views.some((view) => view.counts[i] > 0)).map((style) => style.name)};
}

export class ViewFilter {
    choice: Choice = readChoice(location.hash) ?? {...none};
    readonly controls: HTMLElement[];
    private readonly inputs = new Map<keyof Choice, HTMLSelectElement | HTMLInputElement>();

    constructor(private readonly run: Run, private readonly changed: (key: keyof Choice) => void) {
        const lists = Object.entries(offered(run)) as [keyof Choice, string[]][];
        this.controls = [
            this.input('search', element('input', {type: 'search', placeholder: 'Search scene, view, verdict, class, file'})),
            ...lists.filter(([key, values]) => values.length > (key === 'cause' ? 0 : 1)).map(([key, values]) => this.list(key, ['', ...values])),
            this.list('sort', [...orders]), this.list('show', ['pictures', 'table'])];
        this.tell();
    }

    /// Does the view have what the lists ask for? The words of the search are looked up elsewhere.
    matches(view: JudgedView): boolean {
        const {verdict, cause, scene} = this.choice, wanted = this.run.classes.findIndex((style) => style.name === this.choice.class);
        return (!verdict || outcomeInWords(view) === verdict) && (!cause || view.cause === cause) &&
            (!scene || view.scene === scene) && (wanted < 0 || view.counts[wanted] > 0);
    }

    sorted(indices: number[]): number[] {
        const {views, classes} = this.run;
        if (this.choice.sort === 'name')
            return [...indices].sort((a, b) => `${views[a].scene} ${views[a].view}`.localeCompare(`${views[b].scene} ${views[b].view}`) || a - b);
        if (this.choice.sort === 'most defects')
            return [...indices].sort((a, b) => defects(views[b], classes) - defects(views[a], classes) || a - b);
        return indices;
    }

    /// Takes a choice from elsewhere.
    take(choice: Choice): void {
        this.choice = choice;
        this.tell();
    }

    private tell(): void {
        for (const [key, input] of this.inputs) input.value = this.choice[key];
    }

    private remember(): void { history.replaceState(null, '', hashOfChoice(this.choice)); }

    private list(key: keyof Choice, values: string[]): HTMLElement {
        const options = values.map((value) => element('option', {value}, value || 'any ' + key));
        return element('label', {}, key === 'sort' || key === 'show' ? key + ' ' : '', this.input(key, element('select', {}, ...options)));
    }

    private input<E extends HTMLSelectElement | HTMLInputElement>(key: keyof Choice, made: E): E {
        this.inputs.set(key, made);
        made.setAttribute('aria-label', key);
        made.addEventListener('input', () => {
            this.choice = {...this.choice, [key]: made.value};
            this.remember();
            this.changed(key);
        });
        return made;
    }
}
