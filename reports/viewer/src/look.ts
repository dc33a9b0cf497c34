// The one look that all panes share: zoom, place and crosshair.

export type Size = {width: number; height: number};

export const leastZoom = 1 / 64, mostZoom = 160;

export class Look {
    zoom = 1;          // CSS pixels per pixel of the view
    x = 0; y = 0;      // raster position in the middle of every pane
    crossX = -1; crossY = -1;  // pixel, or -1
    private fitted = true;

    constructor(private view: Size) { this.x = view.width / 2; this.y = view.height / 2; }

    get hasCross(): boolean { return this.crossX >= 0; }
    get cross(): number { return this.crossY * this.view.width + this.crossX; }
    get isFitted(): boolean { return this.fitted; }

    fit(pane: Size): void {
        this.zoom = Math.min(pane.width / this.view.width, pane.height / this.view.height);
        this.x = this.view.width / 2;
        this.y = this.view.height / 2;
        this.fitted = true;
    }

    /// Keeps the raster position (x, y) where it is in the pane.
    zoomBy(factor: number, x = this.x, y = this.y): void {
        const zoom = Math.min(mostZoom, Math.max(leastZoom, this.zoom * factor)), keep = this.zoom / zoom;
        this.x = x + (this.x - x) * keep;
        this.y = y + (this.y - y) * keep;
        this.zoom = zoom;
        this.fitted = false;
        this.hold();
    }

    pan(dx: number, dy: number): void {
        this.x += dx;
        this.y += dy;
        this.fitted = false;
        this.hold();
    }

    setCross(x: number, y: number): void {
        this.crossX = Math.min(this.view.width - 1, Math.max(0, Math.round(x)));
        this.crossY = Math.min(this.view.height - 1, Math.max(0, Math.round(y)));
    }

    /// Brings the crosshair into a pane's middle part.
    follow(pane: Size): void {
        if (!this.hasCross) return;
        const reachX = 0.42 * pane.width / this.zoom, reachY = 0.42 * pane.height / this.zoom;
        const x = this.crossX + 0.5, y = this.crossY + 0.5;
        if (Math.abs(x - this.x) <= reachX && Math.abs(y - this.y) <= reachY) return;
        this.x = x;
        this.y = y;
        this.fitted = false;
    }

    private hold(): void {
        this.x = Math.min(this.view.width, Math.max(0, this.x));
        this.y = Math.min(this.view.height, Math.max(0, this.y));
    }
}
