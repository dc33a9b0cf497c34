// Were the planes decoded to what was written?
import {checksum} from './coding';
import type {Notice} from './notice';
import {counted} from './numbers';
import type {Planes} from './planes';

/// Decodes all planes, and tells whether they have the digests of what was written. Returns what they have.
export async function checkPlanes(planes: Planes, notice: Notice): Promise<Record<string, number>> {
    const digests: Record<string, number> = {}, bad: string[] = [];
    await planes.load(planes.leftOut);
    for (const name of planes.names().filter((name) => planes.digest(name) !== undefined)) {
        digests[name] = checksum(await planes.plane(name));
        if (digests[name] !== planes.digest(name)) bad.push(name);
    }
    notice.tell(bad.length ? 'Not what was written: ' + bad.join(', ') + '!'
                           : `${counted(Object.keys(digests).length, 'plane')}: every bit is what was written.`);
    return digests;
}
