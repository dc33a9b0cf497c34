// The view that is open and how it is looked at. App writes it, the parts of the viewer read it.
import {Look} from './look';
import type {Planes} from './planes';
import type {Selection} from './raster';
import type {ViewEntry} from './run';

export class OpenView {
    index = -1;                               // among the page's views; -1: none yet
    planes: Planes | null = null;             // null too where the page holds none of this view
    look = new Look({width: 1, height: 1});
    selection: Selection | null = null;       // the pixels that the filter leaves; null: all

    constructor(private readonly views: ViewEntry[]) {}

    get entry(): ViewEntry | undefined { return this.views[this.index]; }
}
