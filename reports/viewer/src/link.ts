// Addresses of pixels: what comes after # in a page's address. They work from disk, for nothing is asked of a server.

export type LinkTarget = {
    view: string; x?: number; y?: number; zoom?: number; layers?: string[];
    method?: string; other?: string;  // of a filter study
};

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
            layers: words.get('layers')?.split(','), method: words.get('method') ?? undefined,
            other: words.get('other') ?? undefined};
}

export function hashOf(place: LinkTarget): string {
    const words = ['view=' + encodeURIComponent(place.view)];
    if (place.x !== undefined && place.y !== undefined) words.push(`x=${place.x}`, `y=${place.y}`);
    if (place.method) words.push('method=' + encodeURIComponent(place.method));
    if (place.other) words.push('other=' + encodeURIComponent(place.other));
    if (place.zoom !== undefined) words.push('zoom=' + Number(place.zoom.toPrecision(4)));
    if (place.layers) words.push('layers=' + place.layers.map(encodeURIComponent).join(','));
    return '#' + words.join('&');
}
