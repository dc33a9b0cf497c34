// What the casters in this folder share; node_rays.py starts them. Files of numbers: corners (float32), rays (float64: an
// origin and a direction each), hits (float64: a triangle, or -1, and the factor of the direction).
import { readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

export const load = createRequire(join(process.cwd(), 'node_modules', 'none.js'));
export const load_module = (name) => import(pathToFileURL(load.resolve(name)));

const numbers = (file, Type) => {
  const bytes = readFileSync(file);
  return new Type(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength));
};

/// `caster(corners, reach)` returns a function of origin and direction, whose answer is [triangle, factor], or nothing
/// where the ray meets none up to the factor `reach`.
export function answer(caster) {
  const [corners_file, rays_file, hits_file, reach] = process.argv.slice(2);
  const rays = numbers(rays_file, Float64Array);
  const cast = caster(numbers(corners_file, Float32Array), Number(reach));
  const hits = new Float64Array(rays.length / 3).fill(-1);
  for (let i = 0; 6 * i < rays.length; ++i)
    hits.set(cast(rays.subarray(6 * i, 6 * i + 3), rays.subarray(6 * i + 3, 6 * i + 6)) ?? [-1, -1], 2 * i);
  writeFileSync(hits_file, hits);
}
