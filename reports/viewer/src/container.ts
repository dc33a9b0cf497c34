// planes.zvp, as reports/planes/container.h has it.

export type BlockFacts = {
    name: string; bytes: number; coding: 'bytes' | 'left' | 'planar' | 'runs' | 'beside' | 'sparse' | 'channels' | 'json' | 'table';
    crc32?: number; beside?: string; count?: number; words?: number; all?: number;
};

/// What every container says of its view.
export type Header = {width: number; height: number; scene: string; view: string; blocks: BlockFacts[];
                      leftOut?: string[];  // names of blocks that the page does not hold
                      scripts?: Record<string, string[]>};  // of these, by the file beside the page that does

/// The header of a judged view (reports/planes/view_planes.cpp).
export type JudgedHeader = Header & {
    candidate: string; reference: string; oracles: string[]; explain: [string, string];
    inverse_depth: [number | null, number | null]; perspective: boolean;
};

export type Block = {facts: BlockFacts; content: Uint8Array<ArrayBuffer>};

export type Container = {header: Header; blocks: Map<string, Block>};

/// Throws Error with a sentence for people where the bytes are no such container.
export function readContainer(bytes: Uint8Array<ArrayBuffer>): Container {
    const magic = String.fromCharCode(...bytes.subarray(0, 4));
    if (magic !== 'ZVP1') throw new Error('not a planes.zvp of zproof: it does not begin with ZVP1');
    const length = new DataView(bytes.buffer, bytes.byteOffset).getUint32(4, true);
    const header = JSON.parse(new TextDecoder().decode(bytes.subarray(8, 8 + length))) as Header;
    const blocks = new Map<string, Block>();
    let at = 8 + length;
    for (const facts of header.blocks) {
        blocks.set(facts.name, {facts, content: bytes.subarray(at, at + facts.bytes)});
        at += facts.bytes;
    }
    if (at > bytes.length) throw new Error('this planes.zvp ends early; run zproof again');
    return {header, blocks};
}
