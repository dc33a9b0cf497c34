// Which key does what; help.ts tells the reader.
import type {App} from './app';
import {listenToKeys} from './keys';
import type {KeyMap} from './keys';

/// Keys that only make sense over an open view.
function viewerKeys(app: App): Record<string, () => void> {
    const keys: Record<string, () => void> = {
        p: () => void app.nextDefect(-1), u: () => app.bySeverity(1), y: () => app.bySeverity(-1), s: () => app.nextStory(),
        '[': () => void app.openBeside(-1), ']': () => void app.openBeside(1), '/': () => app.search(),
        '+': () => app.zoom(1.5), '=': () => app.zoom(1.5), '-': () => app.zoom(1 / 1.5), 0: () => app.fit(), z: () => app.zoomToCross(),
        a: () => app.activateNext(), m: () => app.cyclePanes(), w: () => app.compare('wipe'), d: () => app.compare('difference'),
        ',': () => app.moveWipe(-0.02), '.': () => app.moveWipe(0.02), x: () => app.clearFilter(),
        c: () => app.copyLink(), e: () => app.copyCommand(), o: () => app.askForFile(), q: () => void app.check(),
    };
    const steps: Record<string, [number, number]> = {
        arrowleft: [-1, 0], arrowright: [1, 0], arrowup: [0, -1], arrowdown: [0, 1], h: [-1, 0], l: [1, 0], k: [0, -1], j: [0, 1],
    };
    for (const [key, [dx, dy]] of Object.entries(steps)) {
        keys[key] = () => app.step(dx, dy);
        keys['shift ' + key] = () => app.step(16 * dx, 16 * dy);
    }
    for (let digit = 1; digit <= 9; ++digit) keys[digit] = () => app.showLayer(digit - 1);
    return keys;
}

export function bindKeys(app: App): void {
    const keys: KeyMap = {
        n: () => void app.nextDefect(1), t: () => app.switchTheme(), v: () => app.toggle(), '?': () => app.toggleHelp(),
    };
    for (const [key, act] of Object.entries(viewerKeys(app))) keys[key] = () => { if (app.isOpen) act(); };
    listenToKeys(keys, {' ': {down: () => { if (app.isOpen) app.flip(true); }, up: () => app.flip(false)}}, () => app.isOpen);
}
