// What the viewer has to say: a line that goes away by itself.
import {element} from './element';

const shownFor = 6000;  // ms

export class Notice {
    readonly root = element('p', {class: 'notice', role: 'status', hidden: true});
    private timer = 0;

    tell(text: string): void {
        this.root.textContent = text;
        this.root.hidden = false;
        clearTimeout(this.timer);
        this.timer = window.setTimeout(() => { this.root.hidden = true; }, shownFor);
    }

    /// Puts a text into the clipboard; where that is refused, the text itself is told.
    async copy(text: string, what: string): Promise<void> {
        try {
            await navigator.clipboard.writeText(text);
            this.tell(`The ${what} is in the clipboard.`);
        } catch {
            this.tell(text);
        }
    }
}
