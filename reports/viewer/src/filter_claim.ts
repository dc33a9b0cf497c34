// What the method that a picture claims to be of permits at a pixel (filters/conformance/permitted_interval.h).
import {channelNames} from './channels';
import type {Channels} from './channels';
import {element} from './element';
import {grouped, rankBetween, shortestFloat} from './numbers';

/// As typed; an empty promise is that of zproof's own filters.
export type Claim = {method: string; promise: string};

/// The least and the greatest admissible float32 of every channel.
export type Permitted = {least: Channels; greatest: Channels};

export function claimPlanesOf(label: string): string[] {
    return ['least', 'greatest'].flatMap((end) => channelNames.map((c) => `claim.${label}.${end}.${c}`));
}

/// How far a value lies outside: below 0 under the least, above 0 over the greatest; NaN for no finite number.
function beyond(value: number, least: number, greatest: number): number {
    if (!Number.isFinite(value) || least > greatest) return NaN;
    return value < least ? value - least : Math.max(0, value - greatest);
}

/// |beyond| of the worst channel, in linear light; infinite for no finite number.
export function distanceOutside(found: Channels, permitted: Permitted, pixel: number): number {
    const of = (c: number) => Math.abs(beyond(found[c][pixel], permitted.least[c][pixel], permitted.greatest[c][pixel]));
    return Math.max(...[0, 1, 2].map((c) => Number.isNaN(of(c)) ? Infinity : of(c)));
}

function side(value: number, least: number, greatest: number): {text: string; isInside: boolean} {
    const off = beyond(value, least, greatest);
    if (Number.isNaN(off)) return {text: least > greatest ? 'no float32 is permitted' : 'no finite number', isInside: false};
    if (off === 0) return {text: 'inside', isInside: true};
    const floats = Math.abs(rankBetween(value, off < 0 ? least : greatest));
    const steps = Number((Math.abs(off) * 255).toPrecision(2));
    return {text: `${grouped(floats)} ulp (${steps}/255) ${off < 0 ? 'below' : 'above'}`, isInside: false};
}

/// A row per channel: found, least, greatest, and on which side of them it lies.
export function claimTable(claim: Claim, found: Channels, permitted: Permitted, pixel: number): HTMLElement {
    const row = (c: number) => {
        const [value, least, greatest] = [found, permitted.least, permitted.greatest].map((channels) => channels[c][pixel]);
        const told = side(value, least, greatest);
        return element('tr', {class: told.isInside ? '' : 'outside'}, element('th', {scope: 'row'}, channelNames[c]),
            ...[value, least, greatest].map((number) => element('td', {class: 'n'}, shortestFloat(number))), element('td', {}, told.text));
    };
    const promise = claim.promise ? `promising ${claim.promise}` : 'computed as exactly as zproof does';
    return element('div', {class: 'claim'},
        element('p', {class: 'fine'}, 'Permitted by ', element('code', {}, claim.method), `, ${promise}:`),
        element('table', {class: 'permitted'},
            element('thead', {}, element('tr', {}, ...['', 'found', 'least', 'greatest', ''].map((title, i) => element('th', {class: i % 4 ? 'n' : ''}, title)))),
            element('tbody', {}, ...[0, 1, 2].map(row))));
}
