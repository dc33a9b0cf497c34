// Numbers as text, and what float32 is made of.

const bitsBuffer = new DataView(new ArrayBuffer(8));

export const background = 0xffffffff;

export function floatOf(bits: number): number {
    bitsBuffer.setUint32(0, bits);
    return bitsBuffer.getFloat32(0);
}

export function bitsOf(value: number): number {
    bitsBuffer.setFloat32(0, value);
    return bitsBuffer.getUint32(0);
}

/// The shortest decimal that reads back to the same float32.
export function shortestFloat(value: number): string {
    if (!Number.isFinite(value)) return Number.isNaN(value) ? 'not a number' : value < 0 ? '-inf' : 'inf';
    for (let digits = 1; digits < 9; ++digits) {
        const text = value.toPrecision(digits);
        if (Math.fround(Number(text)) === value) return String(Number(text));
    }
    return String(Number(value.toPrecision(9)));
}

export function hexBits(bits: number): string {
    return '0x' + (bits >>> 0).toString(16).padStart(8, '0');
}

/// Neighbouring floats have neighbouring ranks, over zero as well.
function rank(bits: number): number {
    return bits & 0x80000000 ? -(bits & 0x7fffffff) : bits;
}

/// How many floats apart; NaN where one of them is NaN.
export function ulpsBetween(a: number, b: number): number {
    if (Number.isNaN(floatOf(a)) || Number.isNaN(floatOf(b))) return NaN;
    return rank(b) - rank(a);
}

/// How many floats two numbers that are floats lie apart.
export function rankBetween(a: number, b: number): number { return ulpsBetween(bitsOf(a), bitsOf(b)); }

export function grouped(value: number): string {
    return String(value).replace(/\B(?=(\d{3})+(?!\d))/g, ',');
}

/// Three significant digits.
export function rounded(value: number): string {
    if (!Number.isFinite(value)) return Number.isNaN(value) ? '–' : '∞';
    const text = value.toPrecision(3);
    return text.includes('e') || !text.includes('.') ? text : text.replace(/\.?0+$/, '');
}

export function counted(count: number, noun: string): string {
    return grouped(count) + ' ' + noun + (count === 1 ? '' : 's');
}

export function idText(id: number): string {
    return id === background ? 'background' : String(id);
}

/// A number of stories, where JSON had to write "nan" and "inf" as text.
export function numberOf(value: number | string): number {
    if (typeof value === 'number') return value;
    return value === 'inf' ? Infinity : value === '-inf' ? -Infinity : NaN;
}
