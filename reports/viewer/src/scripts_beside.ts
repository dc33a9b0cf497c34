// Planes in script files beside the page: a page from disk may load scripts, and nothing else
// (reports/planes/embedded.h).
import {fromBase64} from './coding';
import {readContainer} from './container';
import type {Container} from './container';
import {element} from './element';

const waiting = new Map<string, (base64: string) => void>();

Object.assign(window, {zproofPlanes: (file: string, base64: string) => waiting.get(file)?.(base64)});

/// What the script holds; null where it is not there.
export function containerIn(file: string): Promise<Container | null> {
    return new Promise((resolve) => {
        const end = () => {
            script.remove();
            resolve(null);  // changes nothing where the script has called
        };
        const script = element('script', {src: file, onload: end, onerror: end});
        waiting.set(file, (base64) => resolve(readContainer(fromBase64(base64))));
        document.head.append(script);
    });
}
