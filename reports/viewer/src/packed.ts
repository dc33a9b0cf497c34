// Elements of the page that hold deflated text (reports/html_packs.cpp).
import {fromBase64, inflated} from './coding';

/// The text of the element of that id; null where the page has none.
export async function unpack(id: string): Promise<string | null> {
    const packed = document.getElementById(id)?.textContent;
    return packed ? new TextDecoder().decode(await inflated(fromBase64(packed))) : null;
}

/// The texts of KIND-0, KIND-1 ...
export async function unpackAll(kind: string): Promise<string[]> {
    const texts: Promise<string | null>[] = [];
    while (document.getElementById(`${kind}-${texts.length}`)) texts.push(unpack(`${kind}-${texts.length}`));
    return (await Promise.all(texts)).map((text) => text ?? '');
}
