// Ways from the written report into the viewer.
import {append, element} from './element';
import {hashOf} from './link';
import type {ViewEntry} from './run';

function linkRows(section: HTMLElement, view: ViewEntry): void {
    section.querySelectorAll<HTMLTableRowElement>('tr[data-x]').forEach((row) => {
        const cell = row.cells[0], {x, y} = row.dataset;
        const link = element('a', {href: hashOf({view: view.link, x: Number(x), y: Number(y)})}, cell.textContent);
        cell.replaceChildren(link);
    });
}

/// A click into a picture opens the viewer at that pixel.
function linkPictures(section: HTMLElement, view: ViewEntry): void {
    section.querySelectorAll<HTMLImageElement>('figure a img, .truth img').forEach((image) =>
        image.addEventListener('click', (event) => {
            if (event.ctrlKey || event.metaKey || event.shiftKey || event.button !== 0) return;
            event.preventDefault();
            const x = Math.floor(event.offsetX / image.clientWidth * view.width);
            const y = Math.floor(event.offsetY / image.clientHeight * view.height);
            location.hash = hashOf({view: view.link, x, y});
        }));
}

function linkTop(views: ViewEntry[], key: string, meaning: string): void {
    const first = views.find((view) => view.planes)!;
    append(document.querySelector('body > header')!, [
        element('a', {class: 'enter', href: hashOf({view: first.link})}, 'Open the viewer'),
        element('p', {class: 'fine'}, 'Keys: ', element('kbd', {}, 'V'), ' the viewer, ', element('kbd', {}, key), ` ${meaning}, `,
            element('kbd', {}, '?'), ' all keys')]);
}

/// The section of a view, where the viewer can show it.
export function linkSection(section: HTMLElement, view: ViewEntry): void {
    if (!view.planes) return;
    section.querySelector('h2')?.append(' ',
        element('a', {class: 'inspect', href: hashOf({view: view.link})}, 'Open in the viewer'));
    linkRows(section, view);
    linkPictures(section, view);
}

/// `key` and `meaning`: the key that goes to what is worth a look first.
export function linkSummary(views: ViewEntry[], key: string, meaning: string): void {
    linkTop(views, key, meaning);
    for (const view of views) {
        const section = document.getElementById(view.anchor);
        if (section) linkSection(section, view);
    }
}
