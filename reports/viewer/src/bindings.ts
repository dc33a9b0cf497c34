// Which key does what; help.ts tells the reader.
import type {App} from './app';
import {listenToKeys} from './keys';
import type {KeyMap} from './keys';

/// Keys that only make sense over an open view.
function viewerKeys(app: App): Record<string, () => void> {
    const {panes, crosshair, notice} = app, {walk, inspector, drawer} = app.subject;
    const keys: Record<string, () => void> = {
        p: () => void app.next(-1), u: () => walk.bySeverity(1), y: () => walk.bySeverity(-1), s: () => walk.toStory(),
        '[': () => void app.openBeside(-1), ']': () => void app.openBeside(1), '/': () => app.list.search.focus(),
        '+': () => crosshair.zoom(1.5), '=': () => crosshair.zoom(1.5), '-': () => crosshair.zoom(1 / 1.5),
        0: () => panes.fit(), z: () => crosshair.zoomTo(),
        a: () => panes.activateNext(), m: () => void panes.cycle(),
        w: () => notice.tell(panes.compare('wipe')), d: () => notice.tell(panes.compare('difference')),
        ',': () => panes.moveWipe(-0.02), '.': () => panes.moveWipe(0.02), x: () => drawer.clearFilter(),
        c: () => inspector.copyLink(), e: () => inspector.copyCommand(), o: () => app.files.ask(), q: () => void app.check(),
    };
    const steps: Record<string, [number, number]> = {
        arrowleft: [-1, 0], arrowright: [1, 0], arrowup: [0, -1], arrowdown: [0, 1], h: [-1, 0], l: [1, 0], k: [0, -1], j: [0, 1],
    };
    for (const [key, [dx, dy]] of Object.entries(steps)) {
        keys[key] = () => crosshair.step(dx, dy);
        keys['shift ' + key] = () => crosshair.step(16 * dx, 16 * dy);
    }
    for (const [, , acts] of app.subject.keys) Object.assign(keys, acts);
    for (let digit = 1; digit <= 9; ++digit) keys[digit] = () => panes.choose(digit - 1);
    return keys;
}

export function bindKeys(app: App): void {
    const keys: KeyMap = {
        n: () => void app.next(1), t: () => app.switchTheme(), v: () => app.toggle(), '?': () => app.help.toggle(),
    };
    for (const [key, act] of Object.entries(viewerKeys(app))) keys[key] = () => { if (app.isOpen) act(); };
    const flip = {down: () => { if (app.isOpen) app.panes.force('flip'); }, up: () => app.panes.force(null)};
    listenToKeys(keys, {' ': flip}, () => app.isOpen);
}
