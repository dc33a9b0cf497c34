// The viewer's place in the page, over the written report: a bar, and below it the parts side by side.
import type {App} from './app';
import {append, element} from './element';

export function buildFrame(app: App): void {
    append(app.root, [bar(app), app.list.root, element('main', {class: 'stage'}, app.panes.root, app.subject.drawer.root),
                      app.subject.inspector.root, app.notice.root]);
    append(document.body, [app.root, app.help.root]);
}

function bar(app: App): HTMLElement {
    const button = (text: string, title: string, act: () => void) =>
        element('button', {type: 'button', title, onclick: act}, text);
    return element('header', {class: 'bar'},
        button('← Summary', 'back to the written report (V)', () => app.close()), app.title, app.subject.tools, app.subject.drawer.note,
        element('span', {class: 'spring'}),
        button('Panes', '2, 3 or 4 panes (M)', () => void app.panes.cycle()),
        button('Fit', 'the whole view (0)', () => app.panes.fit()),
        button('Open…', 'planes.zvp from disk (O)', () => app.files.ask()),
        button('◐', 'light or dark (T)', () => app.switchTheme()),
        button('?', 'keys (?)', () => app.help.toggle()));
}
