// Where the crosshair stands, and the zoom about it. Panes and inspector follow.
import type {OpenView} from './open_view';
import type {Panes} from './panes';
import type {PixelInspector} from './subject';

const pixelZoom = 36;  // at which a pixel is a square with its number

export class Crosshair {
    constructor(private readonly current: OpenView, private readonly panes: Panes,
                private readonly inspector: PixelInspector, private readonly onMove: (x: number, y: number) => void) {}

    /// To a pixel, which is brought near and into the panes.
    go(pixel: number): void {
        const {planes, look} = this.current;
        if (!planes) return;
        const x = pixel % planes.width, y = (pixel - x) / planes.width;
        look.setCross(x, y);
        if (look.isFitted || look.zoom < 3) look.zoomBy(pixelZoom / look.zoom);
        look.follow(this.panes.size);
        this.moved();
    }

    step(dx: number, dy: number): void {
        const {planes, look} = this.current;
        if (!planes) return;
        if (look.hasCross) look.setCross(look.crossX + dx, look.crossY + dy);
        else look.setCross(Math.floor(look.x), Math.floor(look.y));
        look.follow(this.panes.size);
        this.moved();
    }

    /// To be called when something else has moved it.
    moved(): void {
        const {look} = this.current;
        this.panes.redraw();
        this.inspect();
        this.onMove(look.crossX, look.crossY);
    }

    /// Shows what is known of the pixel by now.
    inspect(): void {
        const {planes, look} = this.current;
        this.inspector.show(planes, look.crossX, look.crossY);
    }

    zoom(factor: number): void {
        const {look} = this.current;
        if (look.hasCross) look.zoomBy(factor, look.crossX + 0.5, look.crossY + 0.5);
        else look.zoomBy(factor);
        this.panes.redraw();
    }

    /// Near to the crosshair, and back.
    zoomTo(): void {
        const {look} = this.current;
        if (!look.hasCross || look.zoom >= pixelZoom) return this.panes.fit();
        look.zoomBy(pixelZoom / look.zoom);
        look.follow({width: 0, height: 0});
        this.panes.redraw();
    }
}
