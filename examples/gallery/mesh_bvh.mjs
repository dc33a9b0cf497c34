// Casts rays with three-mesh-bvh; mesh_bvh_render.py starts it. Files of numbers: corners (float32), rays (float64: an
// origin and a direction each), hits (float64: a triangle, or -1, and the factor of the direction).
import { readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';

const [corners_file, rays_file, hits_file] = process.argv.slice(2);
const load = createRequire(join(process.cwd(), 'node_modules', 'none.js'));
const { BufferAttribute, BufferGeometry, DoubleSide, Ray } = load('three');
const { MeshBVH } = load('three-mesh-bvh');

const numbers = (file, Type) => {
  const bytes = readFileSync(file);
  return new Type(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength));
};

const corners = numbers(corners_file, Float32Array);
const rays = numbers(rays_file, Float64Array);
const geometry = new BufferGeometry();
geometry.setAttribute('position', new BufferAttribute(corners, 3));
const bvh = new MeshBVH(geometry, { indirect: true });

const hits = new Float64Array(rays.length / 3).fill(-1);
const ray = new Ray();
for (let i = 0; 6 * i < rays.length; ++i) {
  ray.origin.fromArray(rays, 6 * i);
  ray.direction.fromArray(rays, 6 * i + 3);
  const hit = bvh.raycastFirst(ray, DoubleSide);
  if (!hit) continue;
  hits[2 * i] = hit.faceIndex;
  hits[2 * i + 1] = hit.distance / ray.direction.length();
}
writeFileSync(hits_file, hits);
