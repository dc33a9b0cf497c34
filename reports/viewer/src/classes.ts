// The classes of a view with their counts; one of them may be looked at alone.
import {element, replaceChildren} from './element';
import {badge} from './inspector';
import {grouped, rounded} from './numbers';
import type {ClassStyle} from './run';

export class ClassList {
    readonly root = element('div', {class: 'classes'});

    constructor(private readonly styles: ClassStyle[], private readonly onChoice: (kind: number) => void) {}

    show(counts: number[]): void {
        const all = counts.reduce((a, b) => a + b, 0);
        replaceChildren(this.root, element('h3', {}, 'Classes'), ...counts.map((count, kind) => count > 0 && this.row(kind, count)),
            element('p', {class: 'fine'}, `${rounded(100 * (all - counts[0]) / all)} % differ`));
    }

    clear(): void {
        this.root.querySelectorAll('button').forEach((button) => button.setAttribute('aria-pressed', 'false'));
    }

    private row(kind: number, count: number): HTMLElement {
        const style = this.styles[kind];
        const button = element('button', {type: 'button', title: style.meaning, 'aria-pressed': 'false'},
            badge(style), element('span', {class: 'n'}, grouped(count)));
        button.addEventListener('click', () => {
            const on = button.getAttribute('aria-pressed') !== 'true';
            this.clear();
            button.setAttribute('aria-pressed', String(on));
            this.onChoice(on ? kind : -1);
        });
        return button;
    }
}
