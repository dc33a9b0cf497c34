// The overlay that tells the keys.
import {element} from './element';

const groups: [string, [string, string][]][] = [
    ['Go', [['N / P', 'next / previous defect (where there is none: differing pixel); of a study, worst pixel'],
            ['U / Y', 'next worse / less bad, by severity'], ['S', 'next pixel with a story or an inspection'],
            ['[ / ]', 'previous / next view'], ['arrows, H J K L', 'crosshair by 1 pixel; with Shift by 16'],
            ['/', 'search views'], ['V', 'viewer or summary']]],
    ['Look', [['+ / −', 'zoom'], ['0', 'fit'], ['Z', 'zoom to the crosshair and back'], ['1 … 9', 'layer of the active pane'],
              ['A', 'next pane becomes active'], ['M', '2, 3, 4, 6 or 9 panes'], ['T', 'light or dark']]],
    ['Compare', [['Space (hold)', 'flip neighbouring panes'], ['W', 'wipe; the mouse or , and . move the line'],
                 ['D', 'difference of neighbouring panes'], ['X', 'no filter']]],
    ['Take away', [['C', 'copy a link to this pixel'], ['E', 'copy the explain command'], ['O', 'open planes.zvp'],
                   ['Q', 'check the planes against their digests'], ['?', 'this help']]],
];

export class Help {
    readonly root: HTMLDialogElement;

    /// `more`: keys that only this page has.
    constructor(more: [string, string][]) {
        this.root = makeDialog(more.length ? [...groups, ['Study', more]] : groups);
    }

    toggle(): void { if (this.root.open) this.root.close(); else this.root.showModal(); }
}

function makeDialog(groups: [string, [string, string][]][]): HTMLDialogElement {
    const rows = (keys: [string, string][]) => keys.flatMap(([key, meaning]) =>
        [element('dt', {}, element('kbd', {}, key)), element('dd', {}, meaning)]);
    const dialog = element('dialog', {class: 'help', 'aria-label': 'keys'},
        element('h2', {}, 'Keys'),
        element('div', {class: 'help-groups'}, ...groups.map(([title, keys]) =>
            element('div', {}, element('h3', {}, title), element('dl', {}, ...rows(keys))))),
        element('p', {class: 'fine'}, 'Wheel zooms in the panes, dragging pans, a click sets the crosshair, a double click zooms in.'),
        element('button', {type: 'button', onclick: () => dialog.close()}, 'Close'));
    dialog.addEventListener('click', (event) => { if (event.target === dialog) dialog.close(); });
    return dialog;
}
