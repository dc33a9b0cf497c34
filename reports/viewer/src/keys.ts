// Keys and what they do. Held keys are told when they are let go as well.

export type KeyMap = Record<string, (event: KeyboardEvent) => void>;

function isTyping(target: EventTarget | null): boolean {
    return target instanceof HTMLInputElement || target instanceof HTMLTextAreaElement ||
        target instanceof HTMLSelectElement;
}

/// Keys are given as KeyboardEvent.key in lower case, with "shift " before arrows. While `hasAll` is false, keys keep
/// what the browser does by them.
export function listenToKeys(keys: KeyMap, held: Record<string, {down(): void; up(): void}>, hasAll: () => boolean): void {
    document.addEventListener('keydown', (event) => {
        if (event.ctrlKey || event.metaKey || event.altKey || isTyping(event.target)) return;
        if (document.querySelector('dialog[open]') && event.key !== '?') return;
        const key = event.key.toLowerCase(), isArrow = key.startsWith('arrow');
        const hold = held[key];
        if (hold && hasAll() && !(event.target instanceof HTMLButtonElement)) {
            event.preventDefault();
            if (!event.repeat) hold.down();
            return;
        }
        const act = keys[isArrow && event.shiftKey ? 'shift ' + key : key];  // shift makes other letters, not other keys
        if (!act) return;
        if (hasAll() || key.length === 1) act(event);
        if (hasAll()) event.preventDefault();
    });
    document.addEventListener('keyup', (event) => held[event.key.toLowerCase()]?.up());
    window.addEventListener('blur', () => Object.values(held).forEach((hold) => hold.up()));
}
