// A picture as three planes of floats, linear light.
export type Channels = [Float32Array, Float32Array, Float32Array];

export const channelNames = ['r', 'g', 'b'] as const;
