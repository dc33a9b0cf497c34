// Views' planes: those of the page, those from files, and of both only the ones looked at last, for memory.
import {fromBase64} from './coding';
import {readContainer} from './container';
import type {Container} from './container';
import {Planes} from './planes';
import type {ViewEntry} from './run';

const mostOpen = 3;

export class Library {
    private readonly fromFiles = new Map<string, Container>();
    private readonly open = new Map<string, Promise<Planes | null>>();  // latest last

    /// The planes of a view, with classes and findings decoded; null where the page holds none.
    get(view: ViewEntry): Promise<Planes | null> {
        const planes = this.open.get(view.anchor) ?? this.read(view);
        this.open.delete(view.anchor);
        this.open.set(view.anchor, planes);
        for (const oldest of this.open.keys()) {
            if (this.open.size <= mostOpen) break;
            this.open.delete(oldest);
        }
        return planes;
    }

    private async read(view: ViewEntry): Promise<Planes | null> {
        const container = this.fromFiles.get(view.anchor) ?? this.embedded(view);
        if (!container) return null;
        const planes = new Planes(container);
        await planes.open();
        return planes;
    }

    private embedded(view: ViewEntry): Container | null {
        const text = document.getElementById('planes-' + view.anchor)?.textContent;
        return text ? readContainer(fromBase64(text)) : null;
    }

    /// Takes the place of what the page holds of this view.
    put(view: ViewEntry, container: Container): void {
        this.fromFiles.set(view.anchor, container);
        this.open.delete(view.anchor);
    }
}
