// Elements of the page, made in one expression. Text only ever enters as text.

type Child = Node | string | number | null | undefined | false;
type Attributes = Record<string, string | number | boolean | ((event: never) => void) | undefined>;

/// element('td', {class: 'n'}, 'text', child): `on...` attributes are listeners, `true` is an empty attribute,
/// false and undefined none.
export function element<K extends keyof HTMLElementTagNameMap>(
    tag: K, attributes: Attributes = {}, ...children: Child[]): HTMLElementTagNameMap[K] {
    const made = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) {
        if (value === undefined || value === false) continue;
        if (typeof value === 'function') made.addEventListener(name.slice(2), value as EventListener);
        else made.setAttribute(name, value === true ? '' : String(value));
    }
    append(made, children);
    return made;
}

export function append(parent: Node, children: Child[]): void {
    for (const child of children)
        if (child !== null && child !== undefined && child !== false)
            parent.appendChild(child instanceof Node ? child : document.createTextNode(String(child)));
}

export function replaceChildren(parent: HTMLElement, ...children: Child[]): void {
    parent.textContent = '';
    append(parent, children);
}

/// The context of a canvas made as large as it is shown, in device pixels. Written to, never read back: browsers
/// that guard against fingerprinting answer with noise.
export function fittedCanvas(canvas: HTMLCanvasElement): {context: CanvasRenderingContext2D; scale: number} {
    const scale = window.devicePixelRatio || 1;
    const width = Math.max(1, Math.round(canvas.clientWidth * scale));
    const height = Math.max(1, Math.round(canvas.clientHeight * scale));
    if (canvas.width !== width) canvas.width = width;
    if (canvas.height !== height) canvas.height = height;
    return {context: canvas.getContext('2d')!, scale};
}

/// A colour of the style sheet, by its custom property.
export function styleColour(name: string): string {
    return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}
