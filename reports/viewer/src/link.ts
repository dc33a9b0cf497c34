// Addresses of pixels: what comes after # in report.html. They work from disk, for nothing is asked of a server.

export type LinkTarget = {view: string; x?: number; y?: number; zoom?: number; layers?: string[]};

export function readLinkTarget(hash: string): LinkTarget | null {
    const words = new URLSearchParams(hash.replace(/^#/, ''));
    const view = words.get('view');
    if (!view) return null;
    const whole = (name: string) => {
        const text = words.get(name);
        return text !== null && /^\d{1,5}$/.test(text) ? Number(text) : undefined;
    };
    const zoom = Number(words.get('zoom'));
    return {view, x: whole('x'), y: whole('y'), zoom: zoom > 0 && Number.isFinite(zoom) ? zoom : undefined,
            layers: words.get('layers')?.split(',')};
}

export function hashOf(place: LinkTarget): string {
    const words = ['view=' + encodeURIComponent(place.view)];
    if (place.x !== undefined && place.y !== undefined) words.push(`x=${place.x}`, `y=${place.y}`);
    if (place.zoom !== undefined) words.push('zoom=' + Number(place.zoom.toPrecision(4)));
    if (place.layers) words.push('layers=' + place.layers.map(encodeURIComponent).join(','));
    return '#' + words.join('&');
}
