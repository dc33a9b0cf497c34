// The address of what is open: in the address bar, and as a link to give away.
import {hashOf} from './link';
import type {LinkTarget} from './link';
import type {OpenView} from './open_view';
import type {Panes} from './panes';

export class Address {
    private timer = 0;

    constructor(private readonly current: OpenView, private readonly panes: Panes,
                private readonly isOpen: () => boolean, private readonly own: () => Partial<LinkTarget>) {}

    /// Lets the address bar follow, a little later: browsers refuse too many changes of it.
    remember(): void {
        clearTimeout(this.timer);
        this.timer = window.setTimeout(() => {
            if (this.isOpen()) history.replaceState(null, '', hashOf(this.place()));
        }, 200);
    }

    /// With zoom and layers.
    link(): string {
        const place = {...this.place(), zoom: this.current.look.zoom, layers: this.panes.layerIds()};
        return location.href.replace(/#.*$/s, '') + hashOf(place);
    }

    private place(): LinkTarget {
        const {entry, look} = this.current, view = {view: entry?.link ?? '', ...this.own()};
        return look.hasCross ? {...view, x: look.crossX, y: look.crossY} : view;
    }
}
